"""What is unusual about a gear that can be built: likely slips and poor practice, said but not refused."""

from __future__ import annotations

from collections.abc import Mapping

_WIDEST_FACE = 0.35  # of the cone distance; wider teeth carry no more load (ISO 23509, AGMA 2005)
_NOTABLE_SHIFT = 0.01
_THIN_TIP = 0.2  # modules: s_a ≥ 0.2 m for unhardened teeth, 0.4 m for hardened ones (Niemann/Winter, vol. 2)
_DEPTHS = (0.6, 1.4)  # an addendum in modules: stub teeth have 0.8, deep ones 1.2


def wide_face(face_width: float, cone_distance: float, unit: str) -> list[str]:
    """A bevel gear's face wider than is of use."""
    if face_width <= _WIDEST_FACE * cone_distance:
        return []
    given = f"face_width = {face_width:.4g} {unit} is {face_width / cone_distance:.2g} × the cone distance"
    return [f"{given}, {cone_distance:.4g} {unit}; more than {_WIDEST_FACE} × is seldom of use"]


def unusual_depth(name: str, depth: float, module: float, unit: str, addenda: int) -> list[str]:
    """A depth of so many addenda far from the usual: often a mix of millimetres and inches."""
    if _DEPTHS[0] * addenda <= depth / module <= _DEPTHS[1] * addenda:
        return []
    given = f"{name} = {depth:.4g} {unit} is {depth / module:.2g} modules of {module:.4g} {unit}"
    return [f"{given}; about {addenda} is usual; are all lengths in {unit}?"]


def undercut(teeth: int, shift: float, least_shift: float) -> list[str]:
    """Teeth that the rack that cuts them undercuts, by more than a hundredth of a module of shift would mend."""
    if shift >= least_shift - _NOTABLE_SHIFT:
        return []
    return [f"{teeth} teeth are undercut at their roots; a profile shift of {least_shift:.3g} or more would avoid it"]


def undercut_by_crown(teeth: int) -> list[str]:
    """Bevel teeth that the crown gear that generates them undercuts."""
    ways = "more teeth, a larger pressure angle, a smaller dedendum or a positive profile shift would avoid it"
    return [f"{teeth} teeth are undercut at their roots; {ways}"]


def thin_tip(thickness: float, module: float, unit: str) -> list[str]:
    """Tips so thin that hardening would burn them."""
    if thickness >= _THIN_TIP * module:
        return []
    return [
        f"the tips are {thickness:.3g} {unit} thick, {thickness / module:.2g} modules; from {_THIN_TIP} on is usual"
    ]


def low_contact_ratio(ratio: float, overlap: float = 0.0) -> list[str]:
    """Teeth that leave each other before the next ones meet."""
    if ratio >= 1.0 or ratio + overlap >= 1.2:
        return []
    return [f"the transverse contact ratio is {ratio:.3g}: below 1 only the overlap of spiral teeth keeps contact"]


def other_unit(source: str, stated: str | None, length_unit: str) -> list[str]:
    """A drawing in another unit than the part's: its numbers were taken as they are."""
    if stated is None or stated == length_unit:
        return []
    return [f"{source} states {stated}, but its numbers were taken as {length_unit}; is length_unit right?"]


def passed_over(things: Mapping[str, int]) -> list[str]:
    """What a drawing holds that is no outline."""
    if not things:
        return []
    return ["passed over in the drawing: " + ", ".join(f"{count} {name}" for name, count in things.items())]

"""Why parameters that have no gear are refused, in words that several elements share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from ..parameters import rounded_down, rounded_up

ONE_PITCH = "give one of module (mm) and diametral_pitch (per inch)"

NO_PROFILE = "it has no plane section, which is what is drawn; `picture` shows it, and `save` writes its polyhedron"


def pointed_tooth(limit: float, unit: str, diameter: float | None = None) -> str:
    """The addendum at which the flanks meet, at a tip diameter, is exceeded."""
    tip = "" if diameter is None else f", a tip diameter less than {rounded_down(diameter)} {unit}"
    return (
        f"the tooth comes to a point before its tip; less than {rounded_down(limit)} {unit}{tip} "
        "(a smaller pressure angle or a thicker tooth allows more)"
    )


def meeting_teeth(limit: float, unit: str) -> str:
    """The thickness at which neighbouring flanks meet is exceeded."""
    if limit <= 0.0:
        return "neighbouring teeth meet above the root, however thin; take a smaller pressure angle or dedendum"
    return f"neighbouring teeth meet above the root; less than {rounded_down(limit)} {unit}, usually half the pitch"


def no_tooth_left(limit: float, unit: str) -> str:
    """Backlash takes the whole tooth."""
    return f"leaves no tooth; less than {rounded_down(limit)} {unit}"


def bore_in_roots(diameter: str, limit: float, unit: str) -> str:
    """The bore reaches the root diameter."""
    return f"cuts into the tooth roots; less than the {diameter}, {rounded_down(limit)} {unit}"


def keyway_in_roots(corners: float, limit: float, unit: str) -> str:
    """The corners of the keyway's floor reach the root diameter."""
    return (
        f"its corners, on a circle of {corners:.4g} {unit}, cut into the tooth roots; they must stay within the "
        f"root diameter, {rounded_down(limit)} {unit}: take a smaller bore or a shallower keyway"
    )


def wide_face(cone_distance: float, unit: str) -> str:
    """A bevel gear's face reaches the apex."""
    return (
        f"more than the cone distance, {rounded_down(cone_distance)} {unit}; 0.3 × cone distance "
        f"({0.3 * cone_distance:.3g} {unit}) is usual, 0.35 × the most"
    )


def lost_hole(limit: float, unit: str) -> str:
    """A hole is lost in the rounding of what is around it."""
    least = f"at least {rounded_up(limit)} {unit}"
    return f"lost in the rounding of the sizes around it; {least}, and is it in the right unit?"


def in_roots(what: str, limit: float, unit: str) -> str:
    """A part of the blank reaches the root diameter."""
    return f"the {what} reaches the tooth roots; less than the root diameter, {rounded_down(limit)} {unit}"


def no_wall(inside: Literal["bore", "keyway"], limit: float, unit: str) -> str:
    """The hub is no larger than its bore, or than the circle around it and its keyway."""
    around = "the bore" if inside == "bore" else "the circle around bore and keyway"
    return f"leaves no wall around the {inside}; more than {around}, {rounded_up(limit)} {unit}"


def no_web(inside: str, limit: float, unit: str) -> str:
    """The rim's inner diameter is no larger than what is inside the web."""
    return f"leaves no web; more than {inside}, {rounded_up(limit)} {unit}"


def no_involute(what: str) -> str:
    """The involute would begin above the pitch line."""
    return f"leaves no involute below the pitch {what}; a larger one does"


def nearly_cylindrical(angle: float) -> str:
    """A pitch angle (radians) too small for a cone."""
    return f"makes a pitch cone of {np.degrees(angle):.2g}°, less than 0.01°: a spur gear, and to be built as one"


def internal_bevel(angle: float) -> str:
    """A pitch angle (radians) beyond 90°."""
    return (
        f"makes a pitch cone of {np.degrees(angle):.4g}°, an internal bevel gear, which no cutter makes; "
        "take a smaller shaft angle, or teeth numbers closer to each other"
    )


TRANSFORM_WITH_TWIST = "takes the place of twist, scale and skew; leave those out, or write them into it"

TWIST_ALONG = "at most 18000° along a path, 50 turns, can be computed; sweep the path in parts"


def one_way(given: Sequence[str]) -> str:
    """For a sweep that is moved in none or several of its ways."""
    ways = "length (straight along z), path (along a curve in space) or angle (about the section's y axis)"
    if not given:
        return f"how the section moves is not said; give one of {ways}"
    return f"not together with {' and '.join(given[1:])}; give only one of {ways}"


def not_of_this_way(way: str, owners: Sequence[str]) -> str:
    """For what does not apply to a sweep moved in this way."""
    return f"does not apply to a sweep with {way}, but to one with {' or '.join(owners)}; leave it out"


NO_DRAWING = "applies to a section from a drawing; this one is given by a table"

ONE_MODULE = "give one of module (mm, normal section), transverse_module (mm) and diametral_pitch (per inch, normal)"

NO_FILLET = 'rounds fillets; root = "radial" has none. Leave it out, or choose root = "fillet"'

STEEP_FILLET = (
    "is so large that the rack's tip would not leave a fillet that rises from the root; take a smaller one, a smaller"
    ' rack tip radius, or root = "radial"'
)

FILLET_TO_THE_TIP = "leaves no involute between fillet and tip; a smaller one does, and so does a larger dedendum"


def said_twice(others: Sequence[str]) -> str:
    """For one of several ways to say the same."""
    return f"says the same as {' and '.join(others)}; give only one of them"


def pointed_rack(limit: float, unit: str) -> str:
    """The generating rack comes to a point above its tip."""
    return (
        f"the rack that would cut these teeth comes to a point before its tip; less than {rounded_down(limit)} {unit} "
        "(a smaller pressure angle or a thinner tooth allows more)"
    )


def wide_rack_tip(limit: float, module: float, unit: str) -> str:
    """A rack tip radius that leaves no land."""
    most = f"{rounded_down(limit)} {unit}, {rounded_down(limit / module)} modules"
    return f"does not fit on the rack's tip; at most {most}, which make it round all over"


def undercut_through(what: str, teeth: int) -> str:
    """Undercut that leaves no tooth."""
    return (
        f"{teeth} teeth are undercut until nothing is left of the flank at {what}; more teeth, a larger profile shift, "
        "a smaller dedendum or a larger pressure angle leave some"
    )


def tip_below_base(limit: float, unit: str) -> str:
    """An internal tooth that reaches below the base circle."""
    return (
        f"the tips reach below the base circle, where there is no involute; at most {rounded_down(limit)} {unit} "
        "(more teeth, a larger pressure angle or a negative profile shift allow more)"
    )


def pointed_space(limit: float, unit: str) -> str:
    """The flanks of an internal gear's space meet above its root."""
    return f"the flanks of a space meet before the root circle; less than {rounded_down(limit)} {unit}"


def wide_fillet(limit: float, unit: str) -> str:
    """A fillet that does not fit into a space."""
    if limit <= 0.0:
        return "no fillet fits; the flanks of a space meet at the root circle"
    return f"does not fit into a space; at most {rounded_down(limit)} {unit}"


def pins_that_do_not_touch(usual: float, unit: str) -> str:
    """Pins that cannot measure."""
    return (
        f"such pins do not touch unrelieved involutes, stand on the roots or do not stand out beyond the tips; "
        f"{usual:.4g} {unit} is usual "
        "(1.728 modules outside, 1.68 inside)"
    )


def impossible_span(possible: Sequence[int], least_width: float, width: float, unit: str) -> str:
    """A number of teeth whose span touches no flank, or needs a wider face than there is."""
    if not possible:
        return "no span touches flanks of this width between form and tip circle"
    said = str(possible[0]) if len(possible) == 1 else f"{possible[0]} to {possible[-1]}"
    if least_width >= width:
        face = f"a face of more than {rounded_up(least_width)} {unit}"
        return (
            f"the span over so many helical teeth needs {face}, and they run for {width:.4g} {unit}; {said} is possible"
        )
    return f"planes over so many teeth do not touch the flanks between form and tip circle; {said} is possible"


def thin_ring(limit: float, unit: str) -> str:
    """An internal gear's ring that ends at its roots."""
    return f"leaves no ring outside the roots; greater than the root diameter, {limit:.4g} {unit}"


NO_ROOM_INSIDE = "an internal gear must have more teeth than its pinion, which is named first"

UNLIKE_HALVES = "the halves of herringbone teeth meet at mid-face, so both members need the same; give one value"


def no_second(kind: str) -> str:
    """For a second value, of a parameter that only the pinion has."""
    mate = "an internal gear" if kind == "internal" else f"a {kind}"
    return f"{mate} has none; give one value, the pinion's"


def no_distance(limit: float, *, internal: bool) -> str:
    """Profile shifts so far out that the flanks would meet below the base circles."""
    words = f"less than {np.floor(limit * 1e4) / 1e4:g}" if internal else f"more than {np.ceil(limit * 1e4) / 1e4:g}"
    return f"there is no centre distance at which teeth of such profile shifts run; their sum must be {words}"


def near_axes(limit: float, unit: str) -> str:
    """Axes without a line of action between the base circles."""
    return f"the axes are too near for involutes to meet; more than {rounded_up(limit, 6)} {unit}"


def far_shift(shift: float, of: str, reference: float, unit: str) -> str:
    """A centre distance far from what teeth numbers and module make."""
    return (
        f"would take a profile shift of {shift:.3g} modules of {of}; without any the distance is {reference:.6g} "
        f"{unit} (other teeth numbers or another module suit it better)"
    )


def jammed(excess: float, free: str, unit: str) -> str:
    """Teeth thicker than the pitch has room for."""
    way = f"a distance of {free} {unit}, or thinner teeth, give them room" if free else "make the teeth thinner"
    return f"the two teeth are together {excess:.4g} {unit} thicker than the pitch on the working circles; {way}"


def out_of_reach(distance: float, reference: float, unit: str) -> str:
    """Involutes that do not meet at all; without profile shift they would at a reference distance."""
    way = "farther apart" if distance < reference else "nearer, or have longer teeth"
    return (
        f"at {distance:.6g} {unit} the involutes do not meet; the members must come {way} (without profile shift they "
        f"run at {reference:.6g} {unit})"
    )


def no_clearance(tips: str, roots: str, depth: float, unit: str) -> str:
    """Tips that reach the mate's roots."""
    return (
        f"the {tips}'s tips reach the {roots}'s roots, {depth:.4g} {unit} beyond; a shorter addendum, a larger "
        "dedendum of the mate or full tip shortening leaves clearance"
    )


def cutting_tips(tips: str, teeth: str, depth: str, unit: str, *, internal: bool) -> str:
    """Interference: tips that cut into the mate's teeth away from the path of contact."""
    ways = "more teeth, a shorter addendum, a profile shift or a larger pressure angle"
    inside = ", and in an internal pair a larger difference of the teeth numbers," if internal else ""
    return f"interference: the {tips}'s tips would cut {depth} {unit} into the {teeth}'s teeth; {ways}{inside} avoid it"

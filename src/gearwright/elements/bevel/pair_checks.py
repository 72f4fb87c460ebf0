"""What is wrong with two bevel gears in mesh."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...parameters import Problems, declarations, rounded_down, rounded_up
from .. import refusals
from .meshing import interference_limit
from .pitch_cone import require_cone
from .sizing import giving_depths, require_standard
from .spiral import MILLED
from .tip_paths import cut_depth

if TYPE_CHECKING:
    from .bevel_pair import BevelPair

_OF_THE_CONES = ("teeth", "module", "diametral_pitch", "shaft_angle", "length_unit")
_NAMES = ("pinion", "gear")
_MORE_PLAY = 2.2  # a depth on one of two flanks, and a little: it is told to two digits
_OF_THE_SIZES = (
    *("face_width", "standard", "taper", "iso_method", "profile_shift", "thickness_modification"),
    *("working_depth", "whole_depth", "gear_addendum", "pressure_angle", "spiral_angle"),
)
_CUT = 1e-7  # radians on the sphere: far above rounding, far below any gear's accuracy


def check_pair(problems: Problems, pair: BevelPair) -> bool:
    """Whether the members can be sized; adds what keeps them from it."""
    if not (problems.computable(*_OF_THE_CONES) and problems.sound("module")):
        return False
    require_cone(problems, *pair.pitch_cone_angles)
    require_standard(problems, pair.standard, pair.spiral_angle, pair.taper)
    names = [one.name for one in declarations(type(pair))]
    if not problems.sound("shaft_angle") or not problems.computable(*names):
        return False
    if pair.taper in ("duplex", "tilted") and pair.trace in MILLED and pair.cutter_radius is None:
        return False  # these tapers follow from the cutter
    if pair.face_width >= pair.cone_distance:
        problems.add("face_width", refusals.wide_face(pair.cone_distance, pair.length_unit))
    if pair.standard == "explicit":
        _check_depths(problems, pair)
    return problems.sound(*_OF_THE_SIZES)


def _check_depths(problems: Problems, pair: BevelPair) -> None:
    unit = pair.length_unit
    if pair.outer_whole_depth <= pair.outer_working_depth:
        problems.add(
            "whole_depth",
            f"must be greater than the working depth, {rounded_up(pair.outer_working_depth)} {unit}; "
            "their difference is the clearance at the root",
        )
    if pair.explicit_gear_addendum >= pair.outer_working_depth:
        problems.add(
            "gear_addendum",
            f"less than the working depth, {rounded_down(pair.outer_working_depth)} {unit}; "
            "the rest is the pinion's addendum",
        )


def given_by(pair: BevelPair) -> dict[str, dict[str, str]]:
    """By a member's parameter and the member's name: the pair's own parameter that it follows from."""
    if pair.standard == "explicit":
        addenda, depths = ("working_depth", "gear_addendum"), ("whole_depth", "whole_depth")
    else:
        addenda = depths = (giving_depths(pair), giving_depths(pair))
    of_addenda, of_depths = (dict(zip(_NAMES, names, strict=True)) for names in (addenda, depths))
    return {
        "addendum": of_addenda,
        "addendum_angle": of_addenda,
        "dedendum": of_depths,
        "dedendum_angle": of_depths,
    }


def check_engagement(problems: Problems, pair: BevelPair) -> None:
    """Tips must run clear of the mate's roots, and both teeth fit into the pitch."""
    pitch = np.pi * pair.outer_module
    thickness = pair.pinion.outer_thickness + pair.gear.outer_thickness
    if thickness > pitch * (1.0 + 1e-12):
        problems.add(
            "circular_thickness",
            f"interference: the two teeth are together {thickness:.4g} {pair.length_unit} thick and share a pitch of "
            f"{pitch:.4g} {pair.length_unit}; make them thinner",
        )
        return
    for member in (0, 1):
        message = _interference(pair, member)
        if message:
            problems.add(_own_name(pair, member), message)


def _own_name(pair: BevelPair, member: int) -> str:
    """The parameter that keeps a member's tips away: what gives it its addendum, or the play where forms differ."""
    if pair.pinion.tooth_form != pair.gear.tooth_form:
        return "backlash" if pair.normal_backlash is None else "normal_backlash"
    return given_by(pair)["addendum"][_NAMES[member]]


def _interference(pair: BevelPair, member: int) -> str | None:
    """Why the tips of one member interfere with the roots of the other, at the end where they first do."""
    pinion = pair.pinion
    distances = [pinion.cone_distance]
    if any(gear.bevel_teeth.varies for gear in (pinion, pair.gear)):
        distances += [pinion.mean_distance, pinion.inner_distance]
    places = {r: pair.teeth_on_sphere(r) for r in distances}
    if (pair.pinion, pair.gear)[1 - member].root != "fillet":
        limits = {r: interference_limit(teeth[member], teeth[1 - member]) for r, teeth in places.items()}
        if any(places[r][member].face_angle > limit + 1e-12 for r, limit in limits.items()):
            return _beyond_the_form(pair, member, limits)
    for distance, teeth in places.items():
        depth = cut_depth(teeth[1 - member], teeth[member], float(np.radians(pair.shaft_angle))) * distance
        if depth > _CUT * distance:
            return _cutting(pair, member, depth, pair.cone_distance / distance)
    return None


def _beyond_the_form(pair: BevelPair, member: int, limits: dict[float, float]) -> str:
    """Limits of the polar angle by the spheres' radii, as the outer addendum whose tip line keeps to all of them."""
    gear, unit, name = (pair.pinion, pair.gear)[member], pair.length_unit, _NAMES[member]
    tips = gear.bevel_teeth.tips
    over = {distance: limit - gear.pitch_cone_angle for distance, limit in limits.items()}
    most = pair.cone_distance * np.tan(over[pair.cone_distance])
    if tips.offset:
        most = min(r * np.sin(up) + tips.height - tips.height_at(r * np.cos(up)) for r, up in over.items())
    return (
        f"interference: the {name}'s tip, {gear.proportions.addendum:.4g} {unit} above its pitch cone,"
        f" would meet its mate below the base cone; at most {rounded_down(most)} {unit} for that addendum "
        "(more teeth or a larger pressure angle allow more)"
    )


def _cutting(pair: BevelPair, member: int, depth: float, outward: float) -> str:
    """Tips cut to a depth on a sphere, so many times nearer to the apex than the outer end."""
    unit, name, mate = pair.length_unit, _NAMES[member], _NAMES[1 - member]
    if pair.pinion.tooth_form != pair.gear.tooth_form:
        more = f"{_MORE_PLAY * depth * outward:.2g} {unit} more on the outer pitch circle"
        return (
            f"interference: flanks of two forms do not fit into each other: the {name}'s cut {depth:.3g} {unit} into"
            f" the {mate}'s; {more} keep them apart, or teeth of one form"
        )
    has_fillet = (pair.pinion, pair.gear)[1 - member].root == "fillet"
    rounder = f" a smaller crown tip radius of the {mate}" if has_fillet else ""
    return (
        f"interference: the {name}'s tips cut {depth:.3g} {unit} into the {mate}'s roots; a smaller addendum,{rounder}"
        " or a larger clearance keeps them apart"
    )

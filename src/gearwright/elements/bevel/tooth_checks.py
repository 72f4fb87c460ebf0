"""Which numbers make a bevel gear's tooth, and in which words others are refused."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...errors import GeometryError
from ...parameters import rounded_down
from .. import refusals
from .teeth import BevelTeeth
from .tooth import BevelTooth

_NO_LAND = 1e-6  # relative: where teeth vary, a land that vanishes at one end only makes them unlike

Found = Iterator[tuple[str, str, float]]
"""Name of a parameter, what is wrong with it, and the limit that is told: of several the least must be kept."""

_NONE = float("inf")

_POINTED_CROWN = (
    "the crown gear that would cut these teeth comes to a point before its tip; a smaller dedendum, a smaller pressure"
    ' angle or a thinner tooth keeps a land, and root = "radial" needs none'
)
_ENDING_CROWN = (
    "the flanks of the crown gear that would cut these roots end before its tip; a smaller dedendum, a larger pressure"
    ' angle, tooth_form = "octoid" or root = "radial" has roots'
)
_STEEP_FILLET = (
    "is so large that the crown gear's tip would not leave a fillet that rises from the root; take a smaller one, a"
    ' smaller crown tip radius, or root = "radial"'
)
_UNDERCUT_THROUGH = (
    "these teeth are undercut until nothing is left of them; more teeth, a smaller dedendum or a larger pressure angle"
    " leave some"
)
_NO_FLANK = (
    "leaves no flank above the root, as low as the tips are here; a smaller addendum_angle or a narrower face does"
)
_PASSING_ROOTS = (
    "the roots pass the inner ends of the flanks partway along the face; a smaller or a larger dedendum, another depth"
    ' taper or root = "fillet" keeps the teeth of one kind from end to end'
)
_BEGINNING_UNDERCUT = (
    "undercut begins partway along the face; a depth that goes with the cone distance, a smaller dedendum, a larger"
    ' pressure angle or root = "radial" keeps the teeth of one kind from end to end'
)
_UNEVEN = (
    "the teeth cannot be followed from end to end; a depth that goes with the cone distance, a smaller dedendum, a"
    " smaller crown tip radius or a narrower face gives others"
)


def tooth_problems(teeth: BevelTeeth, nominal_thickness: float, unit: str) -> list[tuple[str, str]]:
    """Names of parameters and what is wrong with them, each once; limits are for the outer end.

    nominal_thickness   circular, on the outer pitch circle, before backlash
    """
    if teeth.thickness <= 0.0:
        return [("backlash", refusals.no_tooth_left(2.0 * nominal_thickness, unit))]
    found: dict[str, tuple[float, str]] = {}
    for place, tooth in teeth.looked_at.items():
        where = "" if place == "outer" else f" (at the {place} end)" if place == "inner" else " (at mid-face)"
        distance = teeth.ends.pitch_distance(teeth.level(place))
        for name, message, limit in _of_one(teeth, tooth, distance, nominal_thickness, unit):
            if name not in found or limit < found[name][0]:
                found[name] = limit, message + where
    return [(name, message) for name, (_, message) in found.items()] or list(_on_the_way(teeth))


def _on_the_way(teeth: BevelTeeth) -> Iterator[tuple[str, str]]:
    """What changes between the ends, of teeth that are sound where they were looked at."""
    try:
        _ = teeth.outline
    except GeometryError:
        tooth = list(teeth.looked_at.values())
        if len({one.fillet is not None and one.fillet.undercuts for one in tooth}) > 1:
            yield "dedendum", _BEGINNING_UNDERCUT
        else:
            passing = teeth.tip_radius is None and len({one.root_angle < one.flank.least_polar for one in tooth}) > 1
            yield "dedendum", _PASSING_ROOTS if passing else _UNEVEN


def _of_one(teeth: BevelTeeth, tooth: BevelTooth, distance: float, nominal: float, unit: str) -> Found:
    if tooth.thickness <= 0.0:
        yield "crowning", f"leaves no tooth; less than {rounded_down(teeth.most_crowning)} {unit}", _NONE
        return
    if tooth.face_angle <= tooth.flank_start:
        yield "addendum", _NO_FLANK, _NONE
        return
    if tooth.flank_start >= teeth.pitch_angle:
        yield "pressure_angle", refusals.no_involute("cone"), _NONE
        return
    if tooth.face_angle >= tooth.pointed_angle:
        limit = _outer_height(teeth, tooth.pointed_angle, distance)
        yield "addendum", refusals.pointed_tooth(limit, unit), limit
        return
    yield from _roots(teeth, tooth, nominal, unit)
    if tooth.relief is not None:
        yield from _relief(teeth, tooth, unit)
    elif tooth.profile_crowning and tooth.tip_half <= 0.0:
        yield "profile_crowning", "leaves no land at the tip; a smaller one does", _NONE


def _outer_height(teeth: BevelTeeth, polar: float, distance: float) -> float:
    """The outer addendum with which the tips have a polar angle at a distance along the pitch line."""
    there = distance * float(np.tan(polar - teeth.pitch_angle))
    return there + teeth.tips.height - teeth.tips.height_at(distance)


def _roots(teeth: BevelTeeth, tooth: BevelTooth, nominal: float, unit: str) -> Found:
    if tooth.fillet is None:
        if tooth.root_space <= 0.0:
            limit = nominal + tooth.root_space * teeth.ends.outer * float(np.sin(teeth.pitch_angle))
            yield "circular_thickness", refusals.meeting_teeth(limit, unit), limit
        return
    tip = tooth.fillet.crown_tip
    if tip.largest_radius <= 0.0:
        yield "dedendum", _POINTED_CROWN, _NONE
    elif tip.radius > tip.largest_radius * (1.0 - _NO_LAND if teeth.varies else 1.0 + 1e-12):
        scale = teeth.tip_radius_scale(tooth.root_angle) * (1.0 - _NO_LAND if teeth.varies else 1.0)
        most = tip.largest_radius * scale
        makes = "leaves a land at the root from end to end" if teeth.varies else "makes roots round all over"
        fits = f"does not fit between two teeth; at most {rounded_down(most)} {unit}, which {makes}"
        yield "crown_tip_radius", fits, most
    elif not tip.reaches:
        yield "dedendum", _ENDING_CROWN, _NONE
    elif not tooth.fillet.regular:
        yield "dedendum", _STEEP_FILLET, _NONE
    elif tooth.fillet.waist <= 0.0 or tooth.form_angle >= tooth.face_angle:
        yield "dedendum", _UNDERCUT_THROUGH, _NONE


def _relief(teeth: BevelTeeth, tooth: BevelTooth, unit: str) -> Found:
    relief = tooth.relief
    if relief is None:
        return
    if relief.begin <= tooth.form_angle:
        most = teeth.tips.height * (tooth.face_angle - tooth.form_angle) / (tooth.face_angle - teeth.pitch_angle)
        yield "tip_relief_height", f"reaches below the flank; less than {rounded_down(most)} {unit}", most
        return
    try:
        half = tooth.tip_half
    except ValueError:
        yield "tip_relief", "the flank ends before the relieved tip; a smaller one does not need as much of it", _NONE
        return
    if half <= 0.0:
        yield "tip_relief", "leaves no land at the tip; a smaller one does", _NONE

"""Which numbers make a bevel gear's tooth, and in which words others are refused."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...parameters import rounded_down
from .. import refusals
from .teeth import BevelTeeth
from .tooth import BevelTooth

Found = Iterator[tuple[str, str]]

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


def tooth_problems(teeth: BevelTeeth, nominal_thickness: float, unit: str) -> list[tuple[str, str]]:
    """Names of parameters and what is wrong with them, each once; limits are for the outer end.

    nominal_thickness   circular, on the outer pitch circle, before backlash
    """
    if teeth.thickness <= 0.0:
        return [("backlash", refusals.no_tooth_left(2.0 * nominal_thickness, unit))]
    found: dict[str, str] = {}
    for place, tooth in teeth.looked_at.items():
        where = "" if place == "outer" else f" (at the {place} end)" if place == "inner" else " (at mid-face)"
        for name, message in _of_one(teeth, tooth, teeth.pitch_distance(teeth.level(place)), nominal_thickness, unit):
            found.setdefault(name, message + where)
    return list(found.items())


def _of_one(teeth: BevelTeeth, tooth: BevelTooth, distance: float, nominal: float, unit: str) -> Found:
    if tooth.thickness <= 0.0:
        yield "crowning", "leaves no tooth; a smaller one does"
        return
    if tooth.flank_start >= teeth.pitch_angle:
        yield "pressure_angle", refusals.no_involute("cone")
        return
    if tooth.face_angle >= tooth.pointed_angle:
        yield "addendum", refusals.pointed_tooth(_outer_height(teeth, tooth.pointed_angle, distance), unit)
        return
    yield from _roots(teeth, tooth, nominal, unit)
    if tooth.relief is not None:
        yield from _relief(teeth, tooth, unit)


def _outer_height(teeth: BevelTeeth, polar: float, distance: float) -> float:
    """The outer addendum with which the tips have a polar angle at a distance along the pitch line."""
    there = distance * float(np.tan(polar - teeth.pitch_angle))
    return there + teeth.tips.height - teeth.tips.height_at(distance)


def _roots(teeth: BevelTeeth, tooth: BevelTooth, nominal: float, unit: str) -> Found:
    if tooth.fillet is None:
        if tooth.root_space <= 0.0:
            limit = nominal + tooth.root_space * teeth.ends.outer * float(np.sin(teeth.pitch_angle))
            yield "circular_thickness", refusals.meeting_teeth(limit, unit)
        return
    tip = tooth.fillet.crown_tip
    if tip.largest_radius <= 0.0:
        yield "dedendum", _POINTED_CROWN
    elif tip.radius > tip.largest_radius * (1.0 + 1e-12) or (teeth.varies and tip.land <= 0.0):
        most = rounded_down(tip.largest_radius * teeth.tip_radius_scale(tooth.root_angle))
        yield (
            "crown_tip_radius",
            f"does not fit between two teeth; at most {most} {unit}, which makes roots round all over",
        )
    elif not tip.reaches:
        yield "dedendum", _ENDING_CROWN
    elif not tooth.fillet.regular:
        yield "dedendum", _STEEP_FILLET
    elif tooth.fillet.waist <= 0.0 or tooth.form_angle >= tooth.face_angle:
        yield "dedendum", _UNDERCUT_THROUGH


def _relief(teeth: BevelTeeth, tooth: BevelTooth, unit: str) -> Found:
    relief = tooth.relief
    if relief is None:
        return
    if relief.begin <= tooth.form_angle:
        most = teeth.tips.height * (tooth.face_angle - tooth.form_angle) / (tooth.face_angle - teeth.pitch_angle)
        yield "tip_relief_height", f"reaches below the flank; less than {rounded_down(most)} {unit}"
        return
    try:
        half = tooth.tip_half
    except ValueError:
        yield "tip_relief", "the flank ends before the relieved tip; a smaller one does not need as much of it"
        return
    if half <= 0.0:
        yield "tip_relief", "leaves no land at the tip; a smaller one does"

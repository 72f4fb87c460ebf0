"""The Gleason systems: long addenda for pinions, and tip cones parallel to the mate's root cones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....errors import ParameterError, Problem
from .design import BevelDesign
from .proportions import Pair, Proportions
from .thickness import thicknesses


@dataclass(frozen=True, kw_only=True)
class DepthTable:
    """Depths in outer transverse modules; the gear's addendum is `gear_addendum + gear_addendum_rise`/κ."""

    working_depth: float
    whole_depth: float
    gear_addendum: float
    gear_addendum_rise: float


STRAIGHT = DepthTable(working_depth=2.0, whole_depth=2.188, gear_addendum=0.54, gear_addendum_rise=0.46)
SPIRAL = DepthTable(working_depth=1.7, whole_depth=1.888, gear_addendum=0.46, gear_addendum_rise=0.39)


def gleason_straight(design: BevelDesign, *, thickness_modification: float = 0.0) -> Pair:
    """h_a2 = (0.54 + 0.46/κ) m, h_a1 = 2m − h_a2, h_f = 2.188m − h_a. For straight teeth. Raises ParameterError.

    thickness_modification   x_s: the first member's teeth are thicker by 2x_s modules. The system reads K = 2x_s from
                             a chart of equal strength; 0 leaves what the unlike addenda alone make.
    Source: KHK, Gear Technical Reference, straight bevel gears of the Gleason system.
    """
    if design.spiral_angle != 0.0:
        raise ParameterError(
            "gleason_straight",
            [Problem(f"spiral_angle = {design.spiral_angle:.6g}", "0 is needed; gleason_spiral has spiral teeth")],
        )
    return _sized(design, STRAIGHT, thickness_modification)


def gleason_spiral(design: BevelDesign, *, thickness_modification: float = 0.0) -> Pair:
    """h_a2 = (0.46 + 0.39/κ) m, h_a1 = 1.7m − h_a2, h_f = 1.888m − h_a. For spiral teeth. Raises ParameterError.

    thickness_modification   as in gleason_straight
    Source: KHK, Gear Technical Reference, spiral bevel gears of the Gleason system.
    """
    if design.spiral_angle == 0.0:
        raise ParameterError(
            "gleason_spiral",
            [Problem("spiral_angle = 0", "a positive one is needed, usually 35°; gleason_straight has teeth without")],
        )
    return _sized(design, SPIRAL, thickness_modification)


def _sized(design: BevelDesign, table: DepthTable, modification: float) -> Pair:
    """θ_f = atan(h_f/R_e), θ_a1 = θ_f2 and θ_a2 = θ_f1: the clearance is the same all along the face."""
    gear_addendum = table.gear_addendum + table.gear_addendum_rise * design.levelness
    modules = design.of_members(table.working_depth - gear_addendum, gear_addendum)
    addenda = [design.module * addendum for addendum in modules]
    dedenda = [design.module * table.whole_depth - addendum for addendum in addenda]
    angles = [float(np.arctan2(dedendum, design.cone_distance)) for dedendum in dedenda]
    widths = thicknesses(design, addenda[0] - addenda[1], modification)
    first, second = (
        Proportions(
            addendum=addenda[member],
            dedendum=dedenda[member],
            addendum_angle=angles[1 - member],
            dedendum_angle=angles[member],
            thickness=widths[member],
        )
        for member in (0, 1)
    )
    return first, second

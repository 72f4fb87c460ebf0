"""Sizing systems by the names that parameters have for them."""

from __future__ import annotations

from ...parameters import Problems
from ..standards.bevels.depth_data import DepthData, usual_depth_data
from ..standards.bevels.design import BevelDesign
from ..standards.bevels.equal_addendum import equal_addendum
from ..standards.bevels.gleason import gleason_spiral, gleason_straight
from ..standards.bevels.iso_23509 import iso_23509
from ..standards.bevels.proportions import Pair

EXPLICIT = ("explicit",)
SHIFTED = ("equal-addendum", "iso-23509")
"""Systems with a profile shift to choose; the others settle it themselves."""
SYSTEMS = ("equal-addendum", "gleason-straight", "gleason-spiral", "iso-23509")


def standard_proportions(
    standard: str, design: BevelDesign, *, profile_shift: float | None, thickness_modification: float
) -> Pair:
    """Proportions after a system, one of SYSTEMS. Raises ParameterError where it has none for this design.

    ISO 23509 without a profile shift takes the mean addendum factor it suggests, and standard taper: these
    teeth have root cones through the pitch apex.
    """
    match standard:
        case "equal-addendum":
            return equal_addendum(
                design, profile_shift=profile_shift or 0.0, thickness_modification=thickness_modification
            )
        case "gleason-straight":
            return gleason_straight(design, thickness_modification=thickness_modification)
        case "gleason-spiral":
            return gleason_spiral(design, thickness_modification=thickness_modification)
        case _:
            shift = usual_depth_data(design).profile_shift if profile_shift is None else profile_shift
            depths = DepthData(profile_shift=shift, thickness_modification=thickness_modification)
            return iso_23509(design, taper="standard", depths=depths)


def require_standard(problems: Problems, standard: str, spiral_angle: float) -> None:
    """Adds a problem where teeth are straight and the system is for spiral ones, or the other way round."""
    if standard == "gleason-straight" and spiral_angle != 0.0:
        problems.add("standard", 'is for teeth without spiral angle; "gleason-spiral" is for those with one')
    if standard == "gleason-spiral" and spiral_angle == 0.0:
        problems.add("standard", 'is for teeth with a spiral angle, usually 35°; "gleason-straight" for those without')


def unbuilt_taper(standard: str, proportions: Pair, built: tuple[float, float]) -> list[str]:
    """A remark where the system's tip cones do not have the addendum angles (radians) that are built."""
    if all(abs(one.addendum_angle - angle) < 1e-9 for one, angle in zip(proportions, built, strict=True)):
        return []
    cones = f'standard = "{standard}" has tip cones parallel to the mates\' roots'
    return [f"{cones}; these teeth have its outer sizes and taper to the pitch apex, and so does their clearance"]

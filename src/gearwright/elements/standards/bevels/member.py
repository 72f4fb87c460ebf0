"""One bevel gear in numbers: what was given, what a sizing system settled, and how it changes along the face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .design import BevelDesign
from .proportions import Pair, Proportions


@dataclass(frozen=True, kw_only=True)
class BevelMember:
    """One member. Lengths in the length unit; angles in radians.

    teeth            z
    module           m_et, transverse, at the outer end
    pitch_angle      δ, at most a right angle
    face_width       b
    pressure_angle   α_n, in the normal section
    spiral_angle     β_m, at the middle of the face
    proportions      of its teeth at the outer end
    """

    teeth: int
    module: float
    pitch_angle: float
    face_width: float
    pressure_angle: float
    spiral_angle: float
    proportions: Proportions

    @property
    def pitch_diameter(self) -> float:
        """d_e, outer."""
        return self.teeth * self.module

    @property
    def cone_distance(self) -> float:
        """R_e."""
        return float(self.pitch_diameter / (2.0 * np.sin(self.pitch_angle)))

    @property
    def mean_cone_distance(self) -> float:
        """R_m."""
        return self.cone_distance - self.face_width / 2.0

    @property
    def mean_ratio(self) -> float:
        """R_m/R_e, of diameters, modules and thicknesses in the middle of the face to those at its outer end."""
        return self.mean_cone_distance / self.cone_distance

    @property
    def mean_normal_module(self) -> float:
        """m_mn."""
        return float(self.module * self.mean_ratio * np.cos(self.spiral_angle))

    @property
    def mean_normal_thickness(self) -> float:
        """s_mn = s_e cos β_m R_m/R_e."""
        return float(self.proportions.thickness * self.mean_ratio * np.cos(self.spiral_angle))

    @property
    def transverse_pressure_angle(self) -> float:
        """α_t, tan α_t = tan α_n/cos β_m."""
        return float(np.arctan(np.tan(self.pressure_angle) / np.cos(self.spiral_angle)))

    @property
    def back_curvature(self) -> float:
        """cos δ: outer pitch radius over that of the virtual cylindrical gear; 0 of a crown gear, whose is a rack."""
        return max(0.0, float(np.cos(self.pitch_angle)))

    @property
    def face_angle(self) -> float:
        """δ_a of the tip cone."""
        return self.pitch_angle + self.proportions.addendum_angle

    @property
    def root_angle(self) -> float:
        """δ_f of the root cone."""
        return self.pitch_angle - self.proportions.dedendum_angle

    def addendum(self, inwards: float) -> float:
        """Addendum so far inwards from the outer end, along the pitch cone."""
        return float(self.proportions.addendum - inwards * np.tan(self.proportions.addendum_angle))

    def dedendum(self, inwards: float) -> float:
        """Dedendum so far inwards from the outer end, along the pitch cone."""
        return float(self.proportions.dedendum - inwards * np.tan(self.proportions.dedendum_angle))


def bevel_members(design: BevelDesign, proportions: Pair) -> tuple[BevelMember, BevelMember]:
    """The members of a pair, in the order in which they are named."""
    first, second = (
        BevelMember(
            teeth=design.teeth[member],
            module=design.module,
            pitch_angle=design.pitch_angles[member],
            face_width=design.face_width,
            pressure_angle=design.pressure_angle,
            spiral_angle=design.spiral_angle,
            proportions=proportions[member],
        )
        for member in (0, 1)
    )
    return first, second

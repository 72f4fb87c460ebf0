"""What is given of a bevel gear pair before a sizing system settles the rest."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ....errors import ParameterError, Problem
from ... import refusals
from ...bevel.pitch_cone import pitch_cone_angle

_RIGHT_ANGLE = np.pi / 2.0


@dataclass(frozen=True, kw_only=True)
class BevelDesign:
    """A pair on intersecting axes. Lengths in the length unit; angles in radians. Raises ParameterError.

    teeth            z₁, z₂
    module           m_et, transverse, at the outer end
    shaft_angle      Σ, in (0, π)
    face_width       b, less than the outer cone distance
    pressure_angle   α_n, in the normal section
    spiral_angle     β_m, at the middle of the face; 0 of straight teeth
    cutter_radius    r_c0, of curved teeth; None of straight ones, or where nothing depends on it
    blade_groups     z₀ of a face hobbing cutter, which cuts without stopping; None of tooth by tooth cutting
    """

    teeth: tuple[int, int]
    module: float
    shaft_angle: float
    face_width: float
    pressure_angle: float
    spiral_angle: float = 0.0
    cutter_radius: float | None = None
    blade_groups: int | None = None

    def __post_init__(self) -> None:
        problems = list(self._single_problems()) or self._joint_problems()
        if problems:
            raise ParameterError("BevelDesign", problems)

    def _single_problems(self) -> list[Problem]:
        """What is wrong with one value alone."""
        within = {
            "teeth": (min(self.teeth) >= 1, "two positive numbers"),
            "module": (0.0 < self.module < np.inf, "a positive length"),
            "face_width": (0.0 < self.face_width < np.inf, "a positive length"),
            "shaft_angle": (0.0 < self.shaft_angle < np.pi, "radians between 0 and π; 1.5708 is a right angle"),
            "pressure_angle": (0.0 < self.pressure_angle < _RIGHT_ANGLE, "radians between 0 and π/2; 0.34907 is 20°"),
            "spiral_angle": (0.0 <= self.spiral_angle < _RIGHT_ANGLE, "radians from 0 to below π/2; 0.61087 is 35°"),
            "cutter_radius": (self.cutter_radius is None or 0.0 < self.cutter_radius < np.inf, "a positive length"),
            "blade_groups": (self.blade_groups is None or self.blade_groups >= 1, "a positive number"),
        }
        return [
            Problem(f"{name} = {getattr(self, name)}", f"{accepted} needed; are angles in degrees?")
            if name.endswith("angle")
            else Problem(f"{name} = {getattr(self, name)}", f"{accepted} needed")
            for name, (good, accepted) in within.items()
            if not good
        ]

    def _joint_problems(self) -> list[Problem]:
        """What is wrong with values together."""
        steepest = max(self.pitch_angles)
        if steepest > _RIGHT_ANGLE + 1e-12:
            return [Problem(f"shaft_angle = {self.shaft_angle:.6g}", refusals.internal_bevel(steepest))]
        if self.face_width >= self.cone_distance:
            most = f"less than the cone distance, {self.cone_distance:.6g}; 0.3 of it is usual"
            return [Problem(f"face_width = {self.face_width:.6g}", most)]
        return []

    @cached_property
    def pitch_angles(self) -> tuple[float, float]:
        """δ₁, δ₂."""
        z1, z2 = self.teeth
        return pitch_cone_angle(z1, z2, self.shaft_angle), pitch_cone_angle(z2, z1, self.shaft_angle)

    @property
    def cone_distance(self) -> float:
        """R_e = m_et z/(2 sin δ), of both members."""
        return float(self.module * self.teeth[0] / (2.0 * np.sin(self.pitch_angles[0])))

    @property
    def mean_cone_distance(self) -> float:
        """R_m, to the middle of the face."""
        return self.cone_distance - self.face_width / 2.0

    @property
    def mean_normal_module(self) -> float:
        """m_mn = m_et cos β_m R_m/R_e."""
        return float(self.module * np.cos(self.spiral_angle) * self.mean_cone_distance / self.cone_distance)

    @property
    def transverse_pressure_angle(self) -> float:
        """α_t, tan α_t = tan α_n/cos β_m."""
        return float(np.arctan(np.tan(self.pressure_angle) / np.cos(self.spiral_angle)))

    @property
    def first_is_pinion(self) -> bool:
        """Whether the first member has no more teeth than the second."""
        return self.teeth[0] <= self.teeth[1]

    @cached_property
    def levelness(self) -> float:
        """1/κ = z₁ cos δ₂/(z₂ cos δ₁) of pinion 1 and gear 2: 1 of equal members, 0 of a crown gear.

        It is 1/u² on axes at right angles. The pinion is the member with fewer teeth, whichever is named first.
        """
        angles, teeth = self.pitch_angles, self.teeth
        pinion, gear = (0, 1) if self.first_is_pinion else (1, 0)
        flat = max(0.0, float(np.cos(angles[gear])))
        return float(teeth[pinion] * flat / (teeth[gear] * np.cos(angles[pinion])))

    def of_members(self, pinion: float, gear: float) -> tuple[float, float]:
        """What belongs to pinion and gear, in the order in which the members are named."""
        return (pinion, gear) if self.first_is_pinion else (gear, pinion)

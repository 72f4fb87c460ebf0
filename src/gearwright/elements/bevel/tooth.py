"""The tooth of a bevel gear on the unit sphere, and the spherical section it makes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...curves.curve import Curve, mapped, turn
from ...curves.meridian import Meridian
from ...curves.parallel import Parallel
from ...curves.spherical_involute import (
    SphericalInvolute,
    azimuth,
    polar_angle,
    roll_at_azimuth,
    roll_at_polar_angle,
)
from ...sections.loop import Loop
from ...sections.sphere import SphericalSection
from ..gear_loop import NEXT_TO_NOTHING, gear_loop


@dataclass(frozen=True, kw_only=True)
class BevelTooth:
    """A spherical-involute tooth, centred on azimuth 0, one of `teeth` about +z. Angles in radians.

    base_cone_angle     γ_b, sin γ_b = sin γ cos a (eq. G2)
    pitch_angle         γ
    face_angle, root_angle   polar angles of the tip and the root arc
    thickness           angular thickness θ_p of the tooth at the pitch cone, about z

    Below the base cone the flank carries on as a meridian (root="radial").
    Source: Al-Daccak 1989, eqs. (3.15)–(3.19); there ψ_p is taken at φ = pressure angle, which is the
    angle at the point, not at the pole: it thins the tooth. Here ψ_p is the azimuth at the pitch cone.
    """

    teeth: int
    base_cone_angle: float
    pitch_angle: float
    face_angle: float
    root_angle: float
    thickness: float

    @cached_property
    def pitch_azimuth(self) -> float:
        """ψ_p, azimuth of the involute at the pitch cone from its cusp."""
        return float(self._azimuth(self.pitch_angle))

    def _azimuth(self, polar: float) -> float:
        return float(azimuth(roll_at_polar_angle(polar, self.base_cone_angle), self.base_cone_angle))

    @property
    def flank_start(self) -> float:
        """Polar angle at which the involute begins: the base cone, or the root cone above it."""
        return max(self.root_angle, self.base_cone_angle)

    def thickness_at(self, polar: float) -> float:
        """Angular thickness θ = θ_p − 2(ψ(δ) − ψ_p) at a polar angle on the involute."""
        return self.thickness - 2.0 * (self._azimuth(polar) - self.pitch_azimuth)

    @cached_property
    def pointed_angle(self) -> float:
        """Polar angle at which the flanks meet; where the involute ends first, π − γ_b."""
        meeting = self.pitch_azimuth + self.thickness / 2.0
        end = np.pi - self.base_cone_angle
        if meeting >= self._azimuth(end):
            return end
        return float(polar_angle(roll_at_azimuth(meeting, self.base_cone_angle), self.base_cone_angle))

    @property
    def root_space(self) -> float:
        """Angular width of the tooth space at the foot of the involute."""
        return 2.0 * np.pi / self.teeth - self.thickness_at(self.flank_start)

    def section(self, hub_angle: float | None = None) -> SphericalSection:
        """The gear's section: all teeth, full to the axis, or to a circular hole of a polar angle."""
        tip = self.thickness_at(self.face_angle) / 2.0
        foot = self.thickness_at(self.flank_start) / 2.0
        outline = gear_loop(
            rising=self._rising_flank(),
            tip=Parallel(polar_angle=self.face_angle, interval=(-tip, tip)),
            root=Parallel(polar_angle=self.root_angle, interval=(foot, 2.0 * np.pi / self.teeth - foot)),
            teeth=self.teeth,
        )
        loops = [outline]
        if hub_angle is not None:
            hole = Parallel(polar_angle=hub_angle, interval=(0.0, -2.0 * np.pi / self.teeth))
            loops.append(Loop(curves=(hole,), copies=self.teeth))
        return SphericalSection(loops=tuple(loops))

    def _rising_flank(self) -> list[Curve]:
        """Curves from root to tip on the clockwise side of the tooth."""
        rolls = roll_at_polar_angle([self.flank_start, self.face_angle], self.base_cone_angle)
        involute = SphericalInvolute(base_cone_angle=self.base_cone_angle, interval=(float(rolls[0]), float(rolls[1])))
        flank: list[Curve] = [mapped(involute, turn(-self.thickness / 2.0 - self.pitch_azimuth, 3))]
        if self.root_angle < self.base_cone_angle * (1.0 - NEXT_TO_NOTHING):
            foot = -self.thickness_at(self.base_cone_angle) / 2.0
            flank.insert(0, Meridian(azimuth=foot, interval=(self.root_angle, self.base_cone_angle)))
        return flank

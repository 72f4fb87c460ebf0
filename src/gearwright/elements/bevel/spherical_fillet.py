"""The root fillet that a crown gear with rounded tips generates, and where the flank proper begins above it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.curve import Curve, mapped, turn
from ...curves.spherical_trochoid import SphericalTrochoid
from .crown_tip import CrownTip
from .spherical_flank import SphericalFlank

_SAMPLES = 257


@dataclass(frozen=True, kw_only=True)
class SphericalFillet:
    """The fillet of a bevel gear cut by its crown gear, whose tips have corners of the angular radius ρ.

    flank        of the gear
    teeth        of the gear
    thickness    angular, of its tooth at the pitch cone, about its axis
    root_angle   polar angle of its root cone, which the crown gear's tip touches
    tip_radius   ρ

    The crown gear's tooth is as wide on the pitch plane as a space of the gear. Where it undercuts, the fillet ends
    at its crossing with the flank. Source: theory of gearing (see `SphericalTrochoid`).
    """

    flank: SphericalFlank
    teeth: int
    thickness: float
    root_angle: float
    tip_radius: float

    @cached_property
    def crown_tip(self) -> CrownTip:
        """The tip of the crown gear's tooth."""
        space = 2.0 * np.pi / self.teeth - self.thickness
        return CrownTip(
            flank=self.flank,
            half_width=float(space / 2.0 * np.sin(self.flank.pitch_angle)),
            depth=self.flank.pitch_angle - self.root_angle,
            radius=self.tip_radius,
        )

    @cached_property
    def trochoid(self) -> SphericalTrochoid:
        """The fillet with the crown gear's tooth on azimuth 0, from the root cone to the flank it is tangent to."""
        tip = self.crown_tip
        return SphericalTrochoid(
            pitch_angle=self.flank.pitch_angle,
            depth=tip.centre_depth,
            offset=tip.land,
            radius=self.tip_radius,
            interval=(np.pi / 2.0, tip.tangent[1]),
        )

    @property
    def undercuts(self) -> bool:
        """Whether the crown gear cuts away some of the flank above its inner end."""
        return self.crown_tip.tangent[0] < self.flank.least_turn

    @property
    def regular(self) -> bool:
        """Whether the fillet rises from the root cone all the way."""
        polar = self.trochoid.polar_angle(np.linspace(*self.trochoid.interval, _SAMPLES))
        return bool(np.all(np.diff(polar) > 0.0)) and self.crown_tip.depth > 0.0

    @cached_property
    def join(self) -> float:
        """Parameter of the trochoid at which the flank takes over."""
        from scipy.optimize import brentq

        tangent = self.crown_tip.tangent[1]
        if not self.undercuts:
            return tangent
        at_end = float(self.trochoid.at_polar_angle(self.flank.least_polar))
        if self._excess(at_end) >= 0.0 or self._excess(tangent) <= 0.0:
            return at_end  # undercut by no more than rounding
        return float(brentq(self._excess, at_end, tangent, xtol=1e-15))

    @cached_property
    def form_angle(self) -> float:
        """Polar angle at which the flank begins."""
        if not self.undercuts:
            return self.flank.polar_at(self.crown_tip.tangent[0])
        return max(self.flank.least_polar, float(self.trochoid.polar_angle(self.join)))

    def half_angle(self, polar: ArrayLike) -> Array:
        """Half the angle (...) of a tooth at polar angles (...) of its fillets."""
        return self._half(self.trochoid.at_polar_angle(polar))

    @property
    def waist(self) -> float:
        """Half the least angle of a tooth along its fillets; where it is not positive they meet."""
        return float(np.min(self._half(np.linspace(np.pi / 2.0, self.join, _SAMPLES))))

    def curve(self) -> Curve:
        """From the root cone to the flank, on the clockwise side of a tooth on azimuth 0."""
        cut = replace(self.trochoid, interval=(np.pi / 2.0, self.join))
        return mapped(cut, turn(-np.pi / self.teeth, 3))

    def _half(self, t: ArrayLike) -> Array:
        """Half the angle (...) of a tooth at parameters t (...)."""
        return np.pi / self.teeth - self.trochoid.azimuth(t)

    def _excess(self, t: ArrayLike) -> float:
        """By how much the tooth is thicker at the fillet's parameter t than between its flanks at that polar angle."""
        polar = max(float(self.trochoid.polar_angle(t)), self.flank.least_polar)
        return float(self._half(t) - (self.thickness / 2.0 - self.flank.azimuth_at(polar)))

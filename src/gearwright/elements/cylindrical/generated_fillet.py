"""The root fillet that a rack with rounded tips generates, and where the involute begins above it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.crossing import crossing
from ...curves.trochoid import Trochoid
from .rack_tip import RackTip
from .toothing import Toothing

_SAMPLES = 257


@dataclass(frozen=True, kw_only=True)
class GeneratedFillet:
    """The fillet of a toothing cut by the rack of its pitch line, whose tips have a radius ρ in the normal section.

    The rack's tooth is as wide on the pitch line as a space of the gear and reaches to the root circle. Where it
    undercuts, the fillet ends at its crossing with the involute. Azimuths are taken from the middle of a tooth.
    Source: ISO 21771; theory of gearing (see `Trochoid`).
    """

    toothing: Toothing
    tip_radius: float

    @cached_property
    def rack_tip(self) -> RackTip:
        """The tip of the rack's tooth."""
        toothing = self.toothing
        return RackTip(
            half_width=(toothing.circular_pitch - toothing.thickness) / 2.0,
            depth=toothing.dedendum,
            pressure_angle=toothing.transverse_pressure_angle,
            stretch=float(1.0 / np.cos(toothing.helix_angle)),
            radius=self.tip_radius,
        )

    @cached_property
    def trochoid(self) -> Trochoid:
        """The fillet with the rack's tooth on +x, from the root circle to the flank it would be tangent to."""
        tip, toothing = self.rack_tip, self.toothing
        return Trochoid(
            pitch_radius=toothing.pitch_radius,
            depth=toothing.dedendum - self.tip_radius,
            offset=tip.land,
            half_axes=tip.half_axes,
            interval=(np.pi / 2.0, toothing.transverse_pressure_angle),
        )

    @cached_property
    def _tangent_string(self) -> float:
        """Length of the base tangent to the point where the rack's flank ends; negative beyond the base circle."""
        sine = np.sin(self.toothing.transverse_pressure_angle)
        return float(self.toothing.pitch_radius * sine - self.rack_tip.side_end[1] / sine)

    @property
    def undercuts(self) -> bool:
        """Whether the rack cuts away some of the involute above the base circle."""
        return self._tangent_string < 0.0

    @property
    def regular(self) -> bool:
        """Whether the fillet rises from the root circle all the way."""
        radii = self._polar(np.linspace(*self.trochoid.interval, _SAMPLES))[0]
        return bool(np.all(np.diff(radii) > 0.0)) and self.toothing.dedendum > 0.0

    @cached_property
    def join(self) -> float:
        """Parameter of the trochoid at which the involute takes over."""
        from scipy.optimize import brentq

        tangent = self.toothing.transverse_pressure_angle
        if not self.undercuts:
            return tangent
        at_base = float(self.at_radius(self.toothing.base_radius))
        if self._excess(at_base) >= 0.0 or self._excess(tangent) <= 0.0:
            return at_base  # undercut by no more than rounding
        return float(brentq(self._excess, at_base, tangent, xtol=1e-15))

    @cached_property
    def form_radius(self) -> float:
        """Radius at which the involute begins."""
        if not self.undercuts:
            return float(np.hypot(self.toothing.base_radius, self._tangent_string))
        return max(self.toothing.base_radius, float(self._polar(self.join)[0]))

    def at_radius(self, radius: ArrayLike) -> Array:
        """Parameter t (...) of the fillet at radii (...) from the root circle to that where t is the pressure angle.

        The radius rises from the root circle as the square of π/2 − t; its root √(r − r_f) rises evenly.
        """
        land, flank = np.pi / 2.0, self.toothing.transverse_pressure_angle
        foot, top = (float(self._polar(t)[0]) for t in (land, flank))
        wanted = np.sqrt(np.clip(np.asarray(radius, float), foot, top) - foot)

        def excess(t: Array) -> Array:
            return np.sqrt(np.maximum(self._polar(t)[0] - foot, 0.0)) - wanted

        return crossing(excess, np.full(wanted.shape, land), np.full(wanted.shape, flank))

    def half_angle(self, radius: ArrayLike) -> Array:
        """Half the angle (...) of a tooth at radii (...) of its fillets."""
        return self._half(self.at_radius(radius))

    @property
    def waist(self) -> float:
        """Half the least angle of a tooth along its fillets; where it is not positive they meet."""
        return float(np.min(self._half(np.linspace(np.pi / 2.0, self.join, _SAMPLES))))

    def _half(self, t: ArrayLike) -> Array:
        """Half the angle (...) of a tooth at parameters t (...)."""
        return np.pi / self.toothing.teeth - self._polar(t)[1]

    def _excess(self, t: ArrayLike) -> float:
        """By how much the tooth is thicker at the fillet's parameter t than between its involutes at that radius."""
        radius = max(float(self._polar(t)[0]), self.toothing.base_radius)
        return float(self._half(t) - self.toothing.enclosed_half(radius))

    def _polar(self, t: ArrayLike) -> tuple[Array, Array]:
        """Radii and azimuths (...) of the trochoid, from the middle of the rack's tooth."""
        points = self.trochoid.point(t)
        return np.hypot(points[..., 0], points[..., 1]), np.arctan2(points[..., 1], points[..., 0])

"""Extrusion with twist, scaling and skew, all growing evenly with height."""

from __future__ import annotations

import cmath
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import extrusion_sweep
from ..sections.plane import Section
from ..sections.section import LoopedSection
from .ends import Ends
from .parallel import ParallelMotion

_ROUNDING = float(np.finfo(float).eps)
_FAR = 100.0  # distance from the axis, in radii of gyration, squared: two digits lost


@dataclass(frozen=True, kw_only=True)
class Extrusion(ParallelMotion):
    """p ↦ skew·v/L + R(φ₀ + twist·v/L) diag(1 + (s − 1) v/L) p, at height v from 0 to L, about the section's origin.

    length       L
    twist        angle of the far end against the near one, radians, right-handed if positive
    scale        (s_x, s_y) of the far end, positive
    skew         offset (x, y) of the far end, a length
    near_angle   φ₀, by which the near end is turned already, radians

    Source: Al-Daccak 1989, eqs. (5.17)–(5.20).
    """

    length: float
    twist: float = 0.0
    scale: tuple[float, float] = (1.0, 1.0)
    skew: tuple[float, float] = (0.0, 0.0)
    near_angle: float = 0.0

    def linear(self, v: ArrayLike) -> Array:
        t = np.asarray(v, float) / self.length
        return self._turn(t) * self._scales(t)[..., None, :]

    def linear_rate(self, v: ArrayLike) -> Array:
        t = np.asarray(v, float) / self.length
        quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
        turning = self.twist * (quarter @ self._turn(t)) * self._scales(t)[..., None, :]
        growing = self._turn(t) * (np.array(self.scale) - 1.0)
        return (turning + growing) / self.length

    def _turn(self, t: Array) -> Array:
        angle = self.near_angle + self.twist * t
        turned = np.empty((*angle.shape, 2, 2))
        turned[..., 0, 0] = turned[..., 1, 1] = np.cos(angle)
        turned[..., 1, 0] = np.sin(angle)
        turned[..., 0, 1] = -turned[..., 1, 0]
        return turned

    def _scales(self, t: Array) -> Array:
        return 1.0 + (np.array(self.scale) - 1.0) * t[..., None]

    def offset(self, v: ArrayLike) -> Array:
        return np.asarray(v, float)[..., None] / self.length * np.array(self.skew)

    def offset_rate(self, v: ArrayLike) -> Array:
        return np.broadcast_to(np.array(self.skew) / self.length, (*np.shape(v), 2)).copy()

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        """In closed form; by quadrature for a section that varies, or so far off that the closed form loses digits."""
        if not isinstance(section, Section):
            return None
        if section.varies:
            return super().moments(section, ends)
        local, centre = section.local_moments, complex(*section.local_moments.origin.tolist())
        gyration = float(local.values[2, 0] + local.values[0, 2]) / local.area
        reach = abs(centre) ** 2 / gyration
        if reach > _FAR:
            return super().moments(section, ends)
        half, middle = ends.span / 2.0, (ends.start + ends.finish) / 2.0
        at, share = middle / self.length, half / self.length
        growth = [s - 1.0 for s in self.scale]
        offset = complex(*self.skew)
        matrix = extrusion_sweep(
            local.values,
            centre,
            [(1.0 + g * at, g * share) for g in growth],
            cmath.exp(1j * (self.near_angle + self.twist * at)),
            self.twist * share,
            offset * share,
            half,
        )
        origin = np.array([offset.real * at, offset.imag * at, middle])
        rounding = (1.0 + reach) * _ROUNDING
        return about_centroid(matrix, "exact", section.moments_error + rounding, origin)

    @property
    def rotation_order(self) -> int:
        if self.skew != (0.0, 0.0):
            return 1
        return 0 if self.scale[0] == self.scale[1] else 2

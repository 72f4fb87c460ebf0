"""Extrusion with twist, scaling and skew, all growing evenly with height."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .parallel import ParallelMotion


@dataclass(frozen=True, kw_only=True)
class Extrusion(ParallelMotion):
    """p ↦ skew·v/L + R(twist·v/L) diag(1 + (s − 1) v/L) p, at height v from 0 to L, about the section's origin.

    length   L
    twist    angle of the far end against the near one, radians, right-handed if positive
    scale    (s_x, s_y) of the far end, positive
    skew     offset (x, y) of the far end, a length

    Source: Al-Daccak 1989, eqs. (5.17)–(5.20).
    """

    length: float
    twist: float = 0.0
    scale: tuple[float, float] = (1.0, 1.0)
    skew: tuple[float, float] = (0.0, 0.0)

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
        c, s = np.cos(self.twist * t), np.sin(self.twist * t)
        return np.stack([np.stack([c, -s], axis=-1), np.stack([s, c], axis=-1)], axis=-2)

    def _scales(self, t: Array) -> Array:
        return 1.0 + (np.array(self.scale) - 1.0) * t[..., None]

    def offset(self, v: ArrayLike) -> Array:
        return np.asarray(v, float)[..., None] / self.length * np.array(self.skew)

    def offset_rate(self, v: ArrayLike) -> Array:
        return np.broadcast_to(np.array(self.skew) / self.length, (*np.shape(v), 2)).copy()

    @property
    def rotation_order(self) -> int:
        if self.skew != (0.0, 0.0):
            return 1
        return 0 if self.scale[0] == self.scale[1] else 2

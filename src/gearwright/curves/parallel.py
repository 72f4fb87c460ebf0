"""Parallels: the circles of constant polar angle on the unit sphere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Parallel(Curve):
    """The circle of polar angle δ about +z on the unit sphere; u is the azimuth, radians."""

    polar_angle: float

    def point(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        s = np.sin(self.polar_angle)
        return np.stack([s * np.cos(u), s * np.sin(u), np.full_like(u, np.cos(self.polar_angle))], axis=-1)

    def derivative(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        s = np.sin(self.polar_angle)
        return np.stack([-s * np.sin(u), s * np.cos(u), np.zeros_like(u)], axis=-1)

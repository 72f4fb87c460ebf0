"""Meridians: the great circles through the pole of the unit sphere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Meridian(Curve):
    """The great circle of constant azimuth on the unit sphere; u is the polar angle from +z, radians."""

    azimuth: float

    def point(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        c, s = np.cos(self.azimuth), np.sin(self.azimuth)
        return np.stack([np.sin(u) * c, np.sin(u) * s, np.cos(u)], axis=-1)

    def derivative(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        c, s = np.cos(self.azimuth), np.sin(self.azimuth)
        return np.stack([np.cos(u) * c, np.cos(u) * s, -np.sin(u)], axis=-1)

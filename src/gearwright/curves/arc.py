"""Circular arcs in the plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Arc(Curve):
    """The circular arc centre + radius (cos u, sin u); u is the angle from +x, radians."""

    radius: float
    centre: tuple[float, float] = (0.0, 0.0)

    def point(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        return np.asarray(self.centre) + self.radius * np.stack([np.cos(u), np.sin(u)], axis=-1)

    def derivative(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)
        return self.radius * np.stack([-np.sin(u), np.cos(u)], axis=-1)

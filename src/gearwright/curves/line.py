"""Straight line segments."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Line(Curve):
    """The segment from `first` to `last`, in the plane or in space; u from 0 to 1."""

    first: tuple[float, ...]
    last: tuple[float, ...]
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)[..., None]
        return np.asarray(self.first) * (1.0 - u) + np.asarray(self.last) * u

    def derivative(self, u: ArrayLike) -> Array:
        step = np.asarray(self.last, float) - np.asarray(self.first, float)
        return np.broadcast_to(step, (*np.shape(u), step.size)).copy()

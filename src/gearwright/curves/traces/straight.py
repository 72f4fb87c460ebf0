"""Straight teeth, along generators of the pitch cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from .trace import Trace, power_integral


@dataclass(frozen=True, kw_only=True)
class StraightTrace(Trace):
    """Straight teeth: w = 0."""

    @property
    def reach(self) -> tuple[float, float]:
        return (0.0, np.inf)

    def crown_angle(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def spiral_angle(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def turn(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def slope(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^power dr in closed form."""
        del harmonic
        return power_integral(complex(power + 1), start, stop)

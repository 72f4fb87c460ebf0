"""Skew teeth, straight ones that pass the apex at a distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from .trace import SpiralTrace, root


@dataclass(frozen=True, kw_only=True)
class SkewTrace(SpiralTrace):
    """A straight line on the crown gear, tangent to a circle about the apex: r sin β = r_m sin β_m.

    θ = β_m − β, here as the angle between two points of the line. Source: ISO 23509 (skew bevel gears).
    """

    @property
    def reach(self) -> tuple[float, float]:
        return (self._offset, np.inf)

    @property
    def _offset(self) -> float:
        """The circle's radius."""
        return float(self.mean_distance * np.sin(self.mean_spiral_angle))

    def _along(self, distance: Array) -> tuple[Array, float]:
        """r cos β (...) and r_m cos β_m, from the point of tangency along the line."""
        mean = float(self.mean_distance * np.cos(self.mean_spiral_angle))
        return root(self._beyond(distance) + mean**2, distance), mean

    def crown_angle(self, distance: ArrayLike) -> Array:
        r = np.asarray(distance, float)
        along, mean = self._along(r)
        return np.arctan2(self._offset * self._beyond(r) / (along + mean), self._offset**2 + along * mean)

    def spiral_angle(self, distance: ArrayLike) -> Array:
        return np.arctan2(self._offset, self._along(np.asarray(distance, float))[0])

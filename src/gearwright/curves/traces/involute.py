"""The involute of a circle about the apex, on the crown gear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from ..involute import involute_of_roll
from .trace import SpiralTrace, root


@dataclass(frozen=True, kw_only=True)
class InvoluteTrace(SpiralTrace):
    """An involute on the crown gear: r cos β = r_m cos β_m, its base circle's radius; θ = inv β − inv β_m.

    The teeth keep their normal pitch along the face. Source: Klingelnberg's palloid system.
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.mean_spiral_angle == 0.0:
            raise ValueError("an involute that stands radially at the mean cone distance begins there")

    @property
    def reach(self) -> tuple[float, float]:
        return (self._base, np.inf)

    @property
    def _base(self) -> float:
        return float(self.mean_distance * np.cos(self.mean_spiral_angle))

    def crown_angle(self, distance: ArrayLike) -> Array:
        """With t = tan β: θ = d t t_m + (d − atan d), d = (t − t_m)/(1 + t t_m) = tan(β − β_m), of one sign."""
        r = np.asarray(distance, float)
        mean = float(self.mean_distance * np.sin(self.mean_spiral_angle))
        along = self._along(r)
        d = self._base * self._beyond(r) / ((along + mean) * (self._base**2 + along * mean))
        return d * along * mean / self._base**2 + np.copysign(involute_of_roll(np.abs(d)), d)

    def spiral_angle(self, distance: ArrayLike) -> Array:
        return np.arctan2(self._along(np.asarray(distance, float)), self._base)

    def _along(self, r: Array) -> Array:
        """r sin β (...), the length of the tangent from the point to the base circle."""
        mean = float(self.mean_distance * np.sin(self.mean_spiral_angle))
        return root(self._beyond(r) + mean**2, r)

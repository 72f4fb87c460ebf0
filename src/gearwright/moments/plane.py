"""Moments of a plane region about a point near it."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb

import numpy as np

from ..arrays import Array, ArrayLike


@dataclass(frozen=True, kw_only=True)
class PlaneMoments:
    """Moments to order 3 of a plane region about `origin` (2,), a point of the region's own neighbourhood.

    values   (4, 4)  m[a, b] = ∫ x^a y^b dA for a + b ≤ 3, with x and y from the origin

    Taken about a far point they would hold little of the region's own shape: keep them here, and shift late.
    """

    origin: Array
    values: Array

    @property
    def area(self) -> float:
        return float(self.values[0, 0])

    @property
    def centroid(self) -> Array:
        m = self.values
        return self.origin + np.array([m[1, 0], m[0, 1]]) / m[0, 0]

    def about(self, point: ArrayLike) -> Array:
        """m[a, b] (4, 4) about another point (2,)."""
        dx, dy = self.origin - np.asarray(point, float)
        shifted = np.zeros_like(self.values)
        for a in range(len(self.values)):
            for b in range(len(self.values) - a):
                shifted[a, b] = sum(
                    comb(a, i) * comb(b, j) * dx ** (a - i) * dy ** (b - j) * self.values[i, j]
                    for i in range(a + 1)
                    for j in range(b + 1)
                )
        return shifted

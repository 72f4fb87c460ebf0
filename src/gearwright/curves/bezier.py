"""Bézier curves, the spans of polynomial splines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Bezier(Curve):
    """The polynomial Σ B_k(u) P_k of Bernstein's basis, in the plane or in space; u from 0 to 1.

    control   P_k, degree + 1 points; the first and the last are the ends, to the last digit
    """

    control: tuple[tuple[float, ...], ...]
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        return bernstein(len(self.control) - 1, u) @ np.array(self.control)

    def derivative(self, u: ArrayLike) -> Array:
        degree = len(self.control) - 1
        return degree * bernstein(degree - 1, u) @ np.diff(np.array(self.control), axis=0)

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All curves at once, where their degrees and intervals are equal."""
        first = curves[0]
        if any((len(c.control), c.interval) != (len(first.control), first.interval) for c in curves):
            return super().together(curves, fractions)
        control = np.array([c.control for c in curves])
        degree, u = control.shape[1] - 1, first.parameter(fractions)
        span = first.interval[1] - first.interval[0]
        return bernstein(degree, u) @ control, span * degree * bernstein(degree - 1, u) @ np.diff(control, axis=1)

    @classmethod
    def points_together(cls, curves: Sequence[Self], fractions: Array) -> Array:
        return cls.together(curves, fractions)[0]


def bernstein(degree: int, u: ArrayLike) -> Array:
    """Bernstein's polynomials (..., degree + 1) at u (...): binomial(n, k) u^k (1 − u)^(n − k)."""
    u = np.asarray(u, float)[..., None]
    k = np.arange(degree + 1)
    binomials = np.array([comb(degree, i) for i in k], float)
    return binomials * u**k * (1.0 - u) ** (degree - k)

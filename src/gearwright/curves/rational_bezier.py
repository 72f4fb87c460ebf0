"""Rational Bézier curves, the spans of rational B-splines (NURBS)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike
from .bezier import bernstein
from .curve import Curve

FLAT = 0.04
"""An arc that turns by less, in radians, is better off without its centre."""


@dataclass(frozen=True, kw_only=True)
class RationalBezier(Curve):
    """The quotient Σ w_k B_k(u) P_k / Σ w_k B_k(u) of Bernstein's basis; u from 0 to 1.

    control   P_k, degree + 1 points; the first and the last are the ends
    weights   w_k > 0, one a point
    """

    control: tuple[tuple[float, ...], ...]
    weights: tuple[float, ...]
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        return _values(np.array(self.control), np.array(self.weights), u)[0]

    def derivative(self, u: ArrayLike) -> Array:
        return _values(np.array(self.control), np.array(self.weights), u)[1]

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All curves at once, where their degrees and intervals are equal."""
        first = curves[0]
        if any((len(c.control), c.interval) != (len(first.control), first.interval) for c in curves):
            return super().together(curves, fractions)
        control, weights = np.array([c.control for c in curves]), np.array([c.weights for c in curves])
        points, slopes = _values(control, weights, first.parameter(fractions))
        return points, (first.interval[1] - first.interval[0]) * slopes

    @classmethod
    def points_together(cls, curves: Sequence[Self], fractions: Array) -> Array:
        return cls.together(curves, fractions)[0]


def _values(control: Array, weights: Array, u: ArrayLike) -> tuple[Array, Array]:
    """Points and derivatives at u, by the quotient rule on numerator and denominator."""
    degree = control.shape[-2] - 1
    weighted = weights[..., None] * control
    basis, lower = bernstein(degree, u), bernstein(degree - 1, u)
    below = basis @ weights[..., None]
    points = basis @ weighted / below
    steps = degree * (lower @ np.diff(weighted, axis=-2))
    return points, (steps - points * (degree * (lower @ np.diff(weights, axis=-1)[..., None]))) / below


def flat_arc(start: Array, end: Array, angle: float) -> RationalBezier:
    """The circular arc from start to end (2,) that turns by an angle, to the left if positive, |angle| < π.

    By its ends and the point where their tangents meet: a flat arc's centre is so far off that its coordinates would
    lose the arc's own digits.
    """
    chord = end - start
    apex = (start + end + np.array([chord[1], -chord[0]]) * np.tan(angle / 2.0)) / 2.0
    control = tuple(tuple(p.tolist()) for p in (start, apex, end))
    return RationalBezier(control=control, weights=(1.0, float(np.cos(angle / 2.0)), 1.0))

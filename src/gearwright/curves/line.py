"""Straight line segments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Self

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

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All lines at once."""
        first, last = (np.array([getattr(c, end) for c in curves], float)[:, None, :] for end in ("first", "last"))
        a, b = (np.array(ends)[:, None] for ends in zip(*(c.interval for c in curves), strict=True))
        u = (a * (1.0 - fractions) + b * fractions)[..., None]
        return first * (1.0 - u) + last * u, (last - first) * (b - a)[..., None] + np.zeros_like(u)

    @classmethod
    def points_together(cls, curves: Sequence[Self], fractions: Array) -> Array:
        return cls.together(curves, fractions)[0]


def lines_through(points: ArrayLike) -> list[Line]:
    """The lines from point to point (n, d); equal neighbours are one point."""
    corners = [tuple(corner) for corner in np.asarray(points, float).tolist()]
    return [Line(first=a, last=b) for a, b in pairwise(corners) if a != b]

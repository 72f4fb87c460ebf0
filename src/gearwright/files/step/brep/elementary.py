"""Straight lines and circles among curves, by their points: whatever made them, they are written as what they are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....arrays import Array

SAME = 1e-12
"""Of the distance from the origin: points so near each other are one, as the rounding of placed coordinates allows."""

FRACTIONS = np.linspace(0.0, 1.0, 17)
"""Where a curve is looked at."""

_LEAST_BEND = 1e-5
"""Least sagitta, in chords, of a circle that its points still define well."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Straight:
    """The segment first + f (last − first), f from 0 to 1."""

    first: Array
    last: Array

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.last - self.first))


@dataclass(frozen=True, kw_only=True, eq=False)
class Circular:
    """centre + radius (x cos(a + s f) + y sin(a + s f)), f from 0 to 1, with s > 0; x, y, axis right-handed.

    start   a; sweep   s
    """

    centre: Array
    x: Array
    axis: Array
    radius: float
    start: float
    sweep: float

    @property
    def y(self) -> Array:
        return np.cross(self.axis, self.x)


def straight(points: Array, near: float) -> Straight | None:
    """The segment that has points (17, 3) at FRACTIONS, to within a length; None where it is none."""
    first, last = points[0], points[-1]
    found = first + FRACTIONS[:, None] * (last - first)
    if np.max(np.abs(points - found)) > near or np.linalg.norm(last - first) <= near:
        return None
    return Straight(first=first, last=last)


def circular(points: Array, near: float) -> Circular | None:
    """The circle, or the arc of one, that has points (17, 3) at FRACTIONS, to within a length; None if it is none."""
    a, b, c = points[0], points[5], points[10]
    normal = np.cross(b - a, c - a)
    chord, area = float(np.linalg.norm(c - a)), float(np.linalg.norm(normal))
    if area <= _LEAST_BEND * chord**2 or chord <= near:
        return None
    axis = normal / area
    # the point of the plane that is as far from a as from b and from c
    u, v = b - a, c - a
    centre = a + np.cross(v @ v * u - u @ u * v, axis)[:] * (-0.5 / area)
    arms = points - centre
    radius = float(np.mean(np.linalg.norm(arms, axis=1)))
    x = arms[0] / np.linalg.norm(arms[0])
    y = np.cross(axis, x)
    angles = np.unwrap(np.arctan2(arms @ y, arms @ x))
    sweep = float(angles[-1])
    around = sweep * FRACTIONS
    found = centre + radius * (np.cos(around)[:, None] * x + np.sin(around)[:, None] * y)
    if sweep <= 0.0 or np.max(np.abs(found - points)) > near:
        return None
    return Circular(centre=centre, x=x, axis=axis, radius=radius, start=0.0, sweep=sweep)

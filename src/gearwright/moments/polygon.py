"""Moments of plane polygons with holes, to order 3."""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

import numpy as np

from ..arrays import Array, ArrayLike
from .compensated import compensated_sum

ORDER = 3
"""Highest order a + b of the moments given; sweeps along space curves need it."""

_GAUSS = 0.5 / np.sqrt(3.0)
"""Distance of the two Gauss points from the middle of an edge, in edge lengths; exact to degree 3."""


def polygon_moments(loops: Sequence[ArrayLike]) -> Array:
    """Moments m[a, b] = ∫ x^a y^b dA about the origin, for a + b ≤ 3; the other entries are 0.

    loops    each (n, 2), corners in order, the last joined to the first; the outer loop
             counter-clockwise, holes clockwise, several bodies one after another
    returns  (4, 4), in the unit of the points to the power a + b + 2

    Summed about the middle of the bounding box, with cross products from edge differences, then
    shifted: far from the origin nothing is lost but what the shift itself needs.
    Raises ValueError if a loop is not (n, 2).
    Source: Al-Daccak 1989, eqs. (4.5)–(4.12); here any order by one edge integral, eq. (M2).
    """
    corners = [_loop(points) for points in loops]
    if not any(len(points) for points in corners):
        return np.zeros((ORDER + 1, ORDER + 1))
    start = np.concatenate(corners)
    end = np.concatenate([np.roll(points, -1, axis=0) for points in corners])
    origin = (start.min(axis=0) + start.max(axis=0)) / 2.0
    return _shifted(_moments_about_origin(start - origin, end - start), origin)


def _loop(points: ArrayLike) -> Array:
    loop = np.asarray(points, float)
    if loop.ndim != 2 or loop.shape[1] != 2:
        raise ValueError(f"a loop is an (n, 2) array of corners, not {loop.shape}")
    return loop


def _moments_about_origin(start: Array, edge: Array) -> Array:
    """Eq. (M2) over edges (n, 2) from `start`: the cross product is x_i Δy_i − y_i Δx_i."""
    cross = start[:, 0] * edge[:, 1] - start[:, 1] * edge[:, 0]
    nodes = start + edge * np.array([0.5 - _GAUSS, 0.5 + _GAUSS])[:, None, None]
    powers = nodes[..., None] ** np.arange(ORDER + 1)
    moments = np.zeros((ORDER + 1, ORDER + 1))
    for a in range(ORDER + 1):
        for b in range(ORDER + 1 - a):
            mean = (powers[:, :, 0, a] * powers[:, :, 1, b]).mean(axis=0)
            moments[a, b] = compensated_sum(cross * mean) / (a + b + 2)
    return moments


def _shifted(moments: Array, offset: Array) -> Array:
    """Moments of the region moved by `offset` (2,): (x + u)^a (y + v)^b multiplied out."""
    result = np.zeros_like(moments)
    for a in range(ORDER + 1):
        for b in range(ORDER + 1 - a):
            result[a, b] = sum(
                comb(a, i) * comb(b, j) * offset[0] ** (a - i) * offset[1] ** (b - j) * moments[i, j]
                for i in range(a + 1)
                for j in range(b + 1)
            )
    return result

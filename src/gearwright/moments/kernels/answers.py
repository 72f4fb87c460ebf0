"""Volume, centroid and inertia of a few triangles in one compiled call: what a call costs counts most there."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ...compiled import compiled
from .sums import ROWS
from .triangles import triangle_sums

_SAMPLE = 8


@compiled
def answers(vertices: Array, triangles: Any, numbers: Any) -> tuple[int, Array, Array, Array]:
    """The place of a bad number or −1; values (5,); centroid (3,); inertia tensor about it (3, 3), density 1.

    Arrays as for `triangle_sums`. The values are V, the closure residual, the cancellation in V and in S as in
    `PolyhedronMoments.amplification`, and Σ |d| tr(…), which overflows or vanishes first.
    """
    values, centroid, inertia = np.zeros(5), np.zeros(3), np.zeros((3, 3))
    origin = _middle(vertices, triangles)
    high, low = np.zeros(ROWS), np.zeros(ROWS)
    place = triangle_sums(vertices, triangles, numbers, 0, len(triangles), origin, high, low)
    if place >= 0:
        return place, values, centroid, inertia
    sums = high + low
    volume = sums[0] / 6.0
    x, y, z = sums[1] / 24.0 / volume, sums[2] / 24.0 / volume, sums[3] / 24.0 / volume
    xx, yy, zz = (
        sums[4] / 120.0 - volume * x * x,
        sums[5] / 120.0 - volume * y * y,
        sums[6] / 120.0 - volume * z * z,
    )
    centroid[0], centroid[1], centroid[2] = origin[0] + x, origin[1] + y, origin[2] + z
    inertia[0, 0], inertia[1, 1], inertia[2, 2] = yy + zz, zz + xx, xx + yy
    inertia[0, 1] = inertia[1, 0] = volume * x * y - sums[7] / 120.0
    inertia[1, 2] = inertia[2, 1] = volume * y * z - sums[8] / 120.0
    inertia[2, 0] = inertia[0, 2] = volume * z * x - sums[9] / 120.0
    values[0] = volume
    values[1] = np.sqrt(sums[10] ** 2 + sums[11] ** 2 + sums[12] ** 2) / sums[13]
    values[2] = sums[14] / abs(sums[0])
    values[3] = sums[15] / 120.0 / abs(xx + yy + zz)
    values[4] = sums[15]
    return place, values, centroid, inertia


@compiled
def _middle(vertices: Array, triangles: Any) -> Array:
    """The middle (3,) of a few corners: somewhere among the faces. Numbers out of range are left out."""
    least, most = np.full(3, np.inf), np.full(3, -np.inf)
    for t in range(0, len(triangles), max(1, len(triangles) // _SAMPLE)):
        vertex = triangles[t, 0]
        if 0 <= vertex < len(vertices):
            for axis in range(3):
                least[axis] = min(least[axis], vertices[vertex, axis])
                most[axis] = max(most[axis], vertices[vertex, axis])
    return least + (most - least) / 2.0

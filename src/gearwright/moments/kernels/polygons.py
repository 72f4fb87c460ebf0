"""Sums over polygon faces of any sizes, each as the signed fan from its first corner."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...arrays import Array
from ...compiled import compiled
from .sums import ROWS, RUN, add_triangle, take


@compiled
def polygon_sums(
    vertices: Array, indices: Any, offsets: Any, start: int, stop: int, origin: Array, high: Array, low: Array
) -> int:
    """Adds faces `start` to `stop` to the sums high + low (16,) about an origin (3,).

    vertices (n, 3) float64; indices (c,) and offsets (f + 1,) as in `faces`. Gives −1, or the first face that has
    fewer than three corners or names a vertex that is not there; nothing outside the arrays is read.
    """
    block = np.zeros(ROWS)
    count = len(vertices)
    triangles = 0
    for face in range(start, stop):
        first, after = offsets[face], offsets[face + 1]
        if first < 0 or after > len(indices) or after - first < 3:
            return face
        for place in range(first, after):
            if indices[place] < 0 or indices[place] >= count:
                return face
        nx, ny, nz = 0.0, 0.0, 0.0
        for place in range(first + 1, after - 1):
            x, y, z = add_triangle(vertices, indices[first], indices[place], indices[place + 1], origin, block)
            nx, ny, nz = nx + x, ny + y, nz + z
            triangles += 1
            if triangles == RUN:
                take(high, low, block)
                triangles = 0
        block[13] += math.sqrt(nx * nx + ny * ny + nz * nz)
    take(high, low, block)
    return -1

"""Sums over triangles that name their corners by number."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...arrays import Array
from ...compiled import compiled
from .plain import add_triangles
from .sums import BLOCK, LANES, ROWS, RUN, add_triangle, join_lanes, take, take_lanes


@compiled
def triangle_sums(
    vertices: Array, triangles: Any, numbers: Any, start: int, stop: int, origin: Array, high: Array, low: Array
) -> int:
    """Adds triangles `start` to `stop` to the sums high + low (16,) about an origin (3,).

    vertices (n, 3) float64 and triangles (m, 3) int32 or int64, both contiguous; `numbers` (3m,) are the triangles'
    unsigned. Gives −1, or the place in `numbers` of the first block's first number out of range; nothing outside
    the arrays is read.
    """
    if len(vertices) == 0:
        return 3 * start if stop > start else -1
    lanes, highs, lows = np.zeros(LANES * ROWS), np.zeros(LANES * ROWS), np.zeros(LANES * ROWS)
    block = np.zeros(ROWS)
    last = np.uint64(len(vertices) - 1)
    for first in range(start, stop, BLOCK):
        end = min(first + BLOCK, stop)
        largest = np.uint64(0)
        for place in range(3 * first, 3 * end):
            largest = max(largest, np.uint64(numbers[place]))
        if largest > last:
            return _first_beyond(numbers, 3 * first, last)
        # the last vertex has no number after it that could be read with it
        wide = first + (end - first) // LANES * LANES if largest < last else first
        if wide > first:
            add_triangles(vertices, triangles, first, wide, origin, lanes)
            take_lanes(highs, lows, lanes)
        for t in range(wide, end):
            nx, ny, nz = add_triangle(vertices, triangles[t, 0], triangles[t, 1], triangles[t, 2], origin, block)
            block[13] += math.sqrt(nx * nx + ny * ny + nz * nz)
            if (t + 1 - wide) % RUN == 0 or t + 1 == end:
                take(high, low, block)
    join_lanes(high, low, highs, lows)
    return -1


@compiled
def _first_beyond(numbers: Any, place: int, last: Any) -> int:
    while np.uint64(numbers[place]) <= last:
        place += 1
    return place

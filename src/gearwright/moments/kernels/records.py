"""Sums over triangles that stand alone, each with its three corners, as in STL files.

Corners that belong together are known by their coordinates alone. Whether the triangles close is found without
joining them: every side, from p to q, adds a 64-bit number that depends on both ends and changes its sign with the
direction. The numbers of all sides add up to nought, modulo 2⁶⁴, if every side is walked as often one way as the
other; otherwise they do so once in 2⁶⁴ times. No memory is needed for that, and chunks add up in any order.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ...compiled import compiled
from .plain import add_triangles
from .sums import BLOCK, LANES, ROWS, join_lanes, take_lanes

_K = tuple(np.uint64(k) for k in (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0xD6E8FEB86659FD93, 0xA0761D6478BD642F))


@compiled
def record_sums(corners: Any, origin: Array, nought: Any, high: Array, low: Array, box: Array, sides: Any) -> None:
    """Adds triangles (m, 3, 3), single precision, to the sums high + low (16,), `box` (2, 3) and `sides` (1,).

    Coordinates of at most `nought` count as 0. Corners that are not finite leave sums that are not finite.
    """
    lanes, highs, lows = np.zeros(LANES * ROWS), np.zeros(LANES * ROWS), np.zeros(LANES * ROWS)
    single = np.empty((3 * BLOCK, 3), np.float32)
    words = single.view(np.uint32)
    # one more, since corners are read four numbers at a time
    points = np.empty((3 * BLOCK + 1, 3))
    triangles = np.arange(3 * BLOCK, dtype=np.int32).reshape(BLOCK, 3)
    names = np.empty(3 * BLOCK, np.uint64)
    for first in range(0, len(corners), BLOCK):
        count = min(BLOCK, len(corners) - first)
        for t in range(count):
            for corner in range(3):
                for axis in range(3):
                    x = corners[first + t, corner, axis]
                    single[3 * t + corner, axis] = x if abs(x) > nought or x != x else np.float32(0.0)
        for c in range(3 * count):
            names[c] = _vertex(words[c, 0], words[c, 1], words[c, 2])
        sides[0] += _sides(names, count)
        _spread(single, 3 * count, box)
        for c in range(3 * count):
            for axis in range(3):
                points[c, axis] = single[c, axis]
        whole = (count + LANES - 1) // LANES * LANES
        for c in range(3 * count, 3 * whole):  # triangles without area fill the last four
            for axis in range(3):
                points[c, axis] = origin[axis]
        add_triangles(points, triangles, 0, whole, origin, lanes)
        take_lanes(highs, lows, lanes)
    join_lanes(high, low, highs, lows)


@compiled
def _spread(points: Any, count: int, box: Array) -> None:
    """Widens a box (2, 3) by the first points (n, 3)."""
    for axis in range(3):
        least, most = np.float32(box[0, axis]), np.float32(box[1, axis])
        for c in range(count):
            x = points[c, axis]
            if x < least:
                least = x
            if x > most:
                most = x
        box[0, axis], box[1, axis] = least, most


@compiled
def _vertex(x: Any, y: Any, z: Any) -> Any:
    name = (np.uint64(x) | (np.uint64(y) << np.uint64(32))) * _K[0]
    name ^= name >> np.uint64(32)
    name = (name + np.uint64(z)) * _K[1]
    return name ^ (name >> np.uint64(29))


@compiled
def _sides(names: Any, count: int) -> Any:
    """The sum of the numbers of all sides of triangles whose corners have these names (3 m,)."""
    total = np.uint64(0)
    for t in range(count):
        a, b, c = names[3 * t], names[3 * t + 1], names[3 * t + 2]
        total += _side(a, b) + _side(b, c) + _side(c, a)
    return total


@compiled
def _side(start: Any, end: Any) -> Any:
    """A number for a side, of opposite sign the other way; nought where both ends are one."""
    forward = start < end
    least, most = (start, end) if forward else (end, start)
    name = least * _K[2] + most
    name ^= name >> np.uint64(32)
    name *= _K[3]
    name ^= name >> np.uint64(29)
    name = np.uint64(0) if start == end else name
    return name if forward else np.uint64(0) - name

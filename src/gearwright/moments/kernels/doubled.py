"""The first ten sums in doubled arithmetic, about 32 digits, for bodies whose terms cancel.

A number is a pair of float64, high and low, |low| ≤ ulp(high)/2; four triangles are added at a time.
Source of the operations: Dekker, Numer. Math. 18 (1971), products with fused multiply-adds.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy as np
from numba.extending import intrinsic

from ...arrays import Array
from ...compiled import compiled
from .lanes import Lanes, Vector, adding
from .pairs import two_sum
from .sums import LANES

_ROWS = 10


class _Doubled:
    """A pair of four numbers each, with the operators of formulas."""

    def __init__(self, high: Lanes, low: Lanes):
        self.high, self.low = high, low

    def __add__(self, other: _Doubled) -> _Doubled:
        high, low = _two_sum(self.high, other.high)
        return _renormalised(high, low + (self.low + other.low))

    def __sub__(self, other: _Doubled) -> _Doubled:
        return self + _Doubled(-other.high, -other.low)

    def __mul__(self, other: _Doubled) -> _Doubled:
        high = self.high * other.high
        low = self.high.times_plus(other.high, -high)
        cross = self.low.times_plus(other.high, self.high * other.low)
        return _renormalised(high, low + cross)


def _two_sum(a: Lanes, b: Lanes) -> tuple[Lanes, Lanes]:
    total = a + b
    b_part = total - a
    return total, (a - (total - b_part)) + (b - b_part)


def _renormalised(high: Lanes, low: Lanes) -> _Doubled:
    total = high + low
    return _Doubled(total, low - (total - high))


def _minus(p: Vector, q: Vector) -> list[_Doubled]:
    return [_Doubled(*_two_sum(p[k], -q[k])) for k in range(3)]


def _terms(a: Vector, b: Vector, c: Vector, origin: Vector) -> list[_Doubled]:
    """Rows 0 to 9 of `sums` for triangles a, b, c."""
    u, v, p = _minus(b, a), _minus(c, a), _minus(a, origin)
    n = [u[i] * v[j] - u[j] * v[i] for i, j in ((1, 2), (2, 0), (0, 1))]
    d = p[0] * n[0] + p[1] * n[1] + p[2] * n[2]
    q, r = ([p[k] + edge[k] for k in range(3)] for edge in (u, v))
    s = [p[k] + q[k] + r[k] for k in range(3)]
    pairs = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
    second = (p[i] * p[j] + q[i] * q[j] + r[i] * r[j] + s[i] * s[j] for i, j in pairs)
    return [d, *(d * x for x in s), *(d * x for x in second)]


def _take(so_far: list[Lanes], a: Vector, b: Vector, c: Vector, origin: Vector) -> list[Lanes]:
    """The sums of high parts, then those of what they lose."""
    highs, lows = so_far[:_ROWS], so_far[_ROWS:]
    for row, term in enumerate(_terms(a, b, c, origin)):
        highs[row], lost = _two_sum(highs[row], term.high)
        lows[row] = lows[row] + (lost + term.low)
    return [*highs, *lows]


_add_triangles = cast(
    "Callable[[Array, Any, int, int, Array, Array], None]", intrinsic(adding(2 * _ROWS, _take, exactly=True))
)


@compiled
def doubled_sums(
    vertices: Array, triangles: Any, start: int, stop: int, origin: Array, high: Array, low: Array
) -> None:
    """Adds triangles `start` to `stop` to the sums high + low, rows 0 to 9 of `sums`, about an origin (3,).

    Numbers of corners must be in range, and no product of five lengths may overflow.
    """
    sums = np.zeros((2 * _ROWS, LANES))
    few = np.empty((3 * LANES + 1, 3))
    alone = np.arange(3 * LANES, dtype=np.int32).reshape(LANES, 3)
    last = len(vertices) - 1
    for first in range(start, stop, LANES):
        count = min(LANES, stop - first)
        # the last vertex has no number after it that could be read with it: such triangles are copied
        copied = count < LANES
        for t in range(first, first + count):
            for corner in range(3):
                copied |= triangles[t, corner] == last
        if not copied:
            _add_triangles(vertices, triangles, first, first + LANES, origin, sums)
            continue
        for place in range(3 * LANES):
            for axis in range(3):  # triangles without area fill the rest
                few[place, axis] = origin[axis]
                if place < 3 * count:
                    few[place, axis] = vertices[triangles[first + place // 3, place % 3], axis]
        _add_triangles(few, alone, 0, LANES, origin, sums)
    for row in range(_ROWS):
        for lane in range(LANES):
            high[row], error = two_sum(high[row], sums[row, lane])
            low[row] += error + sums[_ROWS + row, lane]

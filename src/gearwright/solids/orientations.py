"""Exact signs: on which side of a plane or a line a point lies.

Plain arithmetic decides where its error bound allows; where it does not, the determinant is expanded without any
rounding. Points are rows of an array and are named by number, so that equal numbers give 0 at no cost.
Coordinates must not exceed 1 in magnitude by far, else products overflow; below about 1e-90 they underflow.

Source: Shewchuk, Discrete Comput. Geom. 18 (1997): error bounds (§4), growing expansions (theorem 10).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..compiled import compiled
from ..moments.kernels.pairs import two_product, two_sum

_TURN_BOUND = (3.0 + 16.0 * 2.0**-53) * 2.0**-53
_SIDE_BOUND = (7.0 + 56.0 * 2.0**-53) * 2.0**-53
_MOST_TERMS = 6 * 8 * 4
"""Products of a determinant, parts of each product's factors, parts of each product of three."""


@compiled
def certain_turn(points: Array, i: int, j: int, k: int, axis: int) -> int:
    """`turn`, as far as plain arithmetic can tell: 0 also where it cannot."""
    x, y = (axis + 1) % 3, (axis + 2) % 3
    left = (points[i, x] - points[k, x]) * (points[j, y] - points[k, y])
    right = (points[i, y] - points[k, y]) * (points[j, x] - points[k, x])
    return _sign(left - right, _TURN_BOUND * (abs(left) + abs(right)))


@compiled
def turn(points: Array, i: int, j: int, k: int, axis: int) -> int:
    """Sense (1, 0, −1) in which points i, j, k follow each other, seen against an axis: 1 is counter-clockwise."""
    certain = certain_turn(points, i, j, k, axis)
    if certain != 0 or i == j or j == k or k == i:
        return certain
    high, low = np.zeros((3, 3)), np.zeros((3, 3))
    high[2, 2] = 1.0
    for row in range(2):
        for column in range(2):
            across = (axis + 1 + column) % 3
            point = i if row == 0 else j
            high[row, column], low[row, column] = two_sum(points[point, across], -points[k, across])
    return _determinant_sign(high, low)


@compiled
def certain_side(points: Array, i: int, j: int, k: int, m: int) -> int:
    """`side`, as far as plain arithmetic can tell: 0 also where it cannot."""
    ax, ay, az = points[i, 0] - points[m, 0], points[i, 1] - points[m, 1], points[i, 2] - points[m, 2]
    bx, by, bz = points[j, 0] - points[m, 0], points[j, 1] - points[m, 1], points[j, 2] - points[m, 2]
    cx, cy, cz = points[k, 0] - points[m, 0], points[k, 1] - points[m, 1], points[k, 2] - points[m, 2]
    determinant = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx)
    magnitude = (
        abs(az) * (abs(bx * cy) + abs(by * cx))
        + abs(bz) * (abs(cx * ay) + abs(cy * ax))
        + abs(cz) * (abs(ax * by) + abs(ay * bx))
    )
    return -_sign(determinant, _SIDE_BOUND * magnitude)


@compiled
def side(points: Array, i: int, j: int, k: int, m: int) -> int:
    """Side (1, 0, −1) of the plane through i, j, k on which m lies: 1 is where these run counter-clockwise."""
    certain = certain_side(points, i, j, k, m)
    if certain != 0 or i == j or j == k or k == i or m in (i, j, k):
        return certain
    high, low = np.empty((3, 3)), np.empty((3, 3))
    for column in range(3):
        high[0, column], low[0, column] = two_sum(points[i, column], -points[m, column])
        high[1, column], low[1, column] = two_sum(points[j, column], -points[m, column])
        high[2, column], low[2, column] = two_sum(points[k, column], -points[m, column])
    return -_determinant_sign(high, low)


@compiled
def _sign(value: float, bound: float) -> int:
    return int(value > bound) - int(value < -bound)


@compiled
def _determinant_sign(high: Array, low: Array) -> int:
    """Sign of det(high + low) (3, 3), without rounding."""
    terms = np.empty(_MOST_TERMS)
    count = 0
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        count = _add_product(terms, count, 1.0, high, low, i, j, k)
        count = _add_product(terms, count, -1.0, high, low, i, k, j)
    return _sign(terms[count - 1], 0.0) if count else 0


@compiled
def _add_product(terms: Array, count: int, factor: float, high: Array, low: Array, i: int, j: int, k: int) -> int:
    """Adds ±(row 0, column i)·(row 1, column j)·(row 2, column k) to an expansion; gives its new length."""
    for a in (high[0, i], low[0, i]):
        for b in (high[1, j], low[1, j]):
            if a == 0.0 or b == 0.0:
                continue
            for part in two_product(factor * a, b):
                for c in (high[2, k], low[2, k]):
                    if part == 0.0 or c == 0.0:
                        continue
                    for value in two_product(part, c):
                        count = _grown(terms, count, value)
    return count


@compiled
def _grown(terms: Array, count: int, value: float) -> int:
    """Adds a value to an expansion, parts that do not overlap in rising order; gives its length without zeros."""
    kept = 0
    for n in range(count):
        value, rest = two_sum(value, terms[n])
        if rest != 0.0:
            terms[kept] = rest
            kept += 1
    if value != 0.0:
        terms[kept] = value
        kept += 1
    return kept

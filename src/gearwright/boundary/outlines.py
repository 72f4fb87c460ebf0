"""How closed outlines in one plane lie to each other: apart, nested, or crossing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array, Indices

_BLOCK = 1 << 20  # pairs compared at once


def nearest_approach(one: Array, other: Array) -> tuple[float, Array]:
    """Least distance of two closed polygons (n, 2) and (m, 2), 0 where they cross, and a point (2,) there."""
    crossing = _crossing(one, other)
    if crossing is not None:
        return 0.0, crossing
    pairs = [_least(one, other), _least(other, one)]
    return min(pairs, key=lambda pair: pair[0])


def winding(point: Array, polygon: Array) -> int:
    """Turns of a closed polygon (n, 2) about a point (2,), counter-clockwise positive; on the polygon, either."""
    z = (polygon - point) @ np.array([1.0, 1.0j])
    return round(float(np.sum(np.angle(np.roll(z, -1) * z.conj())) / (2.0 * np.pi)))


def windings(points: Array, polygons: Sequence[Array]) -> Indices:
    """Turns (n,) about points (n, 2) of closed polygons (k, 2) that do not cross themselves, all together."""
    import shapely

    found = np.zeros(len(points), np.int64)
    for polygon in polygons:
        ring = shapely.Polygon(polygon)
        shapely.prepare(ring)
        found += np.where(shapely.contains_xy(ring, points[:, 0], points[:, 1]), int(np.sign(_area(polygon))), 0)
    return found


def _area(polygon: Array) -> float:
    """Twice the area of a closed polygon (n, 2), counter-clockwise positive."""
    following = np.roll(polygon, -1, axis=0)
    return float(np.sum(polygon[:, 0] * following[:, 1] - following[:, 0] * polygon[:, 1]))


def _least(points: Array, polygon: Array) -> tuple[float, Array]:
    """Least distance of points (n, 2) from a closed polygon (m, 2), and the point that has it."""
    start = polygon
    step = np.roll(polygon, -1, axis=0) - start
    square = np.maximum(np.sum(step * step, axis=1), np.finfo(float).tiny)
    best, where = np.inf, points[0]
    rows = max(_BLOCK // len(polygon), 1)
    for block in np.split(points, range(rows, len(points), rows)):
        arms = block[:, None, :] - start
        t = np.clip(np.sum(arms * step, axis=2) / square, 0.0, 1.0)
        distances = np.linalg.norm(arms - t[..., None] * step, axis=2).min(axis=1)
        i = int(np.argmin(distances))
        if distances[i] < best:
            best, where = float(distances[i]), block[i]
    return best, where


def _crossing(one: Array, other: Array) -> Array | None:
    """A point (2,) near which a side of one closed polygon crosses one of the other; None if there is none."""
    a, b = _sides_within(one, other)
    c, d = _sides_within(other, one)
    if not len(a) or not len(c):
        return None
    rows = max(_BLOCK // len(c), 1)
    for first in range(0, len(a), rows):
        p, q = a[first : first + rows, None, :], b[first : first + rows, None, :]
        parted = (_side(p, q, c) * _side(p, q, d) < 0.0) & (_side(c, d, p) * _side(c, d, q) < 0.0)
        if parted.any():
            i, j = np.argwhere(parted)[0]
            start, end = a[first + i], b[first + i]
            u, v = _side(c[j], d[j], start), _side(c[j], d[j], end)
            return start + (end - start) * (u / (u - v))
    return None


def _sides_within(polygon: Array, other: Array) -> tuple[Array, Array]:
    """Starts and ends (k, 2) of the sides of a closed polygon whose boxes meet the other polygon's."""
    start, end = polygon, np.roll(polygon, -1, axis=0)
    low, high = np.minimum(start, end), np.maximum(start, end)
    near = np.all((high >= other.min(axis=0)) & (low <= other.max(axis=0)), axis=1)
    return start[near], end[near]


def _side(a: Array, b: Array, p: Array) -> Array:
    """Twice the area (...) of the triangle a, b, p: positive where p is to the left of the way from a to b."""
    u, v = b - a, p - a
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]

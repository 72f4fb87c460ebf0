"""Where triangles that meet do so: a point of each pair, in plain arithmetic."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled
from ..moments.faces import triangle_vectors

_LEAST = np.finfo(float).tiny
"""Stands for areas that underflow: what such triangles reach is nothing, too."""


def meeting_points(points: Array, triangles: Indices, pairs: Indices) -> Array:
    """A point (k, 3) amid what the triangles of each pair (k, 2) have in common."""
    found = _meeting_points(points, triangles, triangle_vectors(points, triangles), pairs)
    # where what they have in common is thinner than rounding, what their boxes have in common is as near
    corners = points[triangles[pairs]]
    low, high = corners.min(axis=2).max(axis=1), corners.max(axis=2).min(axis=1)
    return np.where(np.isnan(found), (low + high) / 2.0, found)


def depths(points: Array, triangles: Indices, pairs: Indices) -> Array:
    """How far (k,) the shallower triangle of each pair (k, 2) reaches to the other side of the other's plane."""
    reached = np.full(len(pairs), np.inf)
    for one, other in (pairs.T, pairs.T[::-1]):
        offsets = points[triangles[one]] - points[triangles[other][:, :1]]
        vectors = triangle_vectors(points, triangles[other])
        lengths = np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), _LEAST)
        distances = np.einsum("kcx,kx->kc", offsets, vectors / lengths)
        reached = np.minimum(reached, np.minimum(distances.max(axis=1), -distances.min(axis=1)))
    return np.maximum(reached, 0.0)


@compiled
def _meeting_points(points: Array, triangles: Indices, vectors: Array, pairs: Indices) -> Array:
    found = np.empty((len(pairs), 3))
    for n in range(len(pairs)):
        first, second = triangles[pairs[n, 0]], triangles[pairs[n, 1]]
        normal = vectors[pairs[n, 1]]
        # what of the first triangle lies over the second
        polygon = np.empty((8, 3))
        for k in range(3):
            polygon[k] = points[first[k]]
        count = 3
        for k in range(3):
            start, end = points[second[k]], points[second[(k + 1) % 3]]
            polygon, count = _clipped(polygon, count, start, _cross(normal, end - start))
        found[n] = _middle_of_cut(polygon, count, points[second[0]], normal)
    return found


@compiled
def _clipped(polygon: Array, count: int, origin: Array, inward: Array) -> tuple[Array, int]:
    """The part of a convex polygon (count of the rows) on the inner side of a plane."""
    kept = np.empty_like(polygon)
    size = 0
    for k in range(count):
        here, there = polygon[k], polygon[(k + 1) % count]
        at_here, at_there = _dot(here - origin, inward), _dot(there - origin, inward)
        if at_here >= 0.0 and size < len(kept):
            kept[size] = here
            size += 1
        if at_here * at_there < 0.0 and size < len(kept):
            kept[size] = here + (there - here) * (at_here / (at_here - at_there))
            size += 1
    return kept, size


@compiled
def _middle_of_cut(polygon: Array, count: int, origin: Array, normal: Array) -> Array:
    """Middle of the cut of a polygon by a plane; of the whole polygon where it does not cross; NaN for nothing."""
    total, cuts = np.zeros(3), 0
    for k in range(count):
        here, there = polygon[k], polygon[(k + 1) % count]
        at_here, at_there = _dot(here - origin, normal), _dot(there - origin, normal)
        if at_here == 0.0:
            total += here
            cuts += 1
        if at_here * at_there < 0.0:
            total += here + (there - here) * (at_here / (at_here - at_there))
            cuts += 1
    if cuts:
        return total / cuts
    for k in range(count):
        total += polygon[k]
    return total / count if count else np.full(3, np.nan)


@compiled
def _cross(a: Array, b: Array) -> Array:
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


@compiled
def _dot(a: Array, b: Array) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

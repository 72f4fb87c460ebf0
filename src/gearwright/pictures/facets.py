"""Triangles made ready for drawing: welded vertices, and corner normals that are smooth except across creases."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled

CREASE = np.radians(28.0)
"""Faces that meet at less than this look smooth; a fillet of three facets still does, a tooth's tip edge never."""


@dataclass(frozen=True, kw_only=True)
class Facets:
    """What the renderer draws.

    vertices   (n, 3)     points
    triangles  (t, 3)     indices, counter-clockwise seen from outside
    normals    (t, 3, 3)  unit normal at each corner of each triangle
    members    (t,)       which body a triangle belongs to
    """

    vertices: Array
    triangles: Indices
    normals: Array
    members: Indices


def facets(bodies: Sequence[tuple[Array, Indices]], crease: float = float(CREASE)) -> Facets:
    """Facets of bodies given as (vertices, triangles); normals are averaged around a vertex from face to face as long
    as neighbours meet at less than the crease angle, so that each edge is either smooth or sharp from end to end.

    Triangles without area are dropped: they cover no pixel and have no normal.
    """
    made = [_one(vertices, triangles, crease) for vertices, triangles in bodies]
    starts = np.cumsum([0, *(len(vertices) for vertices, _, _ in made)])
    return Facets(
        vertices=np.concatenate([vertices for vertices, _, _ in made]),
        triangles=np.concatenate([triangles + start for start, (_, triangles, _) in zip(starts, made, strict=False)]),
        normals=np.concatenate([normals for _, _, normals in made]),
        members=np.repeat(np.arange(len(made)), [len(triangles) for _, triangles, _ in made]),
    )


def _one(vertices: Array, triangles: Indices, crease: float) -> tuple[Array, Indices, Array]:
    points, triangles = _welded(vertices, triangles)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    crosses = np.cross(b - a, c - a)
    doubled_areas = np.linalg.norm(crosses, axis=-1)
    longest = np.maximum.reduce([np.sum((p - q) ** 2, axis=-1) for p, q in ((a, b), (b, c), (c, a))])
    # a height below 1e-7 of the longest side is rounding, and so is its normal
    real = doubled_areas > 1e-7 * longest
    triangles = np.ascontiguousarray(triangles[real])
    face_normals = crosses[real] / doubled_areas[real, None]
    links = _smooth_links(triangles, face_normals, crease)
    groups = _groups(3 * len(triangles), links)
    weighted = np.repeat(face_normals, 3, axis=0) * _corner_angles(points, triangles).reshape(-1, 1)
    sums = np.stack([np.bincount(groups, weighted[:, axis], 3 * len(triangles)) for axis in range(3)], axis=-1)[groups]
    lengths = np.linalg.norm(sums, axis=-1, keepdims=True)
    # opposite faces may cancel at a pinched vertex: there each face keeps its own normal
    normals = np.where(lengths > 1e-9, sums / np.maximum(lengths, 1e-9), np.repeat(face_normals, 3, axis=0))
    return points, triangles, normals.reshape(-1, 3, 3)


def _welded(vertices: Array, triangles: Indices) -> tuple[Array, Indices]:
    """Vertices without duplicates (2e-6 of the size apart, far below a pixel): a soup of triangles becomes smooth."""
    low = vertices.min(axis=0)
    size = float(np.max(vertices.max(axis=0) - low)) or 1.0
    cells = np.rint((vertices - low) * ((1 << 19) / size)).astype(np.int64)
    keys = (cells[:, 0] << 40) | (cells[:, 1] << 20) | cells[:, 2]
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    return vertices[first], inverse[triangles]


def _corner_angles(points: Array, triangles: Indices) -> Array:
    """Angle of each triangle at each corner, (t, 3): the weights that make a normal independent of the meshing."""
    angles = np.empty(triangles.shape)
    for k in range(3):
        corner = points[triangles[:, k]]
        to_next = points[triangles[:, (k + 1) % 3]] - corner
        to_last = points[triangles[:, (k + 2) % 3]] - corner
        sines = np.linalg.norm(np.cross(to_next, to_last), axis=-1)
        angles[:, k] = np.arctan2(sines, np.sum(to_next * to_last, axis=-1))
    return angles


def _smooth_links(triangles: Indices, face_normals: Array, crease: float) -> Indices:
    """Pairs (m, 2) of corners, numbered 3 t + k, that lie at one end of the same smooth edge."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    corners = np.arange(len(ends))
    next_corners = corners - corners % 3 + (corners + 1) % 3
    turned = ends[:, 0] > ends[:, 1]
    low_corners, high_corners = np.where(turned, next_corners, corners), np.where(turned, corners, next_corners)
    keys = ends.min(axis=1) * (int(triangles.max(initial=0)) + 1) + ends.max(axis=1)
    order = np.argsort(keys)
    one, other = order[:-1], order[1:]
    agreement = np.sum(face_normals[one // 3] * face_normals[other // 3], axis=-1)
    smooth = (keys[one] == keys[other]) & (agreement > np.cos(crease))
    one, other = one[smooth], other[smooth]
    low = np.stack([low_corners[one], low_corners[other]], axis=-1)
    return np.concatenate([low, np.stack([high_corners[one], high_corners[other]], axis=-1)])


@compiled
def _groups(count: int, links: Indices) -> Indices:
    """For each of count corners the smallest number in its linked group: a union-find."""
    parent = np.arange(count)
    for i in range(len(links)):
        a, b = links[i, 0], links[i, 1]
        while parent[a] != a:
            parent[a] = parent[parent[a]]
            a = parent[a]
        while parent[b] != b:
            parent[b] = parent[parent[b]]
            b = parent[b]
        parent[max(a, b)] = min(a, b)
    for i in range(count):
        parent[i] = parent[parent[i]]  # smaller numbers are settled before larger ones
    return parent

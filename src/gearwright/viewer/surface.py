"""The surface of a body as the viewer draws it: shaded faces and sharp edges, as small arrays in text."""

from __future__ import annotations

from base64 import b64encode
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from ..pictures.facets import Facets, facets

SHARP = np.radians(30.0)
"""Faces that meet at more than this have an edge between them."""

_FULL = 32767  # int16


@dataclass(frozen=True, kw_only=True)
class Surface:
    """What is drawn.

    centre     (3,) middle of the box, which positions are relative to, so that float32 holds them wherever they lie
    positions  (n, 3) float32; a vertex on a sharp edge is there once for each smooth side
    normals    (n, 3) int16, of 32767
    triangles  (t, 3) uint32
    edges      (e, 2) uint32, vertices at the ends of sharp edges
    closed     whether every side of a triangle is another one's, the other way round: only then is there an inside
    """

    centre: Array
    positions: Array
    normals: Indices
    triangles: Indices
    edges: Indices
    closed: bool

    def encoded(self) -> dict[str, Any]:
        """The arrays in base 64, as web/src/viewer/data.ts reads them."""
        arrays = {
            "positions": self.positions.astype("<f4"),
            "normals": self.normals.astype("<i2"),
            "triangles": self.triangles.astype("<u4"),
            "edges": self.edges.astype("<u4"),
        }
        texts = {name: b64encode(array.tobytes()).decode() for name, array in arrays.items()}
        return {**texts, "closed": self.closed, "centre": self.centre.tolist()}


def surface(vertices: Array, triangles: Indices) -> Surface:
    """The surface of triangles (t, 3) over vertices (n, 3), counter-clockwise seen from outside."""
    made = facets([(vertices, triangles)], float(SHARP))
    used = vertices[np.unique(triangles)]
    centre = (used.min(axis=0) + used.max(axis=0)) / 2.0
    packed = np.rint(made.normals.reshape(-1, 3) * _FULL).astype(np.int64)
    keys = ((packed[:, 0] + _FULL) << 32) | ((packed[:, 1] + _FULL) << 16) | (packed[:, 2] + _FULL)
    kinds, kind_of = np.unique(keys, return_inverse=True)
    corners = made.triangles.reshape(-1)
    _, first, number = np.unique(corners * len(kinds) + kind_of.reshape(-1), return_index=True, return_inverse=True)
    closed = _closes(triangles)
    renumbered = np.zeros(len(made.vertices), np.int64)
    renumbered[corners[first]] = np.arange(len(first))
    return Surface(
        centre=centre,
        positions=made.vertices[corners[first]] - centre,
        normals=packed[first],
        triangles=number.reshape(-1, 3),
        edges=renumbered[_sharp_edges(made, with_rims=not closed)],
        closed=closed,
    )


def _closes(triangles: Indices) -> bool:
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    count = int(triangles.max()) + 1
    return np.array_equal(np.sort(ends @ [count, 1]), np.sort(ends @ [1, count]))


def _sharp_edges(made: Facets, *, with_rims: bool) -> Indices:
    """Edges (e, 2) where neighbours meet at more than SHARP, and, where wanted, those of one triangle alone."""
    a, b, c = (made.vertices[made.triangles[:, k]] for k in range(3))
    crosses = np.cross(b - a, c - a)
    normals = crosses / np.linalg.norm(crosses, axis=-1, keepdims=True)
    ends = np.stack([made.triangles, np.roll(made.triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    low, high = ends.min(axis=1), ends.max(axis=1)
    order = np.lexsort((high, low))
    same = (low[order[1:]] == low[order[:-1]]) & (high[order[1:]] == high[order[:-1]])
    turn = np.sum(normals[order[1:] // 3] * normals[order[:-1] // 3], axis=-1)
    sharp = order[:-1][same & (turn < np.cos(SHARP))]
    if with_rims:
        shared = np.concatenate([[False], same]) | np.concatenate([same, [False]])
        sharp = np.concatenate([sharp, order[~shared]])
    found = np.unique(np.stack([low[sharp], high[sharp]], axis=-1), axis=0)
    return np.asarray(found, np.int64).reshape(-1, 2)

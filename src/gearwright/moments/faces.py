"""Polygon faces of a polyhedron: fans of triangles, area vectors.

Faces of any sizes are kept in two arrays: `indices` (c,) holds the vertex of every corner, face after
face; face f owns corners offsets[f] to offsets[f + 1] − 1, `offsets` (f + 1,). At least 3 corners a face.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..arrays import Array, ArrayLike, Indices


class Corners(NamedTuple):
    """Faces of any sizes as the two arrays above: a form of faces wherever these are taken."""

    indices: Indices
    offsets: Indices


Faces = ArrayLike | Sequence[ArrayLike] | Corners
"""Integers (m, k), lists of vertex numbers of any lengths, or Corners."""


def corner_lists(faces: Faces) -> Corners:
    """Faces as `indices` and `offsets`; arrays of int64 are not copied.

    Raises ValueError if a face holds anything but integers, or offsets do not go from 0 up to the number of corners.
    """
    if isinstance(faces, Corners):
        return _listed(faces)
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        _require_integers(faces)
        count, corners = faces.shape
        return Corners(
            np.ascontiguousarray(faces, np.int64).reshape(-1), np.arange(count + 1, dtype=np.int64) * corners
        )
    rows = [np.asarray(face) for face in faces]  # type: ignore[union-attr]
    sizes = [row.size for row in rows]
    offsets = np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)]).astype(np.int64)
    for row in rows:
        _require_integers(row)
    return Corners(np.concatenate([np.empty(0, np.int64), *rows]).astype(np.int64), offsets)


def _listed(faces: Corners) -> Corners:
    indices, offsets = np.asarray(faces.indices), np.asarray(faces.offsets)
    _require_integers(indices)
    _require_integers(offsets)
    whole = indices.ndim == offsets.ndim == 1 and len(offsets) and offsets[0] == 0 and offsets[-1] == len(indices)
    if not whole or np.any(np.diff(offsets) < 0):
        raise ValueError("offsets go from 0 up to the number of corners")
    return Corners(indices.astype(np.int64, copy=False), offsets.astype(np.int64, copy=False))


def _require_integers(faces: Array | Indices) -> None:
    if faces.size and faces.dtype.kind not in "iu":
        raise ValueError(f"faces are lists of vertex numbers, whole numbers from 0, not {faces.dtype}")


def fan_triangles(indices: Indices, offsets: Indices) -> Indices:
    """Signed fan of every face from its first corner, (t, 3), face after face.

    Exact for integrals over any planar face, convex or not: where a triangle leaves the face, others
    of the opposite sense cancel it. As a picture only convex faces come out right.
    """
    corners = np.diff(offsets)
    if np.all(corners == 3):
        return indices.reshape(-1, 3)
    first = np.repeat(offsets[:-1], corners - 2)
    before = np.cumsum(corners - 2) - (corners - 2)
    second = first + 1 + np.arange(len(first)) - np.repeat(before, corners - 2)
    return np.stack([indices[first], indices[second], indices[second + 1]], axis=-1)


def next_corners(indices: Indices, offsets: Indices) -> Indices:
    """For every corner (c,) the vertex of the corner after it in its face."""
    following = np.empty_like(indices)
    following[:-1] = indices[1:]
    following[offsets[1:] - 1] = indices[offsets[:-1]]
    return following


def triangle_vectors(vertices: Array, triangles: Indices) -> Array:
    """Area vectors (t, 3) of triangles (t, 3): normal to them, as long as their area."""
    a = vertices[triangles[:, 0]]
    ab = vertices[triangles[:, 1]] - a
    ac = vertices[triangles[:, 2]] - a
    result = np.empty_like(a)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        result[:, k] = 0.5 * (ab[:, i] * ac[:, j] - ab[:, j] * ac[:, i])
    return result


def face_vectors(vertices: Array, indices: Indices, offsets: Indices) -> Array:
    """Area vectors (f, 3) of faces: normal to the mean plane, as long as the area there."""
    vectors = triangle_vectors(vertices, fan_triangles(indices, offsets))
    corners = np.diff(offsets)
    if np.all(corners == 3):
        return vectors
    return np.asarray(np.add.reduceat(vectors, np.cumsum(corners - 2) - (corners - 2), axis=0))

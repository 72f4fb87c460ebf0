"""Vertices and faces as they are given: arrays of their own, and what is wrong with them."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, ArrayLike, Indices
from ..errors import GeometryError, Problem
from ..moments.faces import Faces, corner_lists

_MOST = 1e150
"""Largest coordinate: products of two must be numbers."""


def points_of(vertices: ArrayLike, problems: list[Problem]) -> Array:
    """A copy (n, 3) of vertices; adds what is wrong with them to the problems."""
    try:
        points = np.array(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        problems.append(Problem("vertices", f"an array (n, 3) of numbers is needed ({error})"))
        return np.empty((0, 3))
    if points.size == 0:
        points = points.reshape(0, 3)
    if points.ndim != 2 or points.shape[1] != 3:
        wanted = "an array (n, 3) is needed; further columns, as of weights, must be left out"
        problems.append(Problem(f"vertices of shape {points.shape}", wanted))
        return points.reshape(-1, 1)
    bad = np.flatnonzero(np.any(np.isfinite(points) & (np.abs(points) > _MOST), axis=1))
    if len(bad):
        where = f"vertex {bad[0]} = {points[bad[0]].tolist()}" + (f" and {len(bad) - 1} more" if len(bad) > 1 else "")
        problems.append(Problem(where, f"up to {_MOST:g} products of two are numbers; take another length unit"))
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        where = f"vertex {bad[0]} = {points[bad[0]].tolist()}" + (f" and {len(bad) - 1} more" if len(bad) > 1 else "")
        problems.append(Problem(where, "coordinates must be finite; the file or the program that made it is at fault"))
    return points


def corners_of(faces: Faces, count: int, problems: list[Problem]) -> tuple[Indices, Indices]:
    """Copies of the indices and offsets of faces over `count` vertices; adds what is wrong to the problems."""
    try:
        indices, offsets = corner_lists(faces)
    except (TypeError, ValueError) as error:
        problems.append(Problem("faces", f"an integer array (m, k) or lists of vertex numbers are needed ({error})"))
        return np.empty(0, np.int64), np.zeros(1, np.int64)
    indices, offsets = indices.copy(), offsets.copy()  # the caller's arrays stay the caller's
    short = np.flatnonzero(np.diff(offsets) < 3)
    if len(short):
        sizes = int(np.diff(offsets)[short[0]])
        more = f" and {len(short) - 1} more" if len(short) > 1 else ""
        problems.append(Problem(f"face {short[0]} of {sizes} corners{more}", "at least 3 are needed"))
    bad = np.flatnonzero((indices < 0) | (indices >= count))
    if len(bad):
        face = int(np.searchsorted(offsets, bad[0], side="right")) - 1
        more = f" and {len(bad) - 1} more" if len(bad) > 1 else ""
        problems.append(
            Problem(
                f"vertex number {indices[bad[0]]} in face {face}{more}",
                f"there are vertices 0 to {count - 1}; lists that count from 1 must be lowered by 1",
            )
        )
    return indices, offsets


def affine_map(matrix: ArrayLike) -> Array:
    """The matrix (4, 4) of a map r → A r + t. Raises GeometryError if it is not of that form or flattens bodies."""
    map_ = np.asarray(matrix, float)
    if (
        map_.shape != (4, 4)
        or not np.all(np.isfinite(map_))
        or not np.array_equal(map_[3], [0.0, 0.0, 0.0, 1.0])
        or np.linalg.cond(map_[:3, :3]) > 1e12
    ):
        raise GeometryError(
            "A body cannot be transformed by this matrix",
            [
                Problem(
                    f"matrix of shape {map_.shape}",
                    "[[A, t], [0 0 0 1]] is needed, (4, 4), with an invertible A; points are columns: r → A r + t",
                )
            ],
        )
    return map_

"""Bodies from the vertices and faces of a file: each with its own vertices, all of them used."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array, Indices
from ..moments.faces import Corners


def used_alone(points: Array, faces: Corners) -> tuple[Array, Corners]:
    """The vertices (n, 3) that faces use, in their order, and the faces numbered by these."""
    used = np.zeros(len(points), dtype=bool)
    used[faces.indices] = True
    if used.all():
        return points, faces
    numbers = np.cumsum(used) - 1
    return points[used], Corners(numbers[faces.indices], faces.offsets)


def apart(points: Array, faces: Corners, owners: Indices, count: int) -> Sequence[tuple[Array, Corners]]:
    """The faces of each of so many bodies, and the vertices they use, in their order.

    owners   (f,) body of every face; every body has faces. A vertex of several bodies goes with each.
    """
    if count == 1:
        return [used_alone(points, faces)]
    sizes = np.diff(faces.offsets)
    corner_owners = np.repeat(owners, sizes)
    corner_order = np.argsort(corner_owners, kind="stable")
    sizes = sizes[np.argsort(owners, kind="stable")]
    keys = corner_owners[corner_order] * len(points) + faces.indices[corner_order]
    distinct, numbers = np.unique(keys, return_inverse=True)
    chosen = points[distinct % len(points)]
    bodies = np.arange(count + 1)
    first_vertices = np.searchsorted(distinct, bodies * len(points)).tolist()
    first_faces = np.searchsorted(np.sort(owners), bodies).tolist()
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    result = []
    for k in range(count):
        own = offsets[first_faces[k] : first_faces[k + 1] + 1]
        corners = numbers[own[0] : own[-1]].reshape(-1) - first_vertices[k]
        result.append((chosen[first_vertices[k] : first_vertices[k + 1]], Corners(corners, own - own[0])))
    return result

"""Faces that are there more than once."""

from __future__ import annotations

import numpy as np

from ...arrays import Indices


def doubled_faces(indices: Indices, offsets: Indices, first: Indices) -> tuple[Indices, Indices]:
    """Faces (k,) with the corners of an earlier one in the same order, and (m,) in the opposite order.

    first   (f,) first face of every face's patch

    Where all corners are those of another face, every edge has either more than two faces or just these two, which
    are then a patch by themselves: other faces need not be compared.
    """
    sizes = np.diff(offsets)
    lone = np.bincount(first, minlength=len(sizes))[first] <= 2
    faces = np.flatnonzero(lone)
    same, opposite = [np.empty(0, np.int64)], [np.empty(0, np.int64)]
    for size in np.unique(sizes[faces]):
        chosen = faces[sizes[faces] == size]
        corners = indices[offsets[chosen][:, None] + np.arange(size)]
        corners = _from_least(corners)
        mirrored = np.concatenate([corners[:, :1], corners[:, :0:-1]], axis=1)
        # of the two senses, the one whose second corner is the lesser stands for both
        backward = mirrored[:, 1] < corners[:, 1]
        corners = np.where(backward[:, None], mirrored, corners)
        order = np.lexsort([backward, *corners.T[::-1]])
        alike = np.all(corners[order[1:]] == corners[order[:-1]], axis=1)
        again = backward[order[1:]] == backward[order[:-1]]
        same.append(chosen[order[1:][alike & again]])
        opposite.append(np.maximum(chosen[order[1:]], chosen[order[:-1]])[alike & ~again])
    return np.sort(np.concatenate(same)), np.sort(np.concatenate(opposite))


def _from_least(corners: Indices) -> Indices:
    """Corners (k, n), each row turned to begin with its least number."""
    size = corners.shape[1]
    places = (np.argmin(corners, axis=1)[:, None] + np.arange(size)) % size
    return np.asarray(np.take_along_axis(corners, places, axis=1))

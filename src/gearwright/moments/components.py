"""Connected components of a polyhedron's boundary, and which of them lie inside others."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from .faces import fan_triangles

_BLOCK = 65536


def component_labels(count: int, indices: Indices, offsets: Indices) -> Indices:
    """Number of the connected component of every face (f,), from 0 in the order of first faces.

    count   number of vertices. Faces that share a vertex number belong together.

    Union by the smallest vertex number with pointer jumping, over all corners at once: a few rounds,
    their number about the logarithm of the boundary's diameter.
    """
    parent = np.arange(count)
    first = np.repeat(indices[offsets[:-1]], np.diff(offsets))
    other = indices
    while len(first):
        low, high = parent[first], parent[other]
        apart = low != high
        first, other, low, high = first[apart], other[apart], low[apart], high[apart]
        np.minimum.at(parent, np.maximum(low, high), np.minimum(low, high))
        while True:
            grandparent = parent[parent]
            if np.array_equal(grandparent, parent):
                break
            parent = grandparent
    roots, start, labels = np.unique(parent[indices[offsets[:-1]]], return_index=True, return_inverse=True)
    rank = np.empty(len(roots), dtype=np.int64)
    rank[np.argsort(start)] = np.arange(len(roots))
    return rank[labels.reshape(-1)]


def component_boxes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices) -> Array:
    """Bounding boxes (k, 2, 3) of the components."""
    corner_labels = np.repeat(labels, np.diff(offsets))
    boxes = np.empty((int(labels.max(initial=-1)) + 1, 2, 3))
    boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
    for axis in range(3):
        np.minimum.at(boxes[:, 0, axis], corner_labels, vertices[indices, axis])
        np.maximum.at(boxes[:, 1, axis], corner_labels, vertices[indices, axis])
    return boxes


def component_volumes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, origins: Array) -> Array:
    """Signed volumes (k,), each about a point of its own (k, 3): for their signs, not to sixteen digits."""
    triangles = fan_triangles(indices, offsets)
    owners = np.repeat(labels, np.diff(offsets) - 2)
    a, b, c = (vertices[triangles[:, k]] - origins[owners] for k in range(3))
    sixths = np.einsum("ij,ij->i", a, np.cross(b - a, c - a))
    return np.bincount(owners, sixths, minlength=len(origins)) / 6.0


def containers(boxes: Array) -> list[Indices]:
    """For every box (k, 2, 3) the numbers of the other boxes that it lies in.

    Sweeps along x, so that boxes beside one another are hardly ever compared.
    """
    order = np.lexsort([key for axis in (2, 1, 0) for key in (-boxes[:, 1, axis], boxes[:, 0, axis])])
    result: list[Indices] = [np.empty(0, dtype=np.int64)] * len(boxes)
    active = np.empty(0, dtype=np.int64)
    for k in order:
        active = active[boxes[active, 1, 0] >= boxes[k, 0, 0]]
        inside = np.all(boxes[active, 0] <= boxes[k, 0], axis=1) & np.all(boxes[active, 1] >= boxes[k, 1], axis=1)
        result[k] = active[inside]
        active = np.append(active, k)
    return result


def winding_number(point: Array, vertices: Array, triangles: Indices) -> float:
    """How often closed triangles (t, 3) wind around a point (3,): 1 inside an outward boundary, 0 outside.

    The solid angle they subtend over 4π; about ½ on the boundary itself.
    Source: van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983), eq. (8).
    """
    total = 0.0
    for start in range(0, len(triangles), _BLOCK):
        a, b, c = (vertices[triangles[start : start + _BLOCK, k]] - point for k in range(3))
        la, lb, lc = (np.linalg.norm(p, axis=1) for p in (a, b, c))
        above = np.einsum("ij,ij->i", a, np.cross(b - a, c - a))
        below = la * lb * lc + sum(np.einsum("ij,ij->i", p, q) * r for p, q, r in ((a, b, lc), (b, c, la), (c, a, lb)))
        total += float(np.arctan2(above, below).sum())
    return total / (2.0 * np.pi)

"""Topology of triangles (m, 3), counted the plain way, apart from the package's own checks."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components


def edges_pair_up(triangles: np.ndarray) -> bool:
    """Whether each directed edge occurs once and its reverse once."""
    count = int(triangles.max()) + 1
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    forward, backward = np.sort(start * count + end), np.sort(end * count + start)
    return bool(np.all(np.diff(forward) > 0) and np.array_equal(forward, backward))


def fans_at_vertices(triangles: np.ndarray) -> np.ndarray:
    """Number of separate fans of triangles around each vertex that is used: 1 on a manifold."""
    m, count = len(triangles), int(triangles.max()) + 1
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    corner = np.arange(3 * m)
    following = (corner // 3) * 3 + (corner + 1) % 3
    order = np.argsort(start * count + end)
    mate = order[np.searchsorted((start * count + end)[order], end * count + start)]
    # the corner at an edge's start meets, across the edge, the corner after its mate's start
    links = coo_matrix((np.ones(3 * m), (corner, following[mate])), shape=(3 * m, 3 * m))
    fans, label = connected_components(links, directed=False)
    owner = np.empty(fans, np.int64)
    owner[label] = start
    return np.bincount(owner, minlength=count)


def components(triangles: np.ndarray) -> int:
    """Number of pieces that share no vertex."""
    count = int(triangles.max()) + 1
    ends = triangles[:, :2].ravel(), triangles[:, 1:].ravel()
    links = coo_matrix((np.ones(len(ends[0])), ends), shape=(count, count))
    return int(connected_components(links, directed=False)[0])


def genus(triangles: np.ndarray) -> int:
    """Number of through holes of one closed piece, by Euler's formula."""
    vertices = len(np.unique(triangles))
    return (2 - (vertices - len(triangles) // 2)) // 2


def volume(vertices: np.ndarray, triangles: np.ndarray) -> float:
    """Enclosed volume, by tetrahedra from the middle of the vertices."""
    a, b, c = np.moveaxis((vertices - vertices.mean(axis=0))[triangles], 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0

"""How far points are from the nearest of many triangles: a search through a tree of boxes."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled
from .box_tree import LEAF, box_tree

_DEEP = 64
"""Nodes that wait at most: two a level."""


def distances_to_triangles(points: Array, vertices: Array, triangles: Indices) -> Array:
    """Distances (n,) of points (n, 3) from the nearest of triangles (t, 3) of vertices; infinite without any."""
    if not len(triangles):
        return np.full(len(points), np.inf)
    corners = vertices[triangles]
    order, _, nodes = box_tree(np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1))
    squares = _least_squares(np.ascontiguousarray(points), np.ascontiguousarray(corners[order]), nodes)
    return np.asarray(np.sqrt(squares))


@compiled
def _least_squares(points: Array, corners: Array, nodes: Array) -> Array:
    """Squared distances (n,) of points from the nearest of triangles (t, 3, 3), which are in the tree's order."""
    leaves = len(nodes) // 2
    found = np.empty(len(points))
    waiting = np.empty(_DEEP, np.int64)
    reached = np.empty(_DEEP)
    for i in range(len(points)):
        point = points[i]
        best = np.inf
        waiting[0], reached[0] = 1, 0.0
        depth = 1
        while depth:
            depth -= 1
            node = waiting[depth]
            if reached[depth] >= best:
                continue
            if node >= leaves:
                first = (node - leaves) * LEAF
                for j in range(first, min(first + LEAF, len(corners))):
                    best = min(best, _square_to_triangle(point, corners[j]))
                continue
            near, far = 2 * node, 2 * node + 1
            to_near, to_far = _square_to_box(point, nodes[near]), _square_to_box(point, nodes[far])
            if to_far < to_near:
                near, far, to_near, to_far = far, near, to_far, to_near
            # the nearer one last, so that it is looked at first
            waiting[depth], reached[depth] = far, to_far
            waiting[depth + 1], reached[depth + 1] = near, to_near
            depth += 2
        found[i] = best
    return found


@compiled
def _square_to_box(point: Array, box: Array) -> float:
    square = 0.0
    for axis in range(3):
        off = max(box[axis] - point[axis], point[axis] - box[axis + 3], 0.0)
        square += off * off
    return square


@compiled
def _square_to_triangle(point: Array, corners: Array) -> float:
    """Squared distance of a point from a triangle (3, 3): from its plane where the foot lies in it, else its sides."""
    inside = True
    best = np.inf
    ax, ay, az = corners[1] - corners[0]
    bx, by, bz = corners[2] - corners[0]
    nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    for k in range(3):
        start, end = corners[k], corners[(k + 1) % 3]
        sx, sy, sz = end - start
        px, py, pz = point - start
        # on which side of the plane through this side and the normal the point is
        inside &= (ny * sz - nz * sy) * px + (nz * sx - nx * sz) * py + (nx * sy - ny * sx) * pz >= 0.0
        square = sx * sx + sy * sy + sz * sz
        t = (px * sx + py * sy + pz * sz) / square if square > 0.0 else 0.0
        t = min(max(t, 0.0), 1.0)
        best = min(best, (px - t * sx) ** 2 + (py - t * sy) ** 2 + (pz - t * sz) ** 2)
    square = nx * nx + ny * ny + nz * nz
    if inside and square > 0.0:
        px, py, pz = point - corners[0]
        best = min(best, (nx * px + ny * py + nz * pz) ** 2 / square)
    return best

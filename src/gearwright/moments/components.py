"""Parts of a polyhedron's boundary, each closed by itself: boxes, volumes, and what they wind around.

`labels` (f,) are the numbers of the faces' parts, from 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..compiled import compiled

_BLOCK = 65536

_ON_SURFACE = 1e-14
"""Volume of the corner that a triangle subtends, over the product of its sides, below which rounding hides its sign."""


@compiled
def component_boxes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, count: int) -> Array:
    """Bounding boxes (count, 2, 3) of the parts."""
    boxes = np.empty((count, 2, 3))
    boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
    for f in range(len(labels)):
        box = boxes[labels[f]]
        for c in range(offsets[f], offsets[f + 1]):
            for k in range(3):
                box[0, k] = min(box[0, k], vertices[indices[c], k])
                box[1, k] = max(box[1, k], vertices[indices[c], k])
    return boxes


@compiled
def component_volumes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, origins: Array) -> Array:
    """Signed volumes (k,), each about a point of its own (k, 3): for their signs, not to sixteen digits."""
    volumes = np.zeros(len(origins))
    for f in range(len(labels)):
        o = origins[labels[f]]
        a, first = vertices[indices[offsets[f]]], offsets[f]
        for c in range(first + 1, offsets[f + 1] - 1):
            b, d = vertices[indices[c]], vertices[indices[c + 1]]
            x = (b[1] - a[1]) * (d[2] - a[2]) - (b[2] - a[2]) * (d[1] - a[1])
            y = (b[2] - a[2]) * (d[0] - a[0]) - (b[0] - a[0]) * (d[2] - a[2])
            z = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0])
            volumes[labels[f]] += ((a[0] - o[0]) * x + (a[1] - o[1]) * y + (a[2] - o[2]) * z) / 6.0
    return volumes


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


def windings(
    points: Array, parts: Indices, vertices: Array, indices: Indices, offsets: Indices, labels: Indices
) -> tuple[Indices, NDArray[np.bool_]]:
    """How often closed parts wind around points (p, 3), each around its own point, and which points lie on them (p,).

    parts   (p,) number of the part that is asked about each point

    The faces that a line from the point towards +z passes, with their signs: whole numbers. Whether it passes a face
    is settled edge by edge, alike for both faces there, so that none is missed between two.
    """
    order = np.argsort(parts, kind="stable")
    by_part = np.argsort(labels, kind="stable")
    used, first = np.unique(parts[order], return_index=True)
    faces = np.searchsorted(labels[by_part], np.stack([used, used + 1]))
    result, on = np.zeros(len(points), np.int64), np.zeros(len(points), np.bool_)
    for part, chosen in enumerate(np.split(order, first[1:])):
        if len(chosen):
            its_faces = by_part[faces[0, part] : faces[1, part]]
            result[chosen], on[chosen] = _windings(points[chosen], its_faces, vertices, indices, offsets)
    return result, on


@compiled
def _windings(
    points: Array, faces: Indices, vertices: Array, indices: Indices, offsets: Indices
) -> tuple[Indices, NDArray[np.bool_]]:
    """Of points around chosen faces. A grid of cells in x and y, about one a point, spares most comparisons."""
    side = int(np.sqrt(len(points)))
    low_x, low_y, high_x, high_y = np.inf, np.inf, -np.inf, -np.inf
    for p in range(len(points)):
        low_x, high_x = min(low_x, points[p, 0]), max(high_x, points[p, 0])
        low_y, high_y = min(low_y, points[p, 1]), max(high_y, points[p, 1])
    x_rate = side / (high_x - low_x) if high_x > low_x else 0.0
    y_rate = side / (high_y - low_y) if high_y > low_y else 0.0
    cells, starts = np.empty(len(points), np.int64), np.zeros(side * side + 2, np.int64)
    for p in range(len(points)):
        cells[p] = _cell(points[p, 0], low_x, x_rate, side) * side + _cell(points[p, 1], low_y, y_rate, side)
        starts[cells[p] + 2] += 1
    for cell in range(2, side * side + 2):
        starts[cell] += starts[cell - 1]
    order = np.empty(len(points), np.int64)
    for p in range(len(points)):
        # afterwards a cell's points begin at starts[cell]
        order[starts[cells[p] + 1]] = p
        starts[cells[p] + 1] += 1
    found, on = np.zeros(len(points), np.int64), np.zeros(len(points), np.bool_)
    for f in faces:
        a = vertices[indices[offsets[f]]]
        for corner in range(offsets[f] + 1, offsets[f + 1] - 1):
            b, c = vertices[indices[corner]], vertices[indices[corner + 1]]
            if max(a[0], b[0], c[0]) < low_x or max(a[1], b[1], c[1]) < low_y:
                continue
            if min(a[0], b[0], c[0]) > high_x or min(a[1], b[1], c[1]) > high_y:
                continue
            first = _cell(min(a[1], b[1], c[1]), low_y, y_rate, side)
            last = _cell(max(a[1], b[1], c[1]), low_y, y_rate, side)
            column = _cell(min(a[0], b[0], c[0]), low_x, x_rate, side)
            while column <= _cell(max(a[0], b[0], c[0]), low_x, x_rate, side):
                for place in range(starts[column * side + first], starts[column * side + last + 1]):
                    p = order[place]
                    passed, touched = _passes(points[p], a, b, c)
                    found[p] += passed
                    on[p] |= touched
                column += 1
    return found, on


@compiled
def _cell(coordinate: float, low: float, rate: float, side: int) -> int:
    """Row of cells that a coordinate falls in; the first and the last one go on outward."""
    return int(min(max((coordinate - low) * rate, 0.0), side - 1.0))


@compiled
def _passes(p: Array, a: Array, b: Array, c: Array) -> tuple[int, bool]:
    """Sign of a triangle that the line from a point towards +z passes, else 0; and whether the point is on it."""
    top = max(a[2], b[2], c[2])
    if p[1] < min(a[1], b[1], c[1]) or p[1] > max(a[1], b[1], c[1]) or p[2] > top:
        return 0, False
    turns = _turn(p, a, b) + _turn(p, b, c) + _turn(p, c, a)
    if p[2] < min(a[2], b[2], c[2]):
        return turns, False
    ax, ay, az = a[0] - p[0], a[1] - p[1], a[2] - p[2]
    bx, by, bz = b[0] - p[0], b[1] - p[1], b[2] - p[2]
    cx, cy, cz = c[0] - p[0], c[1] - p[1], c[2] - p[2]
    corner = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    sides = (ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz) * (cx * cx + cy * cy + cz * cz)
    if abs(corner) <= _ON_SURFACE * np.sqrt(sides):
        return 0, True
    return (turns if corner * turns > 0.0 else 0), False


@compiled
def _turn(p: Array, a: Array, b: Array) -> int:
    """1 where an edge, seen along z, passes the line from a point towards +x upwards, −1 downwards, else 0."""
    if (a[1] > p[1]) == (b[1] > p[1]):
        return 0
    upward = b[1] > a[1]
    low, high = (a, b) if upward else (b, a)
    left = (high[0] - low[0]) * (p[1] - low[1]) > (high[1] - low[1]) * (p[0] - low[0])
    if not left:
        return 0
    return 1 if upward else -1

"""How often closed parts of a polyhedron's boundary wind around many points, as whole numbers."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..compiled import compiled

SPACING = 2.0**-49
"""Roundings of coordinates, with those of a plane through them, over the largest: closer points are not told apart."""

_STEEP = 0.25
"""Upward part of a unit normal below which a face counts as steep."""


def windings(
    points: Array, parts: Indices, vertices: Array, indices: Indices, offsets: Indices, labels: Indices
) -> tuple[Indices, NDArray[np.bool_]]:
    """How often closed parts wind around points (p, 3), each around its own point, and of which that is unsure (p,).

    parts   (p,) number of the part that is asked about each point
    labels  (f,) numbers of the faces' parts, from 0

    The faces that a line from the point towards +z passes, with their signs: whole numbers. Whether it passes a face
    is settled edge by edge, alike for both faces there, so that none is missed between two. It is unsure at points
    that lie on a face within rounding, and at a few in the plane of a steep one that is not convex.
    """
    order = np.argsort(parts, kind="stable")
    by_part = np.argsort(labels, kind="stable")
    used, first = np.unique(parts[order], return_index=True)
    faces = np.searchsorted(labels[by_part], np.stack([used, used + 1]))
    result, unsure = np.zeros(len(points), np.int64), np.zeros(len(points), np.bool_)
    for part, chosen in enumerate(np.split(order, first[1:])):
        if len(chosen):
            its_faces = by_part[faces[0, part] : faces[1, part]]
            result[chosen], unsure[chosen] = _windings(points[chosen], its_faces, vertices, indices, offsets)
    return result, unsure


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
    found, unsure = np.zeros(len(points), np.int64), np.zeros(len(points), np.bool_)
    low, high = np.empty(3), np.empty(3)
    for f in faces:
        corners = indices[offsets[f] : offsets[f + 1]]
        near = _face_box(vertices, corners, low, high)
        if high[0] < low_x or high[1] < low_y or low[0] > high_x or low[1] > high_y:
            continue
        first, last = _cell(low[1], low_y, y_rate, side), _cell(high[1], low_y, y_rate, side)
        for column in range(_cell(low[0], low_x, x_rate, side), _cell(high[0], low_x, x_rate, side) + 1):
            for place in range(starts[column * side + first], starts[column * side + last + 1]):
                p = points[order[place]]
                if low[0] <= p[0] <= high[0] and low[1] <= p[1] <= high[1] and p[2] <= high[2]:
                    passed, doubtful = _passes(p, vertices, corners, p[2] < low[2], near)
                    found[order[place]] += passed
                    unsure[order[place]] |= doubtful
    return found, unsure


@compiled
def _cell(coordinate: float, low: float, rate: float, side: int) -> int:
    """Row of cells that a coordinate falls in; the first and the last one go on outward."""
    return int(min(max((coordinate - low) * rate, 0.0), side - 1.0))


@compiled
def _face_box(vertices: Array, corners: Indices, low: Array, high: Array) -> float:
    """Writes a face's box, a little widened, and returns by how much: below that a point is on the face."""
    low[:], high[:] = np.inf, -np.inf
    for corner in corners:
        for k in range(3):
            low[k], high[k] = min(low[k], vertices[corner, k]), max(high[k], vertices[corner, k])
    largest = 0.0
    for k in range(3):
        largest = max(largest, abs(low[k]), abs(high[k]))
    near = SPACING * largest
    for k in range(3):
        low[k] -= near
        high[k] += near
    return near


@compiled
def _passes(p: Array, vertices: Array, corners: Indices, below: bool, near: float) -> tuple[int, bool]:
    """Sign of a face that the line from a point of its box towards +z passes, else 0; and whether that is unsure.

    below   whether the point is below the whole face
    """
    turns, lowest, highest = 0, np.inf, -np.inf
    a = vertices[corners[-1]]
    for corner in corners:
        b = vertices[corner]
        if (a[1] > p[1]) != (b[1] > p[1]):
            upward = b[1] > a[1]
            start, end = (a, b) if upward else (b, a)
            if (end[0] - start[0]) * (p[1] - start[1]) > (end[1] - start[1]) * (p[0] - start[0]):
                turns += 1 if upward else -1
            height = start[2] + (end[2] - start[2]) * ((p[1] - start[1]) / (end[1] - start[1]))
            lowest, highest = min(lowest, height), max(highest, height)
        a = b
    if below:
        return turns, False
    normal = np.zeros(3)
    above, off = _plane(p, vertices, corners, normal)
    if abs(above) <= near + off and _within(p, vertices, corners, normal):
        return 0, True
    if _near_side(p, vertices, corners, near):
        return 0, True
    if p[2] < lowest:
        return turns, False
    if p[2] > highest:
        return 0, False
    if abs(above) > near + off:
        return (turns if above * turns > 0.0 else 0), False
    # in the plane but beside the face: in a shallow plane the line meets no more of it
    return 0, turns != 0 or (len(corners) > 3 and abs(normal[2]) < _STEEP)


@compiled
def _plane(p: Array, vertices: Array, corners: Indices, normal: Array) -> tuple[float, float]:
    """Writes a face's unit normal, 0 without area; its height over a point, along it, and how far corners are off."""
    a = vertices[corners[0]]
    for k in range(1, len(corners) - 1):
        b, c = vertices[corners[k]], vertices[corners[k + 1]]
        for x in range(3):
            y, z = (x + 1) % 3, (x + 2) % 3
            normal[x] += (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y])
    size = np.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2)
    if size > 0.0:
        normal /= size
    above, off = 0.0, 0.0
    for x in range(3):
        above += normal[x] * (a[x] - p[x])
    if len(corners) > 3:
        for corner in corners:
            b = vertices[corner]
            height = normal[0] * (b[0] - a[0]) + normal[1] * (b[1] - a[1]) + normal[2] * (b[2] - a[2])
            off = max(off, abs(height))
    return above, off


@compiled
def _within(p: Array, vertices: Array, corners: Indices, normal: Array) -> bool:
    """Whether a face winds around a point of its plane: seen along the axis that is nearest to the normal."""
    x, y = 0, 1
    if abs(normal[0]) >= max(abs(normal[1]), abs(normal[2])):
        x, y = 1, 2
    elif abs(normal[1]) >= abs(normal[2]):
        x, y = 2, 0
    turns = 0
    a = vertices[corners[-1]]
    for corner in corners:
        b = vertices[corner]
        if (a[y] > p[y]) != (b[y] > p[y]):
            upward = b[y] > a[y]
            start, end = (a, b) if upward else (b, a)
            if (end[x] - start[x]) * (p[y] - start[y]) > (end[y] - start[y]) * (p[x] - start[x]):
                turns += 1 if upward else -1
        a = b
    return turns != 0


@compiled
def _near_side(p: Array, vertices: Array, corners: Indices, near: float) -> bool:
    """Whether a point is on a side of a face, or nearly."""
    a = vertices[corners[-1]]
    for corner in corners:
        b = vertices[corner]
        length, along, distance = 0.0, 0.0, 0.0
        for k in range(3):
            length += (b[k] - a[k]) ** 2
            along += (p[k] - a[k]) * (b[k] - a[k])
        share = min(max(along / length, 0.0), 1.0) if length > 0.0 else 0.0
        for k in range(3):
            distance += (p[k] - a[k] - share * (b[k] - a[k])) ** 2
        if distance <= near * near:
            return True
        a = b
    return False

"""Points of faces, in their inside where they have one: they tell on which side of another surface a shell lies."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...compiled import compiled


@compiled
def face_points(vertices: Array, indices: Indices, offsets: Indices, faces: Indices) -> tuple[Array, Array]:
    """Points (k, 3) inside faces, none of them on a side, and the faces' area vectors (k, 3).

    At a corner of the polygon where it is convex, its triangle with both neighbours is taken: the middle of that, or
    where other corners lie in it, the middle between the corner and the one of these that is farthest from the
    opposite side. Of a polygon without an inside it is the middle of its first side.
    """
    points, areas = np.empty((len(faces), 3)), np.zeros((len(faces), 3))
    for place in range(len(faces)):
        corners = indices[offsets[faces[place]] : offsets[faces[place] + 1]]
        a, area = vertices[corners[0]], areas[place]
        for k in range(1, len(corners) - 1):
            b, c = vertices[corners[k]], vertices[corners[k + 1]]
            for x in range(3):
                y, z = (x + 1) % 3, (x + 2) % 3
                area[x] += ((b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y])) / 2.0
        if len(corners) == 3:
            points[place] = a + ((vertices[corners[1]] - a) + (vertices[corners[2]] - a)) / 3.0
        else:
            points[place] = _inside(vertices, corners, area)
    return points, areas


@compiled
def _inside(vertices: Array, corners: Indices, area: Array) -> Array:
    """A point (3,) inside a polygon of four corners or more."""
    size = len(corners)
    flat = _seen_flat(vertices, corners, area)
    for corner in range(size):
        before, after = (corner - 1) % size, (corner + 1) % size
        whole = _twice_area(flat[before], flat[corner], flat[after])
        if whole <= 0.0:
            continue
        farthest, distance = -1, 0.0
        for other in range(size):
            off = _twice_area(flat[before], flat[other], flat[after])
            if other not in (before, corner, after) and distance < off < whole:
                one = _twice_area(flat[before], flat[corner], flat[other])
                two = _twice_area(flat[corner], flat[after], flat[other])
                if one >= 0.0 and two >= 0.0:
                    farthest, distance = other, off
        a, b = vertices[corners[corner]], vertices[corners[before]]
        if farthest >= 0:
            found = a + (vertices[corners[farthest]] - a) / 2.0
            seen = flat[corner] + (flat[farthest] - flat[corner]) / 2.0
        else:
            found = a + ((b - a) + (vertices[corners[after]] - a)) / 3.0
            seen = flat[corner] + ((flat[before] - flat[corner]) + (flat[after] - flat[corner])) / 3.0
        if _surrounds(flat, seen):
            return found
    a, b = vertices[corners[0]], vertices[corners[1]]
    return a + (b - a) / 2.0


@compiled
def _seen_flat(vertices: Array, corners: Indices, area: Array) -> Array:
    """Corners (n, 2) seen along the axis nearest to the area vector, from where the polygon turns to the left."""
    x, y, z = 0, 1, 2
    if abs(area[0]) >= max(abs(area[1]), abs(area[2])):
        x, y, z = 1, 2, 0
    elif abs(area[1]) >= abs(area[2]):
        x, y, z = 2, 0, 1
    if area[z] < 0.0:
        x, y = y, x
    flat = np.empty((len(corners), 2))
    for corner in range(len(corners)):
        flat[corner, 0], flat[corner, 1] = vertices[corners[corner], x], vertices[corners[corner], y]
    return flat


@compiled
def _twice_area(a: Array, b: Array, c: Array) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


@compiled
def _surrounds(flat: Array, point: Array) -> bool:
    """Whether a polygon winds around a point once to the left, and the point is on none of its sides."""
    turns, a = 0, flat[-1]
    for b in flat:
        off = _twice_area(a, b, point)
        between = (point[0] - a[0]) * (point[0] - b[0]) + (point[1] - a[1]) * (point[1] - b[1])
        length = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
        if between <= 0.0 and abs(off) <= 1e-12 * length:
            return False
        if (a[1] > point[1]) != (b[1] > point[1]):
            upward = b[1] > a[1]
            if (off > 0.0) == upward:
                turns += 1 if upward else -1
        a = b
    return turns == 1

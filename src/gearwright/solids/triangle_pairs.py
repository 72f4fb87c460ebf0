"""How two triangles lie to each other, decided by exact signs only.

Corners are numbers of points; triangles that share numbers are neighbours, and what they share does not count as
meeting. The interiors of two triangles in different planes meet where each has corners on both sides of the other's
plane and their cuts on the common line overlap; two signs decide the overlap once each triangle starts with the corner
that lies alone on its side.

Source: Guigue & Devillers, J. Graphics Tools 8 (2003), for the two signs; separating edges for one plane.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled
from .orientations import certain_side, certain_turn, side, turn

APART, CROSSING, TOUCHING, EDGE_WITHIN, DOUBLED, FACING = range(6)
"""Meet nowhere but in what they share; interiors meet across; touch, at most one of them inside; touch along a side of
one that lies inside the other; overlap in one plane, looking the same way or towards each other."""

_FLAT = -1
Corners = tuple[int, int, int]
Signs = tuple[int, int, int]


@compiled
def projections(points: Array, triangles: Indices) -> Indices:
    """For each triangle an axis (t,) along which it is seen with an area, the best one; −1 if it has none at all."""
    axes = np.empty(len(triangles), np.int64)
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        widest = -1.0
        axes[t] = _FLAT
        for axis in range(3):
            x, y = (axis + 1) % 3, (axis + 2) % 3
            area = abs(
                (points[j, x] - points[i, x]) * (points[k, y] - points[i, y])
                - (points[j, y] - points[i, y]) * (points[k, x] - points[i, x])
            )
            if area > widest and turn(points, i, j, k, axis) != 0:
                widest, axes[t] = area, axis
    return axes


@compiled
def relations(points: Array, triangles: Indices, axes: Indices, pairs: Indices) -> Indices:
    """APART … FACING for each of pairs (k, 2) of triangles; those without area are apart from all."""
    found = np.empty(len(pairs), np.int64)
    for n in range(len(pairs)):
        s, t = pairs[n]
        if axes[s] == _FLAT or axes[t] == _FLAT:
            found[n] = APART
        else:
            first = (triangles[s, 0], triangles[s, 1], triangles[s, 2])
            second = (triangles[t, 0], triangles[t, 1], triangles[t, 2])
            found[n] = _relation(points, first, second, axes[s])
    return found


@compiled
def _relation(points: Array, first: Corners, second: Corners, axis: int) -> int:
    # most pairs are far enough apart for plain arithmetic, and neighbours in one plane always are
    if _all_on_one_side(first, second, _certain_sides(points, first, second)):
        return APART
    if _all_on_one_side(second, first, _certain_sides(points, second, first)):
        return APART
    if _seen_apart(points, first, second, axis) or _seen_apart(points, second, first, axis):
        return APART
    of_first, of_second = _sides(points, first, second), _sides(points, second, first)
    if of_first[0] == of_first[1] == of_first[2] == 0:
        return _relation_in_plane(points, first, second, axis)
    if _all_on_one_side(first, second, of_first) or _all_on_one_side(second, first, of_second):
        return APART
    return _relation_across(points, first, second, of_first, of_second)


@compiled
def edges_within(points: Array, triangles: Indices, pairs: Indices) -> Indices:
    """Of pairs (k, 2) that are EDGE_WITHIN (k, 4): the side's ends, the triangle it lies in, and on which side (1 or
    −1) of that one the other's third corner is."""
    found = np.empty((len(pairs), 4), np.int64)
    for n in range(len(pairs)):
        for one, other in ((pairs[n, 0], pairs[n, 1]), (pairs[n, 1], pairs[n, 0])):
            i, j, k = triangles[other]
            for m in range(3):
                a, b, c = triangles[one, m], triangles[one, (m + 1) % 3], triangles[one, (m + 2) % 3]
                if side(points, i, j, k, a) == 0 and side(points, i, j, k, b) == 0:
                    found[n, 0], found[n, 1] = min(a, b), max(a, b)
                    found[n, 2], found[n, 3] = other, side(points, i, j, k, c)
    return found


@compiled
def _certain_sides(points: Array, triangle: Corners, other: Corners) -> Signs:
    i, j, k = other
    return (
        certain_side(points, i, j, k, triangle[0]),
        certain_side(points, i, j, k, triangle[1]),
        certain_side(points, i, j, k, triangle[2]),
    )


@compiled
def _sides(points: Array, triangle: Corners, other: Corners) -> Signs:
    """Sides of the other's plane on which a triangle's corners lie."""
    i, j, k = other
    return (
        side(points, i, j, k, triangle[0]),
        side(points, i, j, k, triangle[1]),
        side(points, i, j, k, triangle[2]),
    )


@compiled
def _all_on_one_side(triangle: Corners, other: Corners, sides: Signs) -> bool:
    """Whether all corners but the shared ones lie off the other's plane on one side."""
    seen = 0
    for n in range(3):
        if triangle[n] in other:
            continue
        if sides[n] == 0 or sides[n] == -seen:
            return False
        seen = sides[n]
    return seen != 0


@compiled
def _seen_apart(points: Array, triangle: Corners, other: Corners, axis: int) -> bool:
    """Whether, seen along an axis, all of the other but what is shared surely lies beyond one side of a triangle."""
    sense = certain_turn(points, triangle[0], triangle[1], triangle[2], axis)
    if sense == 0:
        return False
    for n in range(3):
        i, j = triangle[n], triangle[(n + 1) % 3]
        beyond = 0
        for corner in other:
            if corner in (i, j) or certain_turn(points, i, j, corner, axis) == -sense:
                beyond += 1
        if beyond == 3:
            return True
    return False


@compiled
def _shared(first: Corners, second: Corners) -> int:
    count = 0
    for corner in first:
        if corner in second:
            count += 1
    return count


@compiled
def _relation_across(points: Array, first: Corners, second: Corners, of_first: Signs, of_second: Signs) -> int:
    """Of triangles in different planes, each with a corner on the other's plane or on both sides of it."""
    lone1, up1 = _lone(of_first)
    lone2, up2 = _lone(of_second)
    p1, q1, r1 = first[lone1], first[(lone1 + 1) % 3], first[(lone1 + 2) % 3]
    p2, q2, r2 = second[lone2], second[(lone2 + 1) % 3], second[(lone2 + 2) % 3]
    # turned over, so that each lone corner lies on the positive side of the other triangle
    if up2 < 0:
        q1, r1 = r1, q1
    if up1 < 0:
        q2, r2 = r2, q2
    one_end, other_end = side(points, p1, q1, p2, q2), side(points, p1, r1, r2, p2)
    if one_end > 0 or other_end > 0:
        return APART
    long = one_end < 0 and other_end < 0  # they share more than a point, if each cuts the line in more than one
    if long and _straddles(of_first) and _straddles(of_second):
        return CROSSING
    long = long and of_first[lone1] != 0 and of_second[lone2] != 0
    if long and (_straddles(of_first) or _straddles(of_second)):
        return EDGE_WITHIN
    shared = _shared(first, second)
    return TOUCHING if shared == 0 or (shared == 1 and long) else APART


@compiled
def _lone(sides: Signs) -> tuple[int, int]:
    """The corner alone on its side, and that side relative to the other two; not all are 0, nor 1, nor −1."""
    for sign in (1, -1):
        if (sides[0] == sign) + (sides[1] == sign) + (sides[2] == sign) == 1:
            return (0 if sides[0] == sign else 1 if sides[1] == sign else 2), sign
    return (0 if sides[0] == 0 else 1 if sides[1] == 0 else 2), -(sides[0] + sides[1] + sides[2]) // 2


@compiled
def _straddles(sides: Signs) -> bool:
    return 1 in sides and -1 in sides


@compiled
def _relation_in_plane(points: Array, first: Corners, second: Corners, axis: int) -> int:
    """Of triangles in one plane, seen along an axis that shows their areas."""
    shared = _shared(first, second)
    sense1 = turn(points, first[0], first[1], first[2], axis)
    sense2 = turn(points, second[0], second[1], second[2], axis)
    gap = max(_gap(points, first, second, axis, sense1, shared), _gap(points, second, first, axis, sense2, shared))
    if gap == 0:
        return DOUBLED if sense1 == sense2 else FACING
    if gap == 2 or shared > 1 or (shared == 1 and not _sides_run_together(points, first, second, axis)):
        return APART
    return TOUCHING


@compiled
def _gap(points: Array, triangle: Corners, other: Corners, axis: int, sense: int, shared: int) -> int:
    """2 if all of the other but what is shared lies beyond a side of a triangle, 1 if beyond or on it, else 0."""
    widest = 0
    for n in range(3):
        beyond, on = 0, 0
        for corner in other:
            where = sense * turn(points, triangle[n], triangle[(n + 1) % 3], corner, axis)
            beyond += where < 0
            on += where == 0
        if beyond + on == 3:
            widest = max(widest, 2 if beyond == 3 - shared else 1)
    return widest


@compiled
def _sides_run_together(points: Array, first: Corners, second: Corners, axis: int) -> bool:
    """Whether sides of both triangles leave the corner they share in the same direction."""
    for corner in first:
        if corner not in second:
            continue
        for i in first:
            for j in second:
                if i == corner or j == corner or turn(points, corner, i, j, axis) != 0:
                    continue
                for k in range(3):
                    if (points[i, k] - points[corner, k]) * (points[j, k] - points[corner, k]) > 0.0:
                        return True
    return False

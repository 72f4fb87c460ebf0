"""Visible surfaces by z-buffer: which triangle each sub-pixel shows, the samples to be lit, and the drawn lines.

All screen coordinates here are sub-pixels: x right, y down, z nearness (larger hides smaller), linear over a triangle.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..compiled import compiled

CREASE_LINE = 1
SILHOUETTE = 2
"""Ink of a sub-pixel: none is 0, a line where two faces meet, a line where something hides something else."""

_LINE_COSINE = float(np.cos(np.radians(16.0)))
_SAME_SURFACE = 0.95
_GROUPS = 4


@compiled
def rasterise(
    points: Array, triangles: Indices, depth: NDArray[np.float32], owner: NDArray[np.int32], first: int, stop: int
) -> None:
    """Draw triangles into rows first…stop of a depth buffer (h, w) and of the index of the triangle seen there.

    points (n, 3) on the screen, triangles (t, 3). A triangle owns the sub-pixels whose centres it contains; edge
    crossings are computed from the same end for both neighbours, so that neighbours leave neither gaps nor overlaps.
    Degenerate and non-finite triangles draw nothing.
    """
    width = depth.shape[1]
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        x0, y0, z0 = points[a, 0], points[a, 1], points[a, 2]
        x1, y1, z1 = points[b, 0], points[b, 1], points[b, 2]
        x2, y2, z2 = points[c, 0], points[c, 1], points[c, 2]
        # most triangles of a fine polyhedron lie between the centres of neighbouring sub-pixels: out with them first
        row_first = int(np.ceil(max(min(y0, y1, y2), first - 1.0) - 0.5))
        row_stop = int(np.ceil(min(max(y0, y1, y2), stop + 1.0) - 0.5))
        column_first = int(np.ceil(max(min(x0, x1, x2), -1.0) - 0.5))
        column_stop = int(np.ceil(min(max(x0, x1, x2), width + 1.0) - 0.5))
        area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if row_first >= row_stop or column_first >= column_stop or not abs(area) > 1e-12:
            continue
        row_first, row_stop = max(first, row_first), min(stop, row_stop)
        slope_x = ((z1 - z0) * (y2 - y0) - (z2 - z0) * (y1 - y0)) / area
        slope_y = ((x1 - x0) * (z2 - z0) - (x2 - x0) * (z1 - z0)) / area
        lowest, highest = min(z0, z1, z2), max(z0, z1, z2)
        for row in range(row_first, row_stop):
            y = row + 0.5
            left, right = np.inf, -np.inf
            for edge in range(3):
                if edge == 0:
                    xa, ya, xb, yb = x0, y0, x1, y1
                elif edge == 1:
                    xa, ya, xb, yb = x1, y1, x2, y2
                else:
                    xa, ya, xb, yb = x2, y2, x0, y0
                if ya > yb:
                    xa, ya, xb, yb = xb, yb, xa, ya
                if ya <= y < yb:
                    x = xa + (y - ya) * ((xb - xa) / (yb - ya))
                    left = min(left, x)
                    right = max(right, x)
            if not left < right:
                continue
            column_first = int(np.ceil(max(left, 0.0) - 0.5))
            column_stop = int(np.ceil(min(right, width + 0.5) - 0.5))
            z = z0 + (y - y0) * slope_y + (column_first + 0.5 - x0) * slope_x
            for column in range(max(column_first, 0), min(column_stop, width)):
                # steep triangles must not shoot beyond their corners
                nearness = min(max(z, lowest), highest)
                if nearness > depth[row, column]:
                    depth[row, column] = nearness
                    owner[row, column] = t
                z += slope_x


@compiled
def _surface(
    points: Array, triangles: Indices, normals: Array, t: int, x: float, y: float
) -> tuple[float, float, float, float, float]:
    """Normal of triangle t at (x, y), on the side the eye sees; its plane's z there and the sum of its slopes."""
    a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
    x0, y0 = points[a, 0], points[a, 1]
    ux, uy = points[b, 0] - x0, points[b, 1] - y0
    vx, vy = points[c, 0] - x0, points[c, 1] - y0
    area = ux * vy - vx * uy
    s = ((x - x0) * vy - (y - y0) * vx) / area
    r = ((y - y0) * ux - (x - x0) * uy) / area
    uz, vz = points[b, 2] - points[a, 2], points[c, 2] - points[a, 2]
    z = points[a, 2] + s * uz + r * vz
    steepness = (abs(uz * vy - vz * uy) + abs(ux * vz - vx * uz)) / abs(area)
    s = min(max(s, 0.0), 1.0)
    r = min(max(r, 0.0), 1.0 - s)
    nx = (1.0 - s - r) * normals[t, 0, 0] + s * normals[t, 1, 0] + r * normals[t, 2, 0]
    ny = (1.0 - s - r) * normals[t, 0, 1] + s * normals[t, 1, 1] + r * normals[t, 2, 1]
    nz = (1.0 - s - r) * normals[t, 0, 2] + s * normals[t, 1, 2] + r * normals[t, 2, 2]
    # y runs down: a face seen from outside has a negative area
    scale = (1.0 if area < 0.0 else -1.0) / max((nx * nx + ny * ny + nz * nz) ** 0.5, 1e-30)
    return nx * scale, ny * scale, nz * scale, z, steepness


@compiled
def collect(
    points: Array, triangles: Indices, normals: Array, members: Indices,
    depth: NDArray[np.float32], owner: NDArray[np.int32], fineness: int, first: int, stop: int,
) -> tuple[Array, Indices]:  # fmt: skip
    """Samples to be lit in pixel rows first…stop: one for each surface in each pixel, so that edges stay smooth.

    returns  (s, 7)  screen point, unit normal (seen axes), share of the pixel;  (s, 3)  pixel row, column, member
    """
    width = owner.shape[1] // fineness
    capacity = (stop - first) * width * _GROUPS
    values = np.empty((capacity, 7))
    places = np.empty((capacity, 3), np.int64)
    count = 0
    share = 1.0 / (fineness * fineness)
    for row in range(first, stop):
        for column in range(width):
            begin = count
            for i in range(fineness * fineness):
                sub_row = row * fineness + i // fineness
                sub_column = column * fineness + i % fineness
                t = owner[sub_row, sub_column]
                if t < 0:
                    continue
                x, y = sub_column + 0.5, sub_row + 0.5
                nx, ny, nz, _, _ = _surface(points, triangles, normals, t, x, y)
                found = -1
                for g in range(begin, count):
                    length = (values[g, 3] ** 2 + values[g, 4] ** 2 + values[g, 5] ** 2) ** 0.5
                    along = nx * values[g, 3] + ny * values[g, 4] + nz * values[g, 5]
                    if places[g, 2] == members[t] and along > _SAME_SURFACE * length:
                        found = g
                        break
                if found < 0 and count - begin == _GROUPS:
                    found = count - 1
                if found < 0:
                    found = count
                    count += 1
                    values[found, 0], values[found, 1], values[found, 2] = x, y, depth[sub_row, sub_column]
                    values[found, 3:7] = 0.0
                    places[found, 0], places[found, 1], places[found, 2] = row, column, members[t]
                values[found, 3] += nx
                values[found, 4] += ny
                values[found, 5] += nz
                values[found, 6] += share
            for g in range(begin, count):
                length = max((values[g, 3] ** 2 + values[g, 4] ** 2 + values[g, 5] ** 2) ** 0.5, 1e-30)
                values[g, 3:6] /= length
    return values[:count].copy(), places[:count].copy()


@compiled
def _meeting(
    points: Array, triangles: Indices, normals: Array, members: Indices,
    depth: NDArray[np.float32], owner: NDArray[np.int32], row: int, column: int, row2: int, column2: int,
) -> int:  # fmt: skip
    """The line between two neighbouring sub-pixels: none, a crease, or a silhouette where one surface hides another."""
    t, t2 = owner[row, column], owner[row2, column2]
    if t == t2:
        return 0
    if t < 0 or t2 < 0 or members[t] != members[t2]:
        return SILHOUETTE
    if depth[row, column] > depth[row2, column2]:
        row, column, row2, column2, t, t2 = row2, column2, row, column, t2, t
    # the farther surface, continued to the nearer sub-pixel: a jump means it goes on behind
    _, _, _, z, steepness = _surface(points, triangles, normals, t, column2 + 0.5, row2 + 0.5)
    if depth[row2, column2] - z > 5.0 + steepness:
        return SILHOUETTE
    # each normal within its own triangle: outside a thin one it means nothing
    nx, ny, nz, _, _ = _surface(points, triangles, normals, t, column + 0.5, row + 0.5)
    mx, my, mz, _, _ = _surface(points, triangles, normals, t2, column2 + 0.5, row2 + 0.5)
    return CREASE_LINE if nx * mx + ny * my + nz * mz < _LINE_COSINE else 0


@compiled
def ink(
    points: Array, triangles: Indices, normals: Array, members: Indices,
    depth: NDArray[np.float32], owner: NDArray[np.int32], first: int, stop: int,
) -> NDArray[np.uint8]:  # fmt: skip
    """Lines in sub-pixel rows first…stop, (stop − first, w): creases two sub-pixels wide, silhouettes four."""
    height, width = owner.shape
    marks = np.zeros((stop - first, width), np.uint8)
    for row in range(max(first - 3, 0), min(stop + 2, height)):
        for column in range(width):
            for down in range(2):
                row2, column2 = row + down, column + 1 - down
                if row2 >= height or column2 >= width or owner[row, column] == owner[row2, column2]:
                    continue
                kind = _meeting(points, triangles, normals, members, depth, owner, row, column, row2, column2)
                for step in range(1 - kind, kind + 1) if kind else range(0):
                    r, c = row + step * down - first, column + step * (1 - down)
                    if 0 <= r < stop - first and 0 <= c < width:
                        marks[r, c] = max(marks[r, c], kind)
    return marks

"""End faces as a page draws them: teeth once, as one sector of a pattern, and what lies within their roots once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from ..arrays import Array, Indices
from ..boundary.edge import EdgeUse
from ..boundary.faces import Cap, CapLoop
from ..boundary.pattern import ALONE, Pattern
from ..boundary.triangulation import signed_area, triangulate_sparsely
from ..curves.curve import turn
from ..surfaces.surface import Surface

_CHART_STEP = 1e-6  # of the chart's extent: what normals are taken from
_FINE = 2.0  # pieces of the line between roots, by the spacing wanted: they cannot be cut finer later
_ROOM = 0.98  # of the distance of the line between roots from the axis, which holes must keep within


class Piece(NamedTuple):
    """Triangles (t, 3) over vertices of their own: positions and outward unit normals (n, 3)."""

    positions: Array
    normals: Array
    triangles: Indices


Used = Callable[[EdgeUse], Array]


def end_face_pieces(
    cap: Cap, used: Used, tolerance: float
) -> tuple[list[tuple[Pattern, Piece]], list[tuple[EdgeUse, Array]]]:
    """An end face as pieces with their patterns, and its normals (n, 3) along each use of an edge.

    used   gives points (n, 3) along a use of an edge, in its sense
    """
    loops = [_around(loop, used) for loop in cap.loops]
    charts = [cap.surface.chart(points) for points in loops]
    sense = float(np.sign(sum(map(signed_area, charts))))
    pieces = _apart(cap, charts, tolerance) or [(ALONE, charts, triangulate_sparsely(cap.surface, charts, tolerance))]
    found = []
    for pattern, own, (inner, triangles) in pieces:
        chart = np.concatenate([*own, inner])
        piece = Piece(cap.surface.point(chart), sense * _normals(cap.surface, chart), triangles)
        found.append((pattern, piece))
    if len(found) == 1:
        found[0][1].positions[: sum(map(len, loops))] = np.concatenate(loops)  # to the last digit those of the edges
    at_border = [
        (use, sense * _normals(cap.surface, cap.surface.chart(used(use)))) for loop in cap.loops for use in loop.uses
    ]
    return found, at_border


def _around(loop: CapLoop, used: Used) -> Array:
    """Points (n, 3) once around a loop of an end face in its sense."""
    images = loop.pattern.images(np.concatenate([used(use)[:-1] for use in loop.uses]))
    if loop.uses[-1].edge.end_turn < 0:
        images = images[::-1]  # they follow one another clockwise
    points = images.reshape(-1, 3)
    return points[::-1] if loop.reverse else points


_Part = tuple[Pattern, Sequence[Array], tuple[Array, Indices]]


def _apart(cap: Cap, charts: Sequence[Array], tolerance: float) -> list[_Part] | None:
    """One tooth of the outer loop, cut off between the deepest points of its roots, and the rest.

    None where the loop does not repeat about the chart's origin, or a hole reaches beyond the roots.
    """
    pattern, outer = cap.loops[0].pattern, charts[0]
    count = len(outer) // pattern.order
    if pattern.order < 3 or count < 3:
        return None
    radii = np.linalg.norm(outer, axis=1)
    offset = int(np.argmin(radii[:count]))
    holes = max((float(np.linalg.norm(chart, axis=1).max()) for chart in charts[1:]), default=0.0)
    if holes > _ROOM * radii[offset] * np.cos(np.pi / pattern.order):
        return None
    sense = 1.0 if signed_area(outer) > 0.0 else -1.0
    onward = turn(sense * 2.0 * np.pi / pattern.order, 2)
    period = np.roll(outer, -offset, axis=0)[:count]
    start, end = period[0], onward @ period[0]
    spacing = float(np.min(cap.surface.spacing(tolerance, period[:1])))
    pieces = max(1, int(np.ceil(_FINE * float(np.linalg.norm(end - start)) / spacing)))
    cut = start + np.arange(1, pieces)[:, None] / pieces * (end - start)
    tooth = np.concatenate([period, [end], cut[::-1]])
    ring = np.concatenate([start[None], cut])
    turns = np.stack([np.linalg.matrix_power(onward, k) for k in range(pattern.order)])
    core = [(ring @ np.swapaxes(turns, 1, 2)).reshape(-1, 2), *charts[1:]]
    return [
        (pattern, [tooth], triangulate_sparsely(cap.surface, [tooth], tolerance)),
        (ALONE, core, triangulate_sparsely(cap.surface, core, tolerance)),
    ]


def _normals(surface: Surface, chart: Array) -> Array:
    """Natural unit normals (n, 3) of a surface at coordinates (n, 2) of its chart."""
    step = _CHART_STEP * float(np.max(np.ptp(chart, axis=0)))
    first, second = (surface.point(chart + step * axis) - surface.point(chart - step * axis) for axis in np.eye(2))
    return unit(np.cross(first, second))


def unit(vectors: Array) -> Array:
    """Vectors (..., 3) of length 1; those of length 0 as they are."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)

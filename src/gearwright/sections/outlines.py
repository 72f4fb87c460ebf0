"""Loops from what a person gives: corners, points of a spline, curves; in either sense."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.curve import Curve, chain_quadrature
from ..curves.line import lines_through
from ..curves.spline import spline_spans
from ..errors import GeometryError, Problem
from ..moments.boundary_integral import plane_moments
from .crossing import crossing_problems
from .loop import Loop

SMALLEST, LARGEST = 1e-15, 1e15
"""Sizes and coordinates whose fifth powers, and the ratios of them, stay numbers."""
_COINCIDENT = 1e-12  # of the outline's size: points closer are one point given twice
_NODES = 20


def polygon_loop(points: ArrayLike, name: str, sense: int) -> Loop:
    """The loop of straight lines from corner to corner (n, 2), turned to run in the sense (±1).

    The first corner may be repeated at the end. Raises GeometryError for fewer than three, for corners that are
    not finite or coincide with the next.
    """
    corners = _outline_points(points, name)
    return curve_loop(lines_through(np.concatenate([corners, corners[:1]])), name, sense)


def spline_loop(points: ArrayLike, name: str, sense: int) -> Loop:
    """The loop of the periodic cubic spline through points (n, 2), turned to run in the sense (±1); errors as above."""
    corners = _outline_points(points, name)
    return curve_loop(spline_spans(np.concatenate([corners, corners[:1]]), closed=True), name, sense)


def curve_loop(curves: Sequence[Curve], name: str, sense: int) -> Loop:
    """The loop of curves, turned to run in the sense (±1). Raises GeometryError where it does not close."""
    if not all(isinstance(curve, Curve) for curve in curves):
        raise GeometryError(
            "This is not a section", [Problem(f"{name} = {curves!r}", "a sequence of curves is needed")]
        )
    loop = Loop(curves=tuple(curves))
    points, tangents = chain_quadrature(loop.curves, _NODES)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
    area = float(plane_moments(points - middle, tangents)[0, 0])
    size = float(np.max(np.ptp(points, axis=0)))
    if abs(area) <= _COINCIDENT * size**2:
        nothing = Problem(f"{name} of area {abs(area):.3g}", "it encloses nothing")
        raise GeometryError("This is not a section", [nothing, *crossing_problems([loop])])
    if area * sense > 0.0:
        return loop
    return Loop(curves=tuple(curve.reversed() for curve in reversed(loop.curves)))


def _outline_points(points: ArrayLike, name: str) -> Array:
    """The points (n, 2) of a closed outline, each once."""
    try:
        found = np.array(points, float)
    except (TypeError, ValueError, OverflowError) as error:
        raise GeometryError("This is not a section", [Problem(name, f"an array (n, 2) is needed ({error})")]) from error
    if found.ndim != 2 or found.shape[1:] != (2,):
        raise GeometryError(
            "This is not a section", [Problem(f"{name} of shape {found.shape}", "points are an array (n, 2)")]
        )
    bad = np.flatnonzero(~(np.abs(found) <= LARGEST).all(axis=1))
    wanted = f"coordinates must be finite, and at most {LARGEST:g}"
    problems = [Problem(f"{name}, point {i} = {found[i].tolist()}", wanted) for i in bad[:3]]
    if not problems:
        if len(found) > 1 and np.array_equal(found[0], found[-1]):
            found = found[:-1]
        problems = _coincidences(found, name)
    if problems:
        raise GeometryError("This is not a section", problems)
    return found


def _coincidences(points: Array, name: str) -> list[Problem]:
    if len(points) < 3:
        return [Problem(f"{name} of {len(points)} points", "at least 3 different ones are needed")]
    steps = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    same = np.flatnonzero(steps <= _COINCIDENT * np.max(np.ptp(points, axis=0)))
    more = f" (and {len(same) - 1} more such pairs)" if len(same) > 1 else ""
    return [
        Problem(
            f"{name}, points {i} and {(i + 1) % len(points)} at ({points[i, 0]:.6g}, {points[i, 1]:.6g}){more}",
            "coincide; leave one of them out",
        )
        for i in same[:1]
    ]

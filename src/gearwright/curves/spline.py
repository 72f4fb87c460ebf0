"""Cubic splines through points, as chains of Bézier curves."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .bezier import Bezier


def cubic_spline(points: Array, *, closed: bool) -> tuple[Array, Array]:
    """Parameters (n,) and derivatives (n, d) at the points (n, d) of the cubic spline through them.

    closed   the last point is the first one again, and the spline is periodic; else its third derivative
             runs on through the second and the last but one point ("not a knot")

    Twice continuously differentiable in the parameter, which grows by the distance from point to point.
    Neighbouring points must differ.
    """
    from scipy.interpolate import CubicSpline

    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    spline = CubicSpline(knots, points, bc_type="periodic" if closed else "not-a-knot")
    return knots, spline(knots, 1)


def spline_spans(points: Array, *, closed: bool) -> tuple[Bezier, ...]:
    """The spans (n − 1) of the cubic spline through points (n, d), each from one of them to the next."""
    knots, slopes = cubic_spline(points, closed=closed)
    thirds = np.diff(knots)[:, None] / 3.0
    control = np.stack(
        [points[:-1], points[:-1] + slopes[:-1] * thirds, points[1:] - slopes[1:] * thirds, points[1:]], axis=1
    )
    return tuple(Bezier(control=tuple(map(tuple, span.tolist()))) for span in control)

"""B-splines, polynomial and rational, as chains of Bézier curves."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .bezier import Bezier
from .rational_bezier import RationalBezier


def bspline_spans(
    degree: int, knots: Array, control: Array, weights: Array | None = None
) -> tuple[Bezier | RationalBezier, ...]:
    """The spans of the B-spline of degree p, one a knot interval of some length in [t_p, t_n], exactly.

    knots     t (n + p + 1,), ascending; the ends need not be clamped
    control   P (n, d)
    weights   (n,), > 0; equal ones give polynomials

    The control points of a span [s, t] are the values of its polar form at p − k times s and k times t
    (Ramshaw, Blossoms are polar forms, CAGD 6, 1989, §4).
    """
    rational = weights is not None and np.ptp(weights) > 0.0
    w = np.ones(len(control)) if weights is None else weights
    homogeneous = np.column_stack([control * w[:, None], w]) if rational else control
    spans = []
    for i in range(degree, len(control)):
        if knots[i] < knots[i + 1]:
            ends = [[knots[i]] * (degree - k) + [knots[i + 1]] * k for k in range(degree + 1)]
            spans.append(np.array([_polar(degree, knots, homogeneous, i, arguments) for arguments in ends]))
    return tuple(_rational(span) if rational else Bezier(control=_tuples(span)) for span in spans)


def _polar(degree: int, knots: Array, control: Array, i: int, arguments: list[float]) -> Array:
    """The polar form of the span [t_i, t_i+1] at p arguments: de Boor's scheme, another argument each round."""
    d = control[i - degree : i + 1]
    for r, t in enumerate(arguments, 1):
        low, high = knots[i - degree + r : i + 1], knots[i + 1 : i + 1 + degree - r + 1]
        share = ((t - low) / (high - low))[:, None]
        d = d[:-1] * (1.0 - share) + d[1:] * share
    return d[0]


def _rational(span: Array) -> RationalBezier:
    weights = span[:, -1]
    return RationalBezier(control=_tuples(span[:, :-1] / weights[:, None]), weights=tuple(weights.tolist()))


def _tuples(points: Array) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, points.tolist()))

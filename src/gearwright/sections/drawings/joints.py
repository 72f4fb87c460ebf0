"""Curves whose ends nearly meet, fitted to one another: a loop then closes to the last digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...curves.arc import Arc
from ...curves.bezier import Bezier
from ...curves.curve import Curve
from ...curves.elliptic_arc import EllipticArc
from ...curves.line import Line
from ...curves.rational_bezier import FLAT, RationalBezier, flat_arc

_ROUNDING = 8.0 * float(np.finfo(float).eps)
"""A gap this small, relative to the coordinates, is what computing the ends of an arc leaves."""


def fitted(chain: Sequence[Curve]) -> tuple[Curve, ...]:
    """The closed chain with every gap closed; no point of it moves by much more than the gaps next to it.

    Where one of two ends is an arc's, the other one moves to it; else both move to the middle. A line and
    a Bézier curve move their end alone; an arc is turned and scaled about, and in two halves if it is longer
    than a half circle, since a turn about near ends would move the far side by more than the gap.
    """
    starts, ends = np.array([c.start for c in chain]), np.array([c.end for c in chain])
    small = _ROUNDING * float(max(np.abs(starts).max(), np.abs(ends).max()))
    befores = np.roll(ends, 1, axis=0)
    stiff = np.array([isinstance(c, Arc | EllipticArc) for c in chain])
    share = 0.5 + 0.5 * (stiff.astype(float) - np.roll(stiff, 1))[:, None]
    nodes = starts * share + befores * (1.0 - share)
    apart = np.linalg.norm(starts - befores, axis=1) > small
    first = np.where(apart[:, None], nodes, starts)
    last = np.roll(np.where(apart[:, None], nodes, befores), -1, axis=0)
    return tuple(part for c, a, b in zip(chain, first, last, strict=True) for part in _between(c, a, b))


def _between(curve: Curve, start: Array, end: Array) -> tuple[Curve, ...]:
    """The curve with its ends moved to `start` and `end`."""
    if np.array_equal(curve.start, start) and np.array_equal(curve.end, end):
        return (curve,)
    match curve:
        case Line():
            return (Line(first=tuple(start.tolist()), last=tuple(end.tolist())),)
        case Bezier() | RationalBezier():
            first, last = (start, end) if curve.interval[0] < curve.interval[1] else (end, start)
            return (replace(curve, control=(tuple(first.tolist()), *curve.control[1:-1], tuple(last.tolist()))),)
        case Arc() | EllipticArc():
            a, b = curve.interval
            if isinstance(curve, Arc) and abs(b - a) < FLAT:
                return (flat_arc(start, end, b - a),)
            if abs(b - a) <= np.pi * (1.0 + 1e-9):
                return (_similar(curve, start, end),)
            half = (a + b) / 2.0
            middle = curve.point(half)
            return (
                _similar(replace(curve, interval=(a, half)), start, middle),
                _similar(replace(curve, interval=(half, b)), middle, end),
            )
    raise TypeError(f"drawings hold no {type(curve).__name__}")


def _similar(arc: Arc | EllipticArc, start: Array, end: Array) -> Arc | EllipticArc:
    """The arc under the similarity that brings its ends to `start` and `end`."""
    old, new = complex(*arc.start), complex(*start)
    factor = (complex(*end) - new) / (complex(*arc.end) - old)
    centre = new + factor * (complex(*arc.centre) - old)
    where = (centre.real, centre.imag)
    if isinstance(arc, Arc):
        angle = float(np.angle(factor))
        a, b = arc.interval
        return replace(arc, centre=where, radius=arc.radius * abs(factor), interval=(a + angle, b + angle))
    u, v = factor * complex(*arc.a), factor * complex(*arc.b)
    return replace(arc, centre=where, a=(u.real, u.imag), b=(v.real, v.imag))

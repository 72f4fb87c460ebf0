"""Curves of a section as what a drawing is made of, exact wherever the drawing has such a thing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array
from ...curves.arc import Arc
from ...curves.bezier import Bezier
from ...curves.curve import Curve, Mapped
from ...curves.elliptic_arc import EllipticArc
from ...curves.line import Line
from ...curves.rational_bezier import RationalBezier
from .fitting import cubics_along
from .primitives import Free, Primitive, Straight, round_arc

_ROUND = 64.0 * float(np.finfo(float).eps)
"""Half axes that differ by less, or are as near to square, are those of a circle under turns and mirrorings."""


@dataclass(frozen=True, kw_only=True)
class Hand:
    """Which splines a format holds. degree   the highest; rational   whether with weights"""

    degree: int
    rational: bool


def stroke(curve: Curve, tolerance: float, hand: Hand) -> Primitive:
    """A plane curve as a primitive: lines, arcs and the splines that the format holds as they are, others as cubic
    splines within the tolerance. Raises GeometryError where there are none.
    """
    inner, matrix, offset = _unwrapped(curve)
    found: Primitive | None = None
    match inner:
        case Line():
            found = Straight(start=curve.start, end=curve.end)
        case Arc():
            axes = matrix * inner.radius
            found = round_arc(_image(inner.centre, matrix, offset), axes[:, 0], axes[:, 1], curve.interval, _ROUND)
        case EllipticArc():
            a, b = matrix @ np.array(inner.a), matrix @ np.array(inner.b)
            found = round_arc(_image(inner.centre, matrix, offset), a, b, curve.interval, _ROUND)
        case Bezier() | RationalBezier():
            found = _free(inner, curve.interval, matrix, offset, hand)
    return Free(control=cubics_along(curve, tolerance)) if found is None else found


def _unwrapped(curve: Curve) -> tuple[Curve, Array, Array]:
    """What is mapped, and the whole map p → A p + b."""
    matrix, offset = np.eye(2), np.zeros(2)
    while isinstance(curve, Mapped):
        own = np.array(curve.matrix)
        offset = offset + matrix @ (np.array(curve.offset) if curve.offset else np.zeros(2))
        matrix, curve = matrix @ own, curve.curve
    return curve, matrix, offset


def _image(point: tuple[float, ...], matrix: Array, offset: Array) -> Array:
    return matrix @ np.array(point, float) + offset


def _free(
    curve: Bezier | RationalBezier, interval: tuple[float, float], matrix: Array, offset: Array, hand: Hand
) -> Primitive | None:
    """The Bézier curve from one parameter to another under the map, or None where the format does not hold it."""
    control = np.array(curve.control, float)
    rational = isinstance(curve, RationalBezier) and len(set(curve.weights)) > 1
    if len(control) - 1 > hand.degree or (rational and not hand.rational):
        return None
    weights = np.array(curve.weights) if isinstance(curve, RationalBezier) and rational else np.ones(len(control))
    homogeneous = _part(np.column_stack([control * weights[:, None], weights]), *interval)
    own = homogeneous[:, 2]
    points = (homogeneous[:, :2] / own[:, None]) @ matrix.T + offset
    if len(points) == 2:
        return Straight(start=points[0], end=points[1])
    return Free(control=points[None], weights=own if rational else None)


def _part(control: Array, start: float, end: float) -> Array:
    """Control points (n, d) of a Bézier curve from one parameter to another, by its polar form."""
    if (start, end) in ((0.0, 1.0), (1.0, 0.0)):
        return control if start == 0.0 else control[::-1]
    degree = len(control) - 1
    return np.array([_polar(control, [start] * (degree - k) + [end] * k) for k in range(degree + 1)])


def _polar(control: Array, arguments: list[float]) -> Array:
    """The polar form of a Bézier curve: de Casteljau's scheme, another argument each round."""
    points = control
    for t in arguments:
        points = points[:-1] * (1.0 - t) + points[1:] * t
    return points[0]

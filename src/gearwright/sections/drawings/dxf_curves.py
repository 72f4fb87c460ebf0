"""DXF entities as exact curves of the plane z = constant."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from ...arrays import Array
from ...curves.arc import Arc
from ...curves.bspline import bspline_spans
from ...curves.curve import Curve
from ...curves.elliptic_arc import EllipticArc
from ...curves.line import Line, lines_through
from ...curves.rational_bezier import FLAT, flat_arc
from ...errors import FileError
from .listing import place

_LEVEL = 1e-9
"""Largest slope of an outline's plane: ten digits of a normal that is written as (0, 0, ±1) in truth."""

_ONCE_ROUND = 1e-6
"""Angles from 0 to 2π as six decimals give them; less than the gap that a joint closes."""

_SAME_ANGLE = 1e-12
"""Angles that differ by rounding; an arc so short has no length."""

_STRAIGHT = 1e-8
"""A bulge this small bends by less than its arc's coordinates, whose radius is chord / (4 bulge), are rounded."""

_SPLINE_FRAME = 16
"""Flag of a polyline's vertex that only steers a spline and is not on the line."""


class Unusable(ValueError):
    """An entity that is an outline, but of which no exact plane curve can be had; says why."""


def curves_of(source: str, entity: Any) -> tuple[list[Curve], set[float]]:
    """The curves of an entity of a kind in `OUTLINES`, and the heights z at which it lies.

    Raises FileError where it has none, naming the entity and its layer.
    """
    kind = entity.dxftype()
    try:
        curves, heights = _READERS[kind](entity)
    except Unusable as error:
        raise FileError(f"{source}: {kind} on layer {entity.dxf.layer} {error}") from None
    return list(curves), {float(z) for z in heights}


def _line(entity: Any) -> tuple[list[Curve], list[float]]:
    return _lines(np.array([entity.dxf.start, entity.dxf.end], float))


def _lines(points: Array) -> tuple[list[Curve], list[float]]:
    return [*lines_through(points[:, :2])], points[:, 2].tolist()


def _arc(entity: Any) -> tuple[list[Curve], list[float]]:
    """ARC and CIRCLE; where z of their own system points down, that system is mirrored: x runs to −x."""
    if entity.dxftype() == "CIRCLE":
        a, b = 0.0, 2.0 * np.pi
    else:
        a, b = _turn(*np.radians([entity.dxf.start_angle, entity.dxf.end_angle]).tolist())
    radius = abs(float(entity.dxf.radius))
    up, centre = _up(entity), entity.ocs().to_wcs(entity.dxf.center)
    interval = (a, b) if up > 0.0 else (np.pi - a, np.pi - b)
    arc = Arc(radius=radius, centre=(centre.x, centre.y), interval=interval)
    return ([arc] if radius > 0.0 else []), [centre.z]


def _ellipse(entity: Any) -> tuple[list[Curve], list[float]]:
    _up(entity)
    centre, a, b = entity.dxf.center, entity.dxf.major_axis, entity.minor_axis
    interval = _turn(float(entity.dxf.start_param), float(entity.dxf.end_param))
    return [EllipticArc(centre=(centre.x, centre.y), a=(a.x, a.y), b=(b.x, b.y), interval=interval)], [centre.z]


def _turn(start: float, end: float) -> tuple[float, float]:
    """The angles of an arc that runs counter-clockwise from start to end. Raises Unusable where they are one."""
    whole = 2.0 * np.pi
    if abs(end - start - whole) <= _ONCE_ROUND:
        return start, start + whole
    sweep = (end - start) % whole
    if min(sweep, whole - sweep) <= _SAME_ANGLE:
        raise Unusable(
            f"starts and ends at {np.degrees(start):.9g}°, which is nothing to some programs and once round to others; "
            "draw a whole circle or ellipse, or delete it"
        )
    return start, start + sweep


def _lwpolyline(entity: Any) -> tuple[list[Curve], list[float]]:
    vertices = np.array(entity.get_points("xyb"), float).reshape(-1, 3)
    return _bulged(entity, vertices, float(entity.dxf.elevation), closed=bool(entity.closed))


def _polyline(entity: Any) -> tuple[list[Curve], list[float]]:
    vertices = [v for v in entity.vertices if not v.dxf.flags & _SPLINE_FRAME]
    points = np.array([v.dxf.location for v in vertices], float).reshape(-1, 3)
    if entity.is_3d_polyline:
        return _lines(np.concatenate([points, points[:1]]) if entity.is_closed else points)
    bulges = np.array([v.dxf.get("bulge", 0.0) for v in vertices], float)
    elevation = float(points[0, 2]) if len(points) else 0.0
    return _bulged(entity, np.column_stack([points[:, :2], bulges]), elevation, closed=bool(entity.is_closed))


def _bulged(entity: Any, vertices: Array, elevation: float, *, closed: bool) -> tuple[list[Curve], list[float]]:
    """Lines and arcs between vertices (n, 3): x, y and the bulge of the side that begins there."""
    up = _up(entity)
    points, bulges = vertices[:, :2] * [up, 1.0], vertices[:, 2] * up
    follow = range(len(points) if closed else len(points) - 1)
    sides = ((points[i], points[(i + 1) % len(points)], bulges[i]) for i in follow)
    return [side for a, b, bulge in sides for side in _side(a, b, float(bulge))], [elevation * up]


def _side(a: Array, b: Array, bulge: float) -> Iterator[Curve]:
    """The side from a to b; the bulge is the tangent of a quarter of the angle it turns by, to the left."""
    if np.array_equal(a, b):
        return
    if abs(bulge) <= _STRAIGHT:
        yield Line(first=tuple(a.tolist()), last=tuple(b.tolist()))
        return
    chord = b - a
    angle = 4.0 * float(np.arctan(bulge))
    if abs(angle) < FLAT:
        yield flat_arc(a, b, angle)
        return
    centre = (a + b) / 2.0 + np.array([-chord[1], chord[0]]) * (1.0 - bulge) * (1.0 + bulge) / (4.0 * bulge)
    radius = float(np.hypot(*chord)) * (1.0 + bulge**2) / (4.0 * abs(bulge))
    first = float(np.arctan2(*(a - centre)[::-1]))
    yield Arc(radius=radius, centre=tuple(centre.tolist()), interval=(first, first + angle))


def _spline(entity: Any) -> tuple[list[Curve], list[float]]:
    degree = int(entity.dxf.degree)
    control = np.array(entity.control_points, float).reshape(-1, 3)
    knots, weights = np.array(entity.knots, float), np.array(entity.weights, float)
    if not len(control):
        raise Unusable(
            f"starts at {place(np.array(entity.fit_points[0]))} and has fit points only, through which programs draw "
            "different curves; export it with its control points"
            if len(entity.fit_points)
            else "has no control points; delete it"
        )
    start = f"with its first control point at {place(control[0])}"
    if not (1 <= degree <= _HIGHEST_DEGREE and len(control) > degree and len(knots) == len(control) + degree + 1):
        raise Unusable(
            f"{start} has degree {degree}, {len(control)} control points and {len(knots)} knots; "
            f"knots are control points + degree + 1, and the degree is 1 to {_HIGHEST_DEGREE}"
        )
    if len(weights) not in (0, len(control)) or not np.all(weights > 0.0):
        raise Unusable(f"{start} has {len(weights)} weights; one > 0 for each of {len(control)} points is needed")
    if not (np.all(np.isfinite(knots)) and np.all(np.diff(knots) >= 0.0) and knots[degree] < knots[len(control)]):
        raise Unusable(f"{start} has knots that do not ascend")
    spans = bspline_spans(degree, knots, control[:, :2], weights if len(weights) else None)
    straight = [Line(first=span.control[0], last=span.control[1]) for span in spans if degree == 1]
    return [*(straight or spans)], control[:, 2].tolist()


_HIGHEST_DEGREE = 25
"""DXF programs stop at 11 or 25; the parts of a polynomial of a much higher degree cancel."""


def _up(entity: Any) -> float:
    """+1 or −1: the z component of the normal. Raises Unusable where it is another one."""
    normal = np.array(entity.dxf.extrusion, float)
    up = float(np.sign(normal[2]))
    if not up or not np.hypot(normal[0], normal[1]) <= _LEVEL * abs(normal[2]):
        raise Unusable(
            f"lies in a plane across ({normal[0]:.6g}, {normal[1]:.6g}, {normal[2]:.6g}); a section is drawn in the "
            "xy plane: turn it there"
        )
    return up


_READERS: Mapping[str, Callable[[Any], tuple[list[Curve], list[float]]]] = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _arc,
    "ELLIPSE": _ellipse,
    "LWPOLYLINE": _lwpolyline,
    "POLYLINE": _polyline,
    "SPLINE": _spline,
}
OUTLINES = frozenset(_READERS)
"""Kinds of entities that are read."""

"""SVG shapes as exact curves under an affine map."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...curves.arc import Arc
from ...curves.bezier import Bezier
from ...curves.curve import Curve
from ...curves.elliptic_arc import EllipticArc
from ...curves.line import Line, lines_through
from .svg_units import Unusable, length

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    import svgpathtools

_ROUND = 8.0 * float(np.finfo(float).eps)
"""Half axes that differ by less, or are as near to square, are those of a circle under a turn and a scale."""


def curves_of(element: Element, matrix: Array) -> list[Curve]:
    """The curves of a shape under p → A p + t, matrix = [A t] (2, 3). Raises Unusable naming what is wrong."""
    return SHAPES[element.tag](element, matrix)


def _path(element: Element, matrix: Array) -> list[Curve]:
    import svgpathtools

    text = element.get("d", "")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # arcs without a radius are lines, as SVG has it
            segments = svgpathtools.parse_path(text)
            return [
                _segment(segment, matrix) for segment in segments if segment.start != segment.end or _round(segment)
            ]
    except (ArithmeticError, AssertionError, LookupError, TypeError, ValueError) as error:
        raise Unusable(f"has a path that cannot be read ({str(error)[:160]}); draw it again") from None


def _round(segment: svgpathtools.Line | svgpathtools.CubicBezier) -> bool:
    """Whether a segment that ends where it starts goes anywhere between."""
    return any(point != segment.start for point in segment.bpoints()) if hasattr(segment, "bpoints") else False


def _segment(segment: svgpathtools.Line | svgpathtools.CubicBezier | svgpathtools.Arc, matrix: Array) -> Curve:
    import svgpathtools

    if isinstance(segment, svgpathtools.Arc):
        turn = np.exp(1j * np.radians(segment.rotation))
        angles = np.radians([segment.theta, segment.theta + segment.delta])
        axes = [turn * segment.radius.real, 1j * turn * segment.radius.imag]
        return _elliptic(_pairs([segment.center]), _pairs(axes), tuple(angles.tolist()), matrix)
    points = _moved(_pairs(segment.bpoints()), matrix)
    if len(points) == 2:
        return Line(first=points[0], last=points[1])
    return Bezier(control=tuple(points))


def _pairs(numbers: list[complex]) -> Array:
    return np.array([[z.real, z.imag] for z in numbers])


def _moved(points: Array, matrix: Array) -> list[tuple[float, float]]:
    return [(x, y) for x, y in (points @ matrix[:, :2].T + matrix[:, 2]).tolist()]


def _elliptic(centre: Array, axes: Array, interval: tuple[float, float], matrix: Array) -> Curve:
    """An elliptic arc under the map; where it stays a circle's, that circle's arc."""
    where = _moved(centre.reshape(1, 2), matrix)[0]
    a, b = axes @ matrix[:, :2].T
    square, cross = float(a @ a), float(a[0] * b[1] - a[1] * b[0])
    if abs(float(b @ b) - square) <= _ROUND * square and abs(float(a @ b)) <= _ROUND * square and square > 0.0:
        sense, angle = float(np.sign(cross)), float(np.arctan2(a[1], a[0]))
        ends = (angle + sense * interval[0], angle + sense * interval[1])
        return Arc(radius=float(np.sqrt(square)), centre=where, interval=ends)
    return EllipticArc(centre=where, a=tuple(a.tolist()), b=tuple(b.tolist()), interval=interval)


def _line(element: Element, matrix: Array) -> list[Curve]:
    numbers = [length(element, name) for name in ("x1", "y1", "x2", "y2")]
    return [*lines_through(_moved(np.reshape(numbers, (2, 2)), matrix))]


def _polyline(element: Element, matrix: Array) -> list[Curve]:
    fields = re.split(r"[\s,]+", element.get("points", "").strip())
    try:
        numbers = [float(field) for field in fields if field]
        points = np.reshape(numbers, (-1, 2))
    except ValueError:
        raise Unusable("has points that are not pairs of numbers; draw it again") from None
    if element.tag == "polygon" and len(points):
        points = np.concatenate([points, points[:1]])
    return [*lines_through(_moved(points, matrix))]


def _ellipse(element: Element, matrix: Array) -> list[Curve]:
    names = ("r", "r") if element.tag == "circle" else ("rx", "ry")
    rx, ry = (_side(element, name) for name in names)
    if not (rx and ry):
        return []
    centre = np.array([length(element, "cx"), length(element, "cy")])
    return [_elliptic(centre, np.diag([rx, ry]), (0.0, 2.0 * np.pi), matrix)]


def _rect(element: Element, matrix: Array) -> list[Curve]:
    """Four sides and, where rx or ry is given, quarter ellipses between them (SVG 2, §10.2)."""
    x, y = length(element, "x"), length(element, "y")
    width, height = _side(element, "width"), _side(element, "height")
    if not (width and height):
        return []
    rx = _side(element, "rx", default=_side(element, "ry"))
    ry = _side(element, "ry", default=rx)
    rx, ry = min(rx, width / 2.0), min(ry, height / 2.0)
    if not (rx and ry):
        corners = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]])
        return [*lines_through(_moved(corners, matrix))]
    curves: list[Curve] = []
    for k, (right, low) in enumerate([(1, 1), (0, 1), (0, 0), (1, 0)]):
        centre = np.array([x + width - rx if right else x + rx, y + height - ry if low else y + ry])
        quarter = (k * np.pi / 2.0, (k + 1) * np.pi / 2.0)
        curves.append(_elliptic(centre, np.diag([rx, ry]), quarter, matrix))
    sides = [
        Line(first=tuple(a.end.tolist()), last=tuple(b.start.tolist()))
        for a, b in zip(curves, [*curves[1:], curves[0]], strict=True)
    ]
    return curves + [side for side in sides if side.first != side.last]


def _side(element: Element, name: str, default: float = 0.0) -> float:
    value = length(element, name, default)
    if value < 0.0:
        raise Unusable(f"has {name}={value:g}; it cannot be below 0")
    return value


SHAPES: Mapping[str, Callable[[Element, Array], list[Curve]]] = {
    "path": _path,
    "line": _line,
    "polyline": _polyline,
    "polygon": _polyline,
    "circle": _ellipse,
    "ellipse": _ellipse,
    "rect": _rect,
}
"""Elements that are outlines."""

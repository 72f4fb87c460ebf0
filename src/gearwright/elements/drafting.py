"""What the views of elements are drawn from: outlines of sections, regions that are cut, axes."""

from __future__ import annotations

from collections.abc import Sequence
from math import comb
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..sections.drawings.contours import Contour, Profile, contours
from ..sections.drawings.primitives import Primitive, Round, Straight
from ..sections.drawings.svg_writing import HAND
from ..sections.plane import Section
from ..sheets.line_kinds import CENTRE, VISIBLE, LineKind
from ..sheets.marks import Hatch, Stroke, line, polyline

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

FINE = 1e-5
"""Distance of splines on a sheet from the curves they stand for, of the section's size: less than a line is wide."""

_BEYOND = 0.05  # by which axes reach beyond what they are the axes of, of its size
_SMOOTHED = 1e-7  # of the size: what roundings leave between pieces that touch is no gap


def outlines(section: Section, turn: float = 0.0) -> tuple[Contour, ...]:
    """Closed chains of primitives, one for each loop, turned about the origin (radians)."""
    return contours(Profile(section=section, turn=turn), FINE * section.size, HAND)


def drawn(chains: Sequence[Contour], kind: LineKind = VISIBLE) -> tuple[Stroke, ...]:
    """Closed chains in one kind of line."""
    return tuple(Stroke(chain=chain, kind=kind, closed=True) for chain in chains)


def points_on(chain: Contour, turn_points: int = 200) -> Array:
    """Points (n, 2) along a closed chain, near enough for hatching and cutting it on paper."""
    return np.concatenate([_along(one, turn_points) for one in chain])


def _along(one: Primitive, turn_points: int) -> Array:
    """Points of a primitive, but for its end."""
    if isinstance(one, Straight):
        return one.start[None]
    if isinstance(one, Round):
        count = max(2, round(turn_points * abs(one.sweep) / (2.0 * np.pi)))
        return np.array([one.point(one.first + k / count * one.sweep) for k in range(count)])
    t = np.linspace(0.0, 1.0, _PIECES, endpoint=False)
    basis = np.array([comb(one.degree, i) * t**i * (1.0 - t) ** (one.degree - i) for i in range(one.degree + 1)])
    return np.einsum("it,cix->ctx", basis, one.control).reshape(-1, 2)


_PIECES = 8
"""Chords of a Bézier curve."""


def box(left: float, low: float, right: float, high: float) -> BaseGeometry:
    """A rectangle."""
    import shapely

    return shapely.box(left, low, right, high)


def polygon(points: Sequence[tuple[float, float]] | Array) -> BaseGeometry:
    """The region within corners, in either sense."""
    import shapely

    return shapely.Polygon(points)


def united(regions: Sequence[BaseGeometry]) -> BaseGeometry:
    """Regions as one, with what roundings leave between them closed."""
    import shapely

    whole = shapely.union_all(list(regions))
    low_x, low_y, high_x, high_y = whole.bounds
    by = _SMOOTHED * max(high_x - low_x, high_y - low_y)
    return whole.buffer(by, join_style="mitre").buffer(-by, join_style="mitre").simplify(by)


def cut(region: BaseGeometry) -> tuple[tuple[Stroke, ...], tuple[Hatch, ...]]:
    """Outlines of a region that is cut, and its hatching."""
    import shapely

    strokes, hatches = [], []
    for part in shapely.get_parts(region):
        if part.geom_type != "Polygon" or part.area <= 0.0:
            continue
        outline = np.array(part.exterior.coords)[:-1]
        holes = tuple(np.array(ring.coords)[:-1] for ring in part.interiors)
        hatches.append(Hatch(outline=outline, holes=holes))
        strokes += [polyline(list(ring), VISIBLE, closed=True) for ring in (outline, *holes)]
    return tuple(strokes), tuple(hatches)


def mirrored(region: BaseGeometry) -> BaseGeometry:
    """A region on the other side of the axis y = 0."""
    import shapely

    return shapely.transform(region, lambda points: points * np.array([1.0, -1.0]))


def axis(start: float, end: float, *, vertical: bool = False, at: float = 0.0) -> Stroke:
    """An axis a little longer than from start to end: horizontal at a height, or vertical."""
    more = _BEYOND * (end - start)
    first, last = (start - more, at), (end + more, at)
    return line(first[::-1], last[::-1], CENTRE) if vertical else line(first, last, CENTRE)

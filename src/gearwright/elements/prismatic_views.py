"""Views of parts of constant section: the section, and a cut across it; and of any other part by its outline."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..sections.drawings.contours import Contour
from ..sheets.line_kinds import VISIBLE
from ..sheets.marks import Stroke, line, polyline
from ..sheets.views import Span, View
from .drafting import axis, box, cut, drawn, outlines, points_on, united

if TYPE_CHECKING:
    from .element import Element

_PLANES = {"Seen along z": (0, 1), "Seen along y": (0, 2), "Seen along x": (1, 2)}
_COARSE = 2e-3  # of the bounding diagonal: chords of an outline that is drawn and not measured


def cut_at_axis(chains: Sequence[Contour], thickness: float, *, bore: float | None) -> View:
    """The section through x = 0 of what is extruded over a thickness, seen from the left."""
    import shapely

    whole = shapely.Polygon(points_on(chains[0]), [points_on(chain) for chain in chains[1:]])
    low, high = whole.bounds[1], whole.bounds[3]
    pieces = shapely.get_parts(whole.intersection(shapely.LineString([(0.0, low - 1.0), (0.0, high + 1.0)])))
    spans = [(piece.bounds[1], piece.bounds[3]) for piece in pieces if piece.length > 0.0]
    strokes, hatches = cut(united([box(0.0, a, thickness, b) for a, b in spans])) if spans else ((), ())
    outline = polyline([(0.0, low), (thickness, low), (thickness, high), (0.0, high)], VISIBLE, closed=True)
    edges: list[Stroke] = []
    dimensions = [Span(start=(0.0, low), end=(thickness, low), side="below")]
    if bore is not None:
        edges = [line((z, -bore / 2.0), (z, bore / 2.0), VISIBLE) for z in (0.0, thickness)]
        dimensions.append(Span(start=(thickness, -bore / 2.0), end=(thickness, bore / 2.0), side="right", prefix="Ø"))
    return View(
        title="Section through the axis",
        strokes=(outline, *strokes, *edges, axis(0.0, thickness)),
        hatches=hatches,
        dimensions=tuple(dimensions),
    )


def any_views(element: Element) -> tuple[View, ...]:
    """The plane section the part is made from, if there is one, and its outlines along the three axes."""
    body = element.polyhedron(_COARSE * _diagonal(element))
    views = [_outline(body.vertices[body.triangles()], title, axes) for title, axes in _PLANES.items()]
    if element.profile is None:
        return tuple(views)
    chains = outlines(element.profile)
    points = points_on(chains[0])
    (left, low), (right, high) = points.min(axis=0), points.max(axis=0)
    section = View(
        title="Section at the start",
        strokes=drawn(chains),
        dimensions=(
            Span(start=(left, low), end=(right, low), side="below"),
            Span(start=(left, low), end=(left, high), side="left"),
        ),
    )
    return (section, *views)


def _diagonal(element: Element) -> float:
    from ..boundary.extent import rough_diagonal

    return rough_diagonal(element.boundary)


def _outline(triangles: Array, title: str, axes: tuple[int, int]) -> View:
    """What a body covers as it is seen along an axis, with its whole width and height."""
    import shapely

    flat = triangles[:, :, list(axes)]
    a, b = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    size = float(np.ptp(flat.reshape(-1, 2), axis=0).max())
    flat = flat[np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) > 1e-9 * size**2]
    covered = united(list(shapely.polygons(flat)))
    strokes = [
        polyline(list(np.array(ring.coords)[:-1]), VISIBLE, closed=True)
        for part in shapely.get_parts(covered)
        if part.geom_type == "Polygon"
        for ring in (part.exterior, *part.interiors)
    ]
    left, low, right, high = covered.bounds
    return View(
        title=title,
        strokes=tuple(strokes),
        dimensions=(
            Span(start=(left, low), end=(right, low), side="below"),
            Span(start=(left, low), end=(left, high), side="left"),
        ),
    )

"""Outlines of plane sections as charts, and the circles that go with them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..arrays import Array, ArrayLike
from ..pictures.chart import Axis, Chart, Line, Style
from ..sections.plane import Section
from ..sections.polylines import closed_polyline

FINE = 2e-5
"""Chord tolerance of outlines, of the section's size: no page shows a difference."""

_DIGITS = 1e-9  # of the size, to which coordinates are given
_TURN = 241  # points of a circle


def outline(name: str, section: Section, placement: Array | None = None) -> Line:
    """The loops of a section, with gaps between them, where a placement (4, 4) about z puts it."""
    gap = np.full((1, 2), np.nan)
    pieces = [piece for loop in section.loops for piece in (closed_polyline(loop, FINE * section.size), gap)]
    points = np.concatenate(pieces[:-1])
    if placement is not None:
        points = points @ placement[:2, :2].T + placement[:2, 3]
    decimals = int(np.ceil(-np.log10(_DIGITS * section.size)))
    return Line.through(name, np.round(points, decimals))


def circle(name: str, radius: float, centre: ArrayLike = (0.0, 0.0), style: Style = "dashed") -> Line:
    """A circle about a centre (2,)."""
    angle = np.linspace(0.0, 2.0 * np.pi, _TURN)
    points = np.asarray(centre, float) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return Line.through(name, points, style)


def drawing_axes(length_unit: str) -> dict[str, Any]:
    """Axes of a drawing, of the same scale."""
    return {"x": Axis(label="x", unit=length_unit), "y": Axis(label="y", unit=length_unit), "equal": True}


def section(element: Any) -> Chart:
    """The plane section that a sweep starts from."""
    found = element.profile
    properties = found.properties()
    unit = element.length_unit
    return Chart(
        title=f"Section at the start, {element.description}",
        **drawing_axes(unit),
        lines=[
            outline("section", found),
            Line.through("centroid", np.asarray(properties.centroid, float)[None], "points"),
        ],
        notes=[f"area {properties.area:.6g} {unit}², perimeter {properties.perimeter:.6g} {unit}"],
    )

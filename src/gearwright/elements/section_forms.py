"""Sections as parameters: the name of a drawing, or a table of points and sizes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..parameters import FileName, Parameter, Points, Several, Table, Text, entry
from ..sections.plane import Section

_CORNERS = Points(coordinates=("x", "y"), least=3)
_HOLES = entry(
    "holes",
    Parameter(meaning="outlines of holes, given like the outline", kind="form", forms=(Several(of=_CORNERS),)),
    default=(),
)
_CENTRE = entry("centre", Parameter(meaning="its centre", unit="length", components=("x", "y")), default=(0.0, 0.0))
_POLYGON = Parameter(meaning="corners of a polygon in their order", kind="form", forms=(_CORNERS,))
_SPLINE = Parameter(meaning="points of a closed cubic spline in their order", kind="form", forms=(_CORNERS,))
_RADIUS = Parameter(meaning="radius of a disc", unit="length", above=0)
_RECTANGLE = Parameter(
    meaning="width and height of a rectangle", unit="length", above=0, components=("width", "height")
)

SECTION = Parameter(
    meaning="outline of the section: a DXF, SVG or CSV drawing",
    kind="form",
    symbol="S",
    forms=(
        FileName(suffixes=(".dxf", ".svg", ".csv")),
        Table(entries=(entry("polygon", _POLYGON), _HOLES)),
        Table(entries=(entry("spline", _SPLINE), _HOLES)),
        Table(entries=(entry("circle", _RADIUS), _CENTRE)),
        Table(entries=(entry("rectangle", _RECTANGLE), _CENTRE)),
    ),
)

LAYER = Parameter(
    meaning="the one layer of the drawing to read", kind="form", forms=(Text(words="the name of a layer"),)
)
AROUND = Parameter(
    meaning="a point in the wanted region, where a drawing holds several", unit="length", components=("x", "y")
)


def section_in(table: Mapping[str, Any]) -> Section:
    """The section that a sound table of SECTION gives. Raises GeometryError."""
    given = table
    holes, centre = given.get("holes", ()), given.get("centre", (0.0, 0.0))
    if "polygon" in given:
        return Section.polygon(given["polygon"], holes)
    if "spline" in given:
        return Section.spline(given["spline"], holes)
    if "circle" in given:
        return Section.circle(given["circle"], centre)
    width, height = given["rectangle"]
    return Section.rectangle(width, height, centre)

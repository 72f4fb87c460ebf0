"""What a sheet is made of, in millimetres on paper: strokes, text, hatching, arrow heads, dimensions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from ..arrays import Array, ArrayLike
from ..sections.drawings.primitives import Primitive, Round, Straight
from . import lettering
from .line_kinds import LineKind


@dataclass(frozen=True, kw_only=True, eq=False)
class Stroke:
    """A chain of lines, arcs and splines, drawn in one kind of line. closed   it ends where it starts"""

    chain: tuple[Primitive, ...]
    kind: LineKind
    closed: bool = False

    def samples(self) -> Array:
        """Points (n, 2) by which its extent is known."""
        return np.concatenate([one.samples() for one in self.chain])

    def placed(self, scale: float, shift: Array) -> Stroke:
        """Scaled about the origin, then shifted (2,)."""
        chain = tuple(one.scaled(scale).moved(0.0, shift) for one in self.chain)
        return Stroke(chain=chain, kind=self.kind, closed=self.closed)


@dataclass(frozen=True, kw_only=True, eq=False)
class Text:
    """A line of text.

    at         (2,) on its base line: its left end, its middle or its right end, as `align` says
    height     of capitals
    angle      of the base line, degrees counter-clockwise
    subscript  smaller and lower, after the text
    """

    text: str
    at: Array
    height: float = 2.5
    align: Literal["left", "centre", "right"] = "left"
    angle: float = 0.0
    subscript: str = ""

    @cached_property
    def widths(self) -> tuple[float, float]:
        """Of the text and of its subscript."""
        small = lettering.SMALLER * self.height
        return lettering.width(self.text, self.height), lettering.width(self.subscript, small)

    @property
    def width(self) -> float:
        return sum(self.widths)

    @property
    def start(self) -> Array:
        """The left end of the base line (2,)."""
        part = {"left": 0.0, "centre": 0.5, "right": 1.0}[self.align]
        return self.at - part * self.width * self.along

    @property
    def along(self) -> Array:
        """Unit vector (2,) in which it is read."""
        return np.array([math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))])

    @property
    def lines(self) -> tuple[Text, ...]:
        """Text and subscript, each by itself from its left end."""
        first = Text(text=self.text, at=self.start, height=self.height, angle=self.angle)
        if not self.subscript:
            return (first,)
        x, y = self.along
        lower = self.start + self.widths[0] * self.along + lettering.LOWERED * self.height * np.array([y, -x])
        small = Text(text=self.subscript, at=lower, height=lettering.SMALLER * self.height, angle=self.angle)
        return (first, small)

    def samples(self) -> Array:
        """Corners (4, 2) of the box around it."""
        x, y = self.along
        up = np.array([-y, x]) * self.height
        low, high = (self.start - 0.35 * up), self.start + up * 1.05
        return np.array([low, high, low + self.width * self.along, high + self.width * self.along])

    def fitting(self, most: float) -> Text:
        """The same, as much smaller as it must be to be no wider."""
        if self.width <= most:
            return self
        height = self.height * most / self.width
        return Text(
            text=self.text, at=self.at, height=height, align=self.align, angle=self.angle, subscript=self.subscript
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class Filled:
    """A filled polygon (n, 2): the head of an arrow."""

    corners: Array

    def samples(self) -> Array:
        return self.corners


@dataclass(frozen=True, kw_only=True, eq=False)
class Hatch:
    """Thin lines at 45° over a region: its outline (n, 2), and holes in it."""

    outline: Array
    holes: tuple[Array, ...] = ()
    distance: float = 3.0

    def samples(self) -> Array:
        return self.outline

    def placed(self, scale: float, shift: Array) -> Hatch:
        """The region scaled about the origin, then shifted; its lines are nearer to each other in a narrow one."""
        holes = tuple(hole * scale + shift for hole in self.holes)
        narrow = float(np.ptp(self.outline, axis=0).min()) * scale
        return Hatch(outline=self.outline * scale + shift, holes=holes, distance=min(3.0, max(1.0, 0.3 * narrow)))

    @cached_property
    def lines(self) -> Array:
        """The lines (n, 2, 2), from end to end."""
        import shapely

        region = shapely.Polygon(self.outline, self.holes)
        low, high = self.outline.min(axis=0), self.outline.max(axis=0)
        step = self.distance * math.sqrt(2.0)
        first = math.ceil((low[1] - high[0]) / step)
        offsets = step * np.arange(first, math.floor((high[1] - low[0]) / step) + 1)
        x = np.array([low[0], high[0]])
        across = shapely.linestrings(
            np.array([np.column_stack([x, x + offset]) for offset in offsets]).reshape(-1, 2, 2)
        )
        parts = shapely.get_parts(shapely.intersection(region, across))
        parts = parts[shapely.get_type_id(parts) == shapely.GeometryType.LINESTRING]
        ends = [shapely.get_coordinates(part)[[0, -1]] for part in parts if part.length > _SHORTEST]
        return np.array(ends).reshape(-1, 2, 2)


_SHORTEST = 1e-3  # mm of a hatch line


@dataclass(frozen=True, kw_only=True, eq=False)
class Dimension:
    """A dimension as it is drawn, and what it measures.

    kind    of the points: "linear" origins of both extension lines and a point of the dimension line; "angular" the
            same of an arc, and the vertex
    angle   of a linear dimension line, degrees
    value   what it measures: in length units, or degrees
    marks   what is drawn of it
    factor  millimetres on paper for each length unit
    """

    kind: Literal["linear", "angular"]
    points: tuple[Array, ...]
    value: float
    text: Text
    marks: tuple[Stroke | Filled, ...]
    angle: float = 0.0
    factor: float = 1.0

    def samples(self) -> Array:
        return np.concatenate([one.samples() for one in (*self.marks, self.text)])


Mark = Stroke | Text | Filled | Hatch | Dimension


@dataclass(frozen=True, kw_only=True, eq=False)
class Sheet:
    """A sheet of paper, its lower left corner at the origin.

    size    (width, height)
    scale   lengths on paper per length of the part, both in mm
    unit    of the lengths that dimensions state
    """

    size: tuple[float, float]
    scale: float
    unit: str
    marks: tuple[Mark, ...]


def line(start: ArrayLike, end: ArrayLike, kind: LineKind) -> Stroke:
    """A straight line."""
    return polyline([start, end], kind)


def polyline(points: Sequence[ArrayLike], kind: LineKind, *, closed: bool = False) -> Stroke:
    """Straight lines from point to point, and back to the first one if closed."""
    p = [np.array(point, float) for point in points]
    ends = [*p[1:], p[0]] if closed else p[1:]
    return Stroke(
        chain=tuple(Straight(start=a, end=b) for a, b in zip(p, ends, strict=False)), kind=kind, closed=closed
    )


def circle(radius: float, kind: LineKind, centre: ArrayLike = (0.0, 0.0)) -> Stroke:
    """A whole circle."""
    return Stroke(chain=(_round(radius, 0.0, 2.0 * math.pi, centre),), kind=kind, closed=True)


def arc(radius: float, first: float, last: float, kind: LineKind, centre: ArrayLike = (0.0, 0.0)) -> Stroke:
    """A circular arc from one angle counter-clockwise to another, radians."""
    return Stroke(chain=(_round(radius, first, last - first, centre),), kind=kind)


def _round(radius: float, first: float, sweep: float, centre: ArrayLike) -> Round:
    return Round(centre=np.array(centre, float), major=np.array([radius, 0.0]), ratio=1.0, first=first, sweep=sweep)

"""A view of a part in the part's own lengths: what is seen, and what is to be dimensioned."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..arrays import Array
from .marks import Hatch, Stroke

Point = tuple[float, float]
Side = Literal["left", "right", "above", "below"]


@dataclass(frozen=True, kw_only=True)
class Span:
    """The vertical distance of two points, dimensioned on the left or right of a view; the horizontal one above or
    below. prefix   before the number: "Ø"
    """

    start: Point
    end: Point
    side: Side
    prefix: str = ""

    @property
    def value(self) -> float:
        axis = 0 if self.side in ("above", "below") else 1
        return abs(self.end[axis] - self.start[axis])


@dataclass(frozen=True, kw_only=True)
class Slant:
    """The distance of two points, dimensioned along the line between them, to the right of the way from start to end.

    clear   how far (length) the part reaches to that side of the line
    row     0 next to the part, 1 outside of that, …
    """

    start: Point
    end: Point
    clear: float = 0.0
    row: int = 0
    prefix: str = ""

    @property
    def value(self) -> float:
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


@dataclass(frozen=True, kw_only=True)
class Angle:
    """The angle at a vertex between two directions (degrees, first < last), on an arc of a radius."""

    vertex: Point
    first: float
    last: float
    radius: float
    prefix: str = ""

    @property
    def value(self) -> float:
        return self.last - self.first


@dataclass(frozen=True, kw_only=True)
class Leader:
    """A note above a view, with an arrow to a point."""

    point: Point
    text: str


@dataclass(frozen=True, kw_only=True, eq=False)
class View:
    """A view. Views beside each other have their y in common, those below each other their x.

    detail   shown larger than the others, in a scale of its own
    """

    title: str
    strokes: tuple[Stroke, ...]
    hatches: tuple[Hatch, ...] = ()
    dimensions: tuple[Span | Slant | Angle | Leader, ...] = ()
    detail: bool = False

    def box(self) -> Array:
        """Least and largest x and y (2, 2) of what is drawn, without its dimensions."""
        points = np.concatenate([stroke.samples() for stroke in self.strokes])
        return np.array([points.min(axis=0), points.max(axis=0)])

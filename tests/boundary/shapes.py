"""Small solids with known boundaries, built from sections and motions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.boundary.boundary import Boundary
from gearwright.boundary.swept import swept_boundary
from gearwright.curves.arc import Arc
from gearwright.curves.curve import Curve
from gearwright.curves.line import Line
from gearwright.motions.ends import between
from gearwright.motions.revolution import FULL_TURN, Revolution
from gearwright.motions.straight import Straight
from gearwright.sections.loop import Loop
from gearwright.sections.plane import Section


def polygon(*corners: tuple[float, float], copies: int = 1) -> Loop:
    """A closed polygon, counter-clockwise as given."""
    following = (*corners[1:], corners[0])
    return Loop(curves=tuple(Line(first=a, last=b) for a, b in zip(corners, following, strict=True)), copies=copies)


def circle(radius: float, *, pieces: int = 1, sense: int = 1) -> Loop:
    """A circle of so many equal pieces, one of them given."""
    return Loop(curves=(Arc(radius=radius, interval=(0.0, sense * 2.0 * np.pi / pieces)),), copies=pieces)


SQUARE = polygon((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


def extruded(*loops: Loop, height: float = 1.0) -> Boundary:
    return swept_boundary(Section(loops=loops), Straight(), between(0.0, height))


def revolved(*loops: Loop, angle: float = FULL_TURN) -> Boundary:
    return swept_boundary(Section(loops=loops), Revolution(), between(-angle, 0.0))


@dataclass(frozen=True, kw_only=True)
class Semicircle(Curve):
    """Half a unit circle from (0, −1) over (1, 0), exactly on the axis at both ends: ((1 − t²), 2t)/(1 + t²)."""

    interval: tuple[float, float] = (-1.0, 1.0)

    def point(self, u):
        t = np.asarray(u, float)
        return np.stack([1.0 - t * t, 2.0 * t], axis=-1) / (1.0 + t * t)[..., None]

    def derivative(self, u):
        t = np.asarray(u, float)
        return np.stack([-4.0 * t, 2.0 * (1.0 - t * t)], axis=-1) / ((1.0 + t * t) ** 2)[..., None]


HALF_DISC = Loop(curves=(Semicircle(), Line(first=(0.0, 1.0), last=(0.0, -1.0))))
"""Its straight side on the axis: a ball when revolved."""


BOXES = {
    "cube": (lambda: extruded(SQUARE), 1.0, 0),
    "cylinder": (lambda: extruded(circle(2.0), height=3.0), 12.0 * np.pi, 0),
    "tube of twelve sectors": (
        lambda: extruded(circle(2.0, pieces=12), circle(1.0, pieces=12, sense=-1)),
        3.0 * np.pi,
        1,
    ),
    "ring of square section": (
        lambda: revolved(polygon((2.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0))),
        5.0 * np.pi,
        1,
    ),
    "cone": (lambda: revolved(polygon((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))), np.pi / 3.0, 0),
    "quarter of a cone": (
        lambda: revolved(polygon((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), angle=np.pi / 2.0),
        np.pi / 12.0,
        0,
    ),
    "half a ring": (
        lambda: revolved(polygon((2.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0)), angle=np.pi),
        2.5 * np.pi,
        0,
    ),
    "ball": (lambda: revolved(HALF_DISC), 4.0 * np.pi / 3.0, 0),
    "torus": (
        lambda: revolved(Loop(curves=(Arc(radius=1.0, centre=(3.0, 0.0), interval=(0.0, 2.0 * np.pi)),))),
        6.0 * np.pi**2,
        1,
    ),
}
"""Name: how to build it, volume, through holes."""

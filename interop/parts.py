"""The parts that other programs are given, with exact volumes to compare theirs with."""

from __future__ import annotations

from functools import cache
from math import pi
from typing import Any, NamedTuple

import gearwright as gw
from gearwright.parameters import LENGTH_UNITS

_BUILDERS = {
    "spiral bevel pair": lambda: gw.BevelPair(
        teeth=(16, 20), module=12.7, face_width=38.1, trace="logarithmic", spiral_angle=35
    ),
    "spur gear": lambda: gw.SpurGear(teeth=24, module=3, face_width=20, bore=20),
    "helical gear": lambda: gw.HelicalGear(teeth=17, module=2, face_width=9, helix_angle=20),
    "cam": lambda: gw.Cam(
        programme="dwell 36, rise 72, dwell 144, return 108",
        follower="translating-roller",
        lift=12,
        base_radius=25,
        roller_radius=8,
        law="4-5-6-7",
        thickness=12,
        bore=16,
    ),
    "sweep": lambda: gw.Sweep(
        section={"spline": ((8, 0), (4, 6), (-4, 4), (-8, -2), (0, -4))}, length=40, twist=60, scale=(0.8, 0.7)
    ),
    "ring": lambda: gw.Sweep(section={"polygon": ((20, 0), (30, 2), (28, 12), (22, 10))}, angle=360),
    "spur gear in inches": lambda: gw.SpurGear(
        teeth=12, diametral_pitch=4, length_unit="in", face_width=1, bore=0.5, root="radial"
    ),
}
PARTS = tuple(_BUILDERS)


class Solid(NamedTuple):
    """One solid of a part. name   None where the name of the file stands for it; volume   exact, mm³"""

    name: str | None
    element: Any
    volume: float


@cache
def built(name: str) -> Any:
    """The part of that name."""
    return _BUILDERS[name]()


def solids(name: str) -> list[Solid]:
    """Its solids, in the order of its files."""
    part = built(name)
    millimetres = LENGTH_UNITS[part.length_unit]
    members = [("pinion", part.pinion), ("gear", part.gear)] if isinstance(part, gw.BevelPair) else [(None, part)]
    return [Solid(label, one, one.properties().volume * millimetres**3) for label, one in members]


class Drilling(NamedTuple):
    """A hole parallel to z about (x, y), from one height up to another, clear of teeth and bore."""

    part: str
    member: str | None
    diameter: float
    place: tuple[float, float]
    low: float
    high: float

    @property
    def element(self) -> Any:
        """What is drilled."""
        part = built(self.part)
        return getattr(part, self.member) if self.member else part

    @property
    def left(self) -> float:
        """Volume of what is left: the plane ends of what is drilled are those of its bounding box."""
        properties = self.element.properties()
        (*_, bottom), (*_, top) = properties.bounding_box
        depth = min(self.high, top) - max(self.low, bottom)
        return properties.volume - pi * self.diameter**2 / 4 * depth


DRILLINGS = (
    Drilling("spur gear", None, 6.0, (22.0, 5.0), -1.0, 21.0),
    Drilling("helical gear", None, 8.0, (1.0, -2.0), -1.0, 5.0),
    Drilling("spiral bevel pair", "gear", 30.0, (3.0, -4.0), 120.0, 150.0),
    Drilling("cam", None, 5.0, (-14.0, 0.0), -1.0, 13.0),
)

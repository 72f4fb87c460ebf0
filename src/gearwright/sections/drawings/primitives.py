"""What written drawings are made of: straight lines, arcs of circles and ellipses, chains of Bézier curves."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...arrays import Array

_ONCE_ROUND = 2.0 * math.pi * (1.0 - 1e-12)
"""A sweep that comes so near to once round, in radians, is a whole circle or ellipse."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Straight:
    """The line between two points (2,)."""

    start: Array
    end: Array

    def moved(self, angle: float, shift: Array) -> Straight:
        """The line turned by an angle about the origin, then shifted (2,)."""
        return Straight(start=_moved(self.start, angle, shift), end=_moved(self.end, angle, shift))

    def scaled(self, factor: float) -> Straight:
        """The line scaled about the origin."""
        return Straight(start=factor * self.start, end=factor * self.end)

    def between(self, start: Array, end: Array) -> Straight:
        """The line with other ends (2,)."""
        return Straight(start=start, end=end)

    def samples(self) -> Array:
        """Points (n, 2) by which its extent is known."""
        return np.array([self.start, self.end])


@dataclass(frozen=True, kw_only=True, eq=False)
class Round:
    """The arc centre + major cos u + minor sin u, where minor is major turned by +90° times the ratio.

    centre, major   (2,); of a circle, major = (radius, 0)
    ratio           of the half axes, 0 < ratio ≤ 1; 1 for a circle
    first, sweep    u at the start, and how far it runs on to the end; negative for clockwise, radians
    """

    centre: Array
    major: Array
    ratio: float
    first: float
    sweep: float

    @property
    def circular(self) -> bool:
        return self.ratio == 1.0

    @property
    def whole(self) -> bool:
        """Whether it goes once round."""
        return abs(self.sweep) >= _ONCE_ROUND

    @cached_property
    def start(self) -> Array:
        return self.point(self.first)

    @cached_property
    def end(self) -> Array:
        return self.start if self.whole else self.point(self.first + self.sweep)

    def point(self, u: float) -> Array:
        """The point (2,) at u: of a circle to the last bit what a program finds that reads `degrees(u)`."""
        if self.circular:
            u = math.radians(degrees(u))
        c, s = math.cos(u), math.sin(u) * self.ratio
        x, y = self.major
        return np.array([x * c - y * s + self.centre[0], y * c + x * s + self.centre[1]])

    def moved(self, angle: float, shift: Array) -> Round:
        """The arc turned by an angle about the origin, then shifted (2,)."""
        centre = _moved(self.centre, angle, shift)
        if self.circular:
            return replace(self, centre=centre, first=self.first + angle)
        return replace(self, centre=centre, major=_moved(self.major, angle, np.zeros(2)))

    def scaled(self, factor: float) -> Round:
        """The arc scaled about the origin by a positive factor."""
        return replace(self, centre=factor * self.centre, major=factor * self.major)

    def between(self, start: Array, end: Array) -> Round:
        """The same arc: it follows from centre, half axes and angles, and others' ends come to it."""
        del start, end
        return self

    def pieces(self, most: float) -> list[Round]:
        """Equal arcs of at most so many radians, one after another."""
        count = max(1, math.ceil(abs(self.sweep) / most * (1.0 - 1e-12)))
        step = self.sweep / count
        return [replace(self, first=self.first + k * step, sweep=step) for k in range(count)]

    def samples(self) -> Array:
        """Points (n, 2) by which its extent is known."""
        return np.array([self.point(u) for u in np.linspace(self.first, self.first + self.sweep, 33)])


@dataclass(frozen=True, kw_only=True, eq=False)
class Free:
    """A chain of Bézier curves without corners.

    control   (n, degree + 1, 2), the last point of each curve the first one of the next
    weights   (degree + 1,) of a rational curve, which is alone; None for polynomials
    """

    control: Array
    weights: Array | None = None

    @property
    def degree(self) -> int:
        return self.control.shape[1] - 1

    @property
    def start(self) -> Array:
        return self.control[0, 0]

    @property
    def end(self) -> Array:
        return self.control[-1, -1]

    def moved(self, angle: float, shift: Array) -> Free:
        """The curves turned by an angle about the origin, then shifted (2,)."""
        return replace(self, control=_moved(self.control, angle, shift))

    def scaled(self, factor: float) -> Free:
        """The curves scaled about the origin."""
        return replace(self, control=factor * self.control)

    def between(self, start: Array, end: Array) -> Free:
        """The curves with their very ends (2,) moved."""
        control = self.control.copy()
        control[0, 0], control[-1, -1] = start, end
        return replace(self, control=control)

    def samples(self) -> Array:
        """Points (n, 2) by which its extent is known: the control points enclose it."""
        return self.control.reshape(-1, 2)


Primitive = Straight | Round | Free


def degrees(u: float) -> float:
    """An angle as it is written, from 0 to below 360."""
    return math.degrees(u) % 360.0


def round_arc(centre: Array, a: Array, b: Array, interval: tuple[float, float], rounding: float) -> Round | None:
    """The arc centre + a cos u + b sin u by its half axes; None where it is too flat to be one.

    rounding   the axes of a circle differ from one another, and from square, by no more, relative
    """
    square, cross, dot = float(a @ a), float(a[0] * b[1] - a[1] * b[0]), float(a @ b)
    if abs(float(b @ b) - square) <= rounding * square and abs(dot) <= rounding * square:
        radius, turned, sense = math.hypot(*a), math.atan2(a[1], a[0]), math.copysign(1.0, cross)
        major, ratio = np.array([radius, 0.0]), 1.0
    else:
        axes, lengths, mixing = np.linalg.svd(np.column_stack([a, b]))
        sense = math.copysign(1.0, float(np.linalg.det(axes) * np.linalg.det(mixing)))
        turned = math.atan2(mixing[1, 0], mixing[0, 0]) * math.copysign(1.0, float(np.linalg.det(axes)))
        major, ratio = axes[:, 0] * lengths[0], float(lengths[1] / lengths[0])
    if ratio < _FLATTEST:
        return None
    sweep = sense * (interval[1] - interval[0])
    return Round(centre=centre, major=major, ratio=ratio, first=turned + sense * interval[0], sweep=sweep)


_FLATTEST = 1e-6
"""The least ratio of an ellipse's axes that DXF holds."""


def _moved(points: Array, angle: float, shift: Array) -> Array:
    """Points (..., 2) turned about the origin and shifted; as they were where both are nought."""
    if angle == 0.0 and not np.any(shift):
        return points
    c, s = math.cos(angle), math.sin(angle)
    return points @ np.array([[c, s], [-s, c]]) + shift

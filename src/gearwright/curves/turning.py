"""Curves that turn about the origin as a motion goes on: the flanks, tips and roots of crowned gears.

The normal offset of an involute by C is the involute turned by C/r_b about the base circle's centre, exactly; so a
flank whose relief is C(v) at the height v is a flank that turns by C(v)/r_b.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve
from .family import Family
from .polynomial import Polynomial


@dataclass(frozen=True, kw_only=True)
class Turned(Family):
    """A curve turned about the origin (or z axis) by an angle δ(v), radians; the reference is δ = 0.

    The curve may be a family itself: one turn is then added to another.
    """

    curve: Curve
    turning: Polynomial

    def point(self, u: ArrayLike) -> Array:
        return self.curve.point(u)

    def derivative(self, u: ArrayLike) -> Array:
        return self.curve.derivative(u)

    def member_point(self, u: ArrayLike, v: ArrayLike) -> Array:
        return _turned(self.curve.at(v).point(u), self.turning.value(v))

    def member_derivative(self, u: ArrayLike, v: ArrayLike) -> Array:
        return _turned(self.curve.at(v).derivative(u), self.turning.value(v))

    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        own = _across(self.member_point(u, v)) * self.turning.derivative(v)[..., None]
        return own + _turned(self.curve.variation(u, v), self.turning.value(v))

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        return (*self.turning.extremes(start, finish), *self.curve.extremes(start, finish))

    @property
    def panels(self) -> tuple[float, ...]:
        return self.curve.panels


def turned(curve: Curve, turning: Polynomial) -> Turned:
    """The family of a curve that turns about the origin by δ(v)."""
    return Turned(interval=curve.interval, curve=curve, turning=turning)


@dataclass(frozen=True, kw_only=True)
class TurnedArc(Family):
    """An arc of a circle about the origin whose two ends turn each by its own angle; u from 0 to 1.

    radius     of the circle
    azimuths   of both ends at the reference, radians
    turnings   δ₀(v) and δ₁(v) of the two ends: a point's azimuth is (1 − u)(a₀ + δ₀) + u (a₁ + δ₁)
    """

    radius: float
    azimuths: tuple[float, float]
    turnings: tuple[Polynomial, Polynomial]
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        return self._at(self._between(u, *self.azimuths))

    def derivative(self, u: ArrayLike) -> Array:
        return _across(self.point(u)) * (self.azimuths[1] - self.azimuths[0])

    def member_point(self, u: ArrayLike, v: ArrayLike) -> Array:
        return self._at(self._between(u, *self._ends(v)))

    def member_derivative(self, u: ArrayLike, v: ArrayLike) -> Array:
        first, last = self._ends(v)
        return _across(self.member_point(u, v)) * (last - first)[..., None]

    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        first, last = (turning.derivative(v) for turning in self.turnings)
        return _across(self.member_point(u, v)) * self._between(u, first, last)[..., None]

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        return tuple(v for turning in self.turnings for v in turning.extremes(start, finish))

    def _ends(self, v: ArrayLike) -> tuple[Array, Array]:
        """Azimuths (...) of both ends of the members v (...)."""
        (a, b), (p, q) = self.azimuths, self.turnings
        return a + p.value(v), b + q.value(v)

    def _between(self, u: ArrayLike, first: Array | float, last: Array | float) -> Array:
        u = np.asarray(u, float)
        return np.asarray((1.0 - u) * first + u * last)

    def _at(self, azimuth: Array) -> Array:
        return self.radius * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1)


def _turned(points: Array, angles: Array) -> Array:
    """Points (..., d) turned by angles (...), broadcast against each other."""
    c, s = np.cos(angles), np.sin(angles)
    x, y = points[..., 0], points[..., 1]
    rest = (np.broadcast_to(z, np.broadcast_shapes(z.shape, np.shape(angles))) for z in np.moveaxis(points, -1, 0)[2:])
    return np.stack([c * x - s * y, s * x + c * y, *rest], axis=-1)


def _across(points: Array) -> Array:
    """What points (..., d) move by as an angle about the origin grows: (−y, x), and nothing along z."""
    return np.concatenate(
        [-points[..., 1:2], points[..., :1], np.zeros((*points.shape[:-1], points.shape[-1] - 2))], axis=-1
    )

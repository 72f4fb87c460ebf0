"""Curves that a crown gear leaves on a gear rolling on it, on the unit sphere.

A crown gear turns about an axis perpendicular to its pitch plane; the gear's pitch cone, of half-angle γ, rolls on
that plane and touches it along the pitch line, which meets the sphere at the pitch point. The instantaneous axis
is the pitch line, so the common normal of every contact is a great circle through the pitch point. A contact is told by

    turn       θ of the crown gear, of which the gear turns θ/sin γ
    bearing    t at the pitch point, from the pitch plane to the contact's great circle, towards the gear's axis
    distance   w of the contact from the pitch point along that great circle

and lies at (cos w, sin w cos t, sin w sin t) in axes towards the pitch point, along the pitch plane and towards the
gear's axis. Source: theory of gearing, common normal through the instantaneous axis; Litvin & Fuentes 2004, ch. 6, 21.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .crossing import crossing
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class RolledCurve(Curve):
    """The points of contact with a crown gear, in a gear about +z whose pitch cone rolls on it.

    pitch_angle   γ, half-angle of the pitch cone, radians, 0 < γ ≤ π/2; a crown gear's own is π/2

    Where the turn and the distance are 0 the curve is on the pitch cone, at azimuth 0. It is the flank on the
    clockwise side of the gear's tooth: above the pitch cone its azimuth grows with the polar angle.
    """

    pitch_angle: float

    @abstractmethod
    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """Turn, bearing and distance (...) at parameters u (...), radians."""

    @abstractmethod
    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """Their derivatives (...) by u."""

    def point(self, u: ArrayLike) -> Array:
        turn, bearing, distance = self.contact(u)
        beside, across = np.sin(distance) * np.cos(bearing), np.sin(distance) * np.sin(bearing)
        return self._in_gear(turn, np.cos(distance), beside, across)

    def derivative(self, u: ArrayLike) -> Array:
        turn, bearing, distance = self.contact(u)
        turning, swing, speed = self.contact_rates(u)
        cw, sw, ct, st = np.cos(distance), np.sin(distance), np.cos(bearing), np.sin(bearing)
        moving = self._in_gear(turn, -sw * speed, cw * ct * speed - sw * st * swing, cw * st * speed + sw * ct * swing)
        x, y, _ = np.moveaxis(self._in_gear(turn, cw, sw * ct, sw * st), -1, 0)
        rate = turning / np.sin(self.pitch_angle)
        return moving + np.stack([-rate * y, rate * x, np.zeros_like(x)], axis=-1)

    def polar_angle(self, u: ArrayLike) -> Array:
        """δ (...) at parameters u (...), radians."""
        _, bearing, distance = self.contact(u)
        outward, beside, axial = self._contact_from_gear(bearing, distance)
        return np.arctan2(np.hypot(outward, beside), axial)

    def azimuth(self, u: ArrayLike) -> Array:
        """ψ (...) at parameters u (...), radians, without jumps: 0 where turn and distance are."""
        turn, bearing, distance = self.contact(u)
        outward, beside, _ = self._contact_from_gear(bearing, distance)
        return turn / np.sin(self.pitch_angle) + np.arctan2(beside, outward)

    def at_polar_angle(self, polar: ArrayLike) -> Array:
        """Parameter u (...) at polar angles (...) of an interval in which the polar angle grows or falls throughout.

        Polar angles outside the interval's give its ends.
        """
        target = np.asarray(polar, float)
        start, end = self.interval
        return crossing(
            lambda u: self.polar_angle(u) - target, np.full(target.shape, start), np.full(target.shape, end)
        )

    def _in_gear(self, turn: Array, along: Array, beside: Array, across: Array) -> Array:
        """Vectors (..., 3) in the turned gear."""
        x, y, z = self._seen_from_gear(along, beside, across)
        c, s = np.cos(turn / np.sin(self.pitch_angle)), np.sin(turn / np.sin(self.pitch_angle))
        return np.stack([c * x - s * y, s * x + c * y, z], axis=-1)

    def _contact_from_gear(self, bearing: Array, distance: Array) -> tuple[Array, Array, Array]:
        """The contact, as `_seen_from_gear` has it."""
        beside, across = np.sin(distance) * np.cos(bearing), np.sin(distance) * np.sin(bearing)
        return self._seen_from_gear(np.cos(distance), beside, across)

    def _seen_from_gear(self, along: Array, beside: Array, across: Array) -> tuple[Array, Array, Array]:
        """Components from the gear's axis towards the pitch point, along the pitch plane and along the axis."""
        s, c = np.sin(self.pitch_angle), np.cos(self.pitch_angle)
        return s * along - c * across, beside, c * along + s * across

"""The forms that flanks of bevel gears have on the unit sphere, behind one set of questions."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, Self

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves import octoid
from ...curves.curve import Curve, mapped, turn
from ...curves.octoid import Octoid
from ...curves.rolled import RolledCurve
from ...curves.rolled_involute import RolledInvolute
from ...curves.spherical_involute import (
    SphericalInvolute,
    azimuth,
    polar_angle,
    roll_at_azimuth,
    roll_at_polar_angle,
)

Form = Literal["involute", "octoid"]


@dataclass(frozen=True, kw_only=True)
class SphericalFlank(ABC):
    """A flank on the clockwise side of a tooth about +z, crossing the pitch cone at azimuth 0; radians.

    pitch_angle      γ
    pressure_angle   a, at the pitch point

    Its parameter is the turn u of the crown gear from where the pitch point is touched, negative below the pitch cone:
    flanks that touch have opposite u, and the polar angle grows with u all the way.
    """

    pitch_angle: float
    pressure_angle: float

    @property
    @abstractmethod
    def least_turn(self) -> float:
        """u at the inner end of the flank, where it is least in polar angle."""

    @property
    @abstractmethod
    def greatest_turn(self) -> float:
        """u at its outer end."""

    @abstractmethod
    def parameter_at(self, polar: ArrayLike) -> Array:
        """u (...) at polar angles (...). Raises ValueError where the flank does not reach."""

    @abstractmethod
    def azimuth_at(self, polar: ArrayLike) -> Array:
        """Azimuth (...) at polar angles (...). Raises ValueError where the flank does not reach."""

    @abstractmethod
    def polar_at_azimuth(self, azimuth_angle: float) -> float:
        """Polar angle at an azimuth above the pitch cone; the greatest one where the flank ends before."""

    @abstractmethod
    def curve(self, first: float, last: float) -> Curve:
        """The flank between two polar angles."""

    @abstractmethod
    def rolled(self, first: float, last: float) -> RolledCurve:
        """The flank as its contacts with the crown gear, between two parameters u."""

    @abstractmethod
    def tip_tangent(self, depth: float, radius: float) -> tuple[float, float]:
        """Where the crown gear's flank and a small circle of its tip, tangent to it, touch the gear together.

        depth, radius   of the circle, its centre's angle above the pitch plane, as `SphericalTrochoid` has them

        Turn u and bearing at the pitch point.
        """

    @abstractmethod
    def crown_reaches(self, depth: float, radius: float) -> bool:
        """Whether the crown gear has a flank where it would be tangent to such a circle."""

    @cached_property
    def least_polar(self) -> float:
        return self.polar_at(self.least_turn)

    @cached_property
    def greatest_polar(self) -> float:
        return self.polar_at(self.greatest_turn)

    def polar_at(self, u: float) -> float:
        """Polar angle at a turn u of the crown gear."""
        return float(self.rolled(u, u).polar_angle(u))

    @property
    def pitch_azimuth(self) -> float:
        """ψ_p, azimuth of the pitch cone from the inner end of the flank."""
        return -float(self.azimuth_at(self.least_polar))

    @property
    def crown(self) -> Self:
        """The crown gear's own flank: S-shaped for the involute, a great circle for the octoid."""
        return replace(self, pitch_angle=np.pi / 2.0)


@dataclass(frozen=True, kw_only=True)
class InvoluteFlank(SphericalFlank):
    """The spherical involute of the base cone sin γ_b = sin γ cos a (eq. G2), from its cusp to its end at π − γ_b.

    Source: Al-Daccak 1989, eqs. (3.1)–(3.14), the base cone corrected.
    """

    @cached_property
    def base_cone_angle(self) -> float:
        return float(np.arcsin(np.sin(self.pitch_angle) * np.cos(self.pressure_angle)))

    @cached_property
    def _pitch_roll(self) -> float:
        return float(roll_at_polar_angle(self.pitch_angle, self.base_cone_angle))

    @cached_property
    def pitch_azimuth(self) -> float:
        """ψ_p, azimuth of the involute at the pitch cone from its cusp."""
        return float(azimuth(self._pitch_roll, self.base_cone_angle))

    @property
    def least_polar(self) -> float:
        return self.base_cone_angle

    @property
    def greatest_polar(self) -> float:
        return np.pi - self.base_cone_angle

    @property
    def least_turn(self) -> float:
        return -self._pitch_roll * float(np.sin(self.pitch_angle))

    @property
    def greatest_turn(self) -> float:
        return self.least_turn + float(np.pi / np.cos(self.pressure_angle))

    def polar_at(self, u: float) -> float:
        roll = self._pitch_roll + u / np.sin(self.pitch_angle)
        return float(polar_angle(roll, self.base_cone_angle))

    def parameter_at(self, polar: ArrayLike) -> Array:
        return (roll_at_polar_angle(polar, self.base_cone_angle) - self._pitch_roll) * np.sin(self.pitch_angle)

    def azimuth_at(self, polar: ArrayLike) -> Array:
        return azimuth(roll_at_polar_angle(polar, self.base_cone_angle), self.base_cone_angle) - self.pitch_azimuth

    def polar_at_azimuth(self, azimuth_angle: float) -> float:
        meeting = self.pitch_azimuth + azimuth_angle
        if meeting >= self.pitch_azimuth + self.azimuth_at(self.greatest_polar):
            return self.greatest_polar
        return float(polar_angle(roll_at_azimuth(meeting, self.base_cone_angle), self.base_cone_angle))

    def curve(self, first: float, last: float) -> Curve:
        a, b = (float(roll) for roll in roll_at_polar_angle([first, last], self.base_cone_angle))
        return mapped(
            SphericalInvolute(base_cone_angle=self.base_cone_angle, interval=(a, b)), turn(-self.pitch_azimuth, 3)
        )

    def rolled(self, first: float, last: float) -> RolledCurve:
        return RolledInvolute(pitch_angle=self.pitch_angle, pressure_angle=self.pressure_angle, interval=(first, last))

    def tip_tangent(self, depth: float, radius: float) -> tuple[float, float]:
        distance = np.arcsin(np.clip(np.sin(depth) / np.sin(self.pressure_angle), -1.0, 1.0)) + radius
        return -float(distance / np.cos(self.pressure_angle)), self.pressure_angle

    def crown_reaches(self, depth: float, radius: float) -> bool:
        sine = np.sin(depth) / np.sin(self.pressure_angle)
        return bool(abs(sine) < 1.0 and np.arcsin(sine) + radius < np.pi / 2.0)


@dataclass(frozen=True, kw_only=True)
class OctoidFlank(SphericalFlank):
    """The octoid: the crown gear's flank is a great circle.

    Source: Litvin & Fuentes 2004, Gear Geometry and Applied Theory, ch. 21.
    """

    @cached_property
    def least_turn(self) -> float:
        return octoid.least_turn(self.pitch_angle, self.pressure_angle)

    @property
    def greatest_turn(self) -> float:
        return np.pi / 2.0

    def parameter_at(self, polar: ArrayLike) -> Array:
        return octoid.turn_at_polar_angle(polar, self.pitch_angle, self.pressure_angle)

    def azimuth_at(self, polar: ArrayLike) -> Array:
        return self.rolled(0.0, 0.0).azimuth(self.parameter_at(polar))

    def polar_at_azimuth(self, azimuth_angle: float) -> float:
        from scipy.optimize import brentq

        curve = self.rolled(0.0, self.greatest_turn)
        if azimuth_angle >= curve.azimuth(self.greatest_turn):
            return self.greatest_polar
        found = brentq(lambda u: float(curve.azimuth(u)) - azimuth_angle, 0.0, self.greatest_turn, xtol=1e-15)
        return float(curve.polar_angle(found))

    def curve(self, first: float, last: float) -> Curve:
        a, b = (float(u) for u in self.parameter_at([first, last]))
        return self.rolled(a, b)

    def rolled(self, first: float, last: float) -> RolledCurve:
        return Octoid(pitch_angle=self.pitch_angle, pressure_angle=self.pressure_angle, interval=(first, last))

    def tip_tangent(self, depth: float, radius: float) -> tuple[float, float]:
        s, c = np.sin(self.pressure_angle), np.cos(self.pressure_angle)
        height = self._tangent_height(depth, radius)
        u = -np.arcsin(np.clip(height / (c * np.hypot(s, height)), -1.0, 1.0))
        return float(u), float(np.arctan2(s, c * np.cos(u)))

    def crown_reaches(self, depth: float, radius: float) -> bool:
        return bool(abs(self._tangent_height(depth, radius)) < np.cos(self.pressure_angle))

    def _tangent_height(self, depth: float, radius: float) -> float:
        """Sine of the latitude at which the crown gear's great circle touches the small circle."""
        return float((np.sin(depth) + np.sin(self.pressure_angle) * np.sin(radius)) / np.cos(radius))


def spherical_flank(form: Form, pitch_angle: float, pressure_angle: float) -> SphericalFlank:
    """The flank of a form. Raises KeyError for a form that is none."""
    forms: dict[str, type[SphericalFlank]] = {"involute": InvoluteFlank, "octoid": OctoidFlank}
    return forms[form](pitch_angle=pitch_angle, pressure_angle=pressure_angle)

"""Followers: where each touches the cam, by the support function of the profile.

The cam turns clockwise; what follows is seen from the cam, about which the follower then goes counter-clockwise by
the cam angle ψ. All is given in the follower's own frame, which turns with it: its x axis (1 as a complex number)
points from the cam's axis along the stem of a translating follower, or to the pivot of an oscillating one.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True, eq=False)
class Contact:
    """Contact of cam and follower, for positions (...).

    normal    unit normal n of the profile there, outwards, complex
    support   p, distance of the tangent from the cam's axis
    along     q = dp/dν, the eccentricity: distance of the common normal from the cam's axis
    speed     ds/dψ of the point along the profile, ρ dν/dψ; > 0 where there is no cusp
    turning   dν/dψ of the normal
    pressure  tangent of the pressure angle, between the normal and the way the follower's point goes
    reach     where on a flat face: from the stem's line, or the foot of the pivot; 0 on a roller
    """

    normal: Complex
    support: Array
    along: Array
    speed: Array
    turning: Array
    pressure: Array
    reach: Array


class Follower(ABC):
    """A follower and where it stands."""

    @abstractmethod
    def contact(self, s: Array) -> Contact:
        """Contact for displacement and its derivatives s, s′, s″, … (≥ 3, ...) by the cam angle, radians."""

    @property
    @abstractmethod
    def base_radius(self) -> float:
        """Radius of the base circle: the profile's at displacement 0."""


class FlatFace(Follower):
    """A follower with a flat face."""


@dataclass(frozen=True, kw_only=True)
class TranslatingFlatFace(FlatFace):
    """A flat face square to the way it goes: p = r_b + s, q = s′, ρ = p + s″."""

    radius: float

    @property
    def base_radius(self) -> float:
        return self.radius

    def contact(self, s: Array) -> Contact:
        p = self.radius + s[0]
        zero, one = np.zeros_like(p), np.ones_like(p)
        return Contact(
            normal=one.astype(complex), support=p, along=s[1], speed=p + s[2], turning=one, pressure=zero,
            reach=s[1],
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class OscillatingFlatFace(FlatFace):
    """A flat face that swings about a pivot.

    pivot_distance  d
    offset          e of the face from the pivot, away from the cam's axis
    initial_angle   φ₀ between the face and the line from pivot to cam's axis at displacement 0, radians
    sign            σ: +1 if the lifting follower turns against the cam, −1 if with it

    p = d sin φ + e at ν = ψ + σ(φ − π/2), φ = φ₀ + s; q = d cos φ s′/(1 + σ s′).
    Source: Al-Daccak 1989, ch. 4.5.1.
    """

    pivot_distance: float
    offset: float
    initial_angle: float
    sign: int

    @property
    def base_radius(self) -> float:
        return float(self.pivot_distance * np.sin(self.initial_angle) + self.offset)

    def contact(self, s: Array) -> Contact:
        d, angle, turning = self.pivot_distance, self.initial_angle + s[0], 1.0 + self.sign * s[1]
        sine, cosine = np.sin(angle), np.cos(angle)
        p = d * sine + self.offset
        bend = d * (cosine * s[2] - sine * s[1] ** 2 * turning) / turning**2
        return Contact(
            normal=np.exp(1j * self.sign * (angle - np.pi / 2.0)),
            support=p,
            along=d * cosine * s[1] / turning,
            speed=p * turning + bend,
            turning=turning,
            pressure=self.offset * turning / (d * cosine),
            reach=d * cosine / turning,
        )


class Roller(Follower):
    """A follower with a roller, whose centre goes along the pitch curve; the profile is its parallel inside."""

    roller_radius: float

    @abstractmethod
    def centre(self, s: Array) -> tuple[Complex, Complex, Complex]:
        """The roller's centre Z (...) and its first two derivatives by ψ, in the follower's frame."""

    @abstractmethod
    def pressure(self, s: Array) -> Array:
        """Tangent of the pressure angle (...)."""

    @property
    def base_radius(self) -> float:
        return float(np.abs(self.centre(np.zeros(3))[0])) - self.roller_radius

    def contact(self, s: Array) -> Contact:
        """With W = iZ + Z′ along the pitch curve: n = −iW/|W|, dν/dψ = 1 + Im(W̄W′)/|W|²."""
        z, z1, z2 = self.centre(s)
        along, bend = 1j * z + z1, 1j * z1 + z2
        pace = np.abs(along)
        normal = -1j * along / pace
        turning = 1.0 + np.imag(np.conj(along) * bend) / pace**2
        return Contact(
            normal=normal,
            support=np.real(z * np.conj(normal)) - self.roller_radius,
            along=np.real(z * np.conj(1j * normal)),
            speed=pace - self.roller_radius * turning,
            turning=turning,
            pressure=self.pressure(s),
            reach=np.zeros_like(pace),
        )


@dataclass(frozen=True, kw_only=True)
class TranslatingRoller(Roller):
    """A roller on a stem that misses the cam's axis by an offset ε: Z = √((r_b + r_r)² − ε²) + s + iε.

    radius   r_b; the offset is towards the side that the profile comes from, tan α = (s′ − ε)/(y₀ + s)
    """

    radius: float
    offset: float
    roller_radius: float

    @property
    def base_radius(self) -> float:
        return self.radius

    def _height(self, s: Array) -> Array:
        return np.sqrt((self.radius + self.roller_radius) ** 2 - self.offset**2) + s[0]

    def centre(self, s: Array) -> tuple[Complex, Complex, Complex]:
        return np.asarray(self._height(s) + 1j * self.offset, complex), s[1].astype(complex), s[2].astype(complex)

    def pressure(self, s: Array) -> Array:
        return (s[1] - self.offset) / self._height(s)


@dataclass(frozen=True, kw_only=True)
class OscillatingRoller(Roller):
    """A roller on an arm that swings about a pivot: Z = d − a e^{iσφ}, φ = φ₀ + s.

    pivot_distance  d
    arm_length      a from the pivot to the roller's centre
    initial_angle   φ₀ between the arm and the line from pivot to cam's axis at displacement 0, radians
    sign            σ: +1 if the lifting follower turns against the cam, −1 if with it

    tan α = (a (1 + σ s′) − d cos φ)/(d sin φ).
    """

    pivot_distance: float
    arm_length: float
    initial_angle: float
    roller_radius: float
    sign: int

    def centre(self, s: Array) -> tuple[Complex, Complex, Complex]:
        arm = self.arm_length * np.exp(1j * self.sign * (self.initial_angle + s[0]))
        rate = 1j * self.sign * s[1]
        return self.pivot_distance - arm, -rate * arm, -(1j * self.sign * s[2] + rate**2) * arm

    def pressure(self, s: Array) -> Array:
        angle = self.initial_angle + s[0]
        lever = self.arm_length * (1.0 + self.sign * s[1]) - self.pivot_distance * np.cos(angle)
        return lever / (self.pivot_distance * np.sin(angle))


def initial_angle_of(base_radius: float, roller_radius: float, pivot_distance: float, arm_length: float) -> float:
    """φ₀ (radians) at which the roller of an arm rests on a base circle; not a number where it cannot reach it."""
    reach = base_radius + roller_radius
    cosine = (pivot_distance**2 + arm_length**2 - reach**2) / (2.0 * pivot_distance * arm_length)
    return float(np.arccos(cosine)) if abs(cosine) <= 1.0 else float("nan")

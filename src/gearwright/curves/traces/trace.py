"""The concept of a tooth trace: the turn w(r) of a bevel gear's spherical section as the cone distance r grows."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from ...moments.quadrature import adaptive

_SETTLED = 1e-14  # of ∫ r^p dr: rounding of the two rules that are compared is below it
_ROUNDING = 1e-12  # of a square: how far below nought rounding leaves it where a trace ends


@dataclass(frozen=True, kw_only=True)
class Trace(ABC):
    """A tooth trace, nought at its mean cone distance; positive turns are right-handed teeth.

    Seen from the apex, the outer half of a right-hand tooth is inclined clockwise, which is a positive
    turn about +z (ISO 23509, 3.1.3). On the crown gear the trace of a right-hand tooth is the plane curve of polar
    angle θ(r), and r dθ/dr = tan β(r) for its spiral angle β. Beyond its reach a trace raises ValueError.
    """

    @property
    @abstractmethod
    def reach(self) -> tuple[float, float]:
        """The least and the greatest cone distance on which the trace exists."""

    @abstractmethod
    def crown_angle(self, distance: ArrayLike) -> Array:
        """θ (...) of a right-hand tooth on the crown gear at cone distances r (...), radians."""

    @abstractmethod
    def spiral_angle(self, distance: ArrayLike) -> Array:
        """β (...) of a right-hand tooth, between trace and radius, radians."""

    @abstractmethod
    def turn(self, distance: ArrayLike) -> Array:
        """w (...) at cone distances r (...), radians."""

    @abstractmethod
    def slope(self, distance: ArrayLike) -> Array:
        """dw/dr (...)."""

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^power e^{i harmonic w(r)} dr between two cone distances: closed for harmonic 0, else by quadrature."""
        if harmonic == 0:
            return power_integral(complex(power + 1), start, stop)
        largest = max(start, stop)

        def integrand(r: Array) -> Array:
            weight, angle = (r / largest) ** power, harmonic * self.turn(r)
            return np.stack([weight, weight * np.cos(angle), weight * np.sin(angle)], axis=-1)

        (_, real, imaginary), _, _ = adaptive(integrand, np.array([start, stop]), _SETTLED)
        return complex(real, imaginary) * largest**power


@dataclass(frozen=True, kw_only=True)
class SpiralTrace(Trace, ABC):
    """A trace of a given spiral angle at the mean cone distance.

    ratio               w/θ: teeth of the crown gear over teeth of the gear, 1/sin γ; negative for a left hand
    mean_distance       r_m, where w = 0
    mean_spiral_angle   β_m in [0, 90°), radians
    """

    ratio: float
    mean_distance: float
    mean_spiral_angle: float

    def __post_init__(self) -> None:
        if not self.mean_distance > 0.0:
            raise ValueError(f"a mean cone distance is greater than 0, not {self.mean_distance:g}")
        if not 0.0 <= self.mean_spiral_angle < np.pi / 2.0:
            angle = np.degrees(self.mean_spiral_angle)
            raise ValueError(f"a mean spiral angle is from 0 to less than 90°, not {angle:g}°; the hand is the ratio's")

    def turn(self, distance: ArrayLike) -> Array:
        return self.ratio * self.crown_angle(distance)

    def slope(self, distance: ArrayLike) -> Array:
        return self.ratio * np.tan(self.spiral_angle(distance)) / np.asarray(distance, float)

    def _beyond(self, distance: Array) -> Array:
        """r² − r_m² (...), which keeps its digits near r_m."""
        return (distance - self.mean_distance) * (distance + self.mean_distance)


def root(square: Array, scale: Array) -> Array:
    """√square (...), a length on a trace; at the end of its reach rounding of scale² (...) may fall below nought.

    Raises ValueError beyond.
    """
    if np.any(square < -_ROUNDING * scale**2):
        raise ValueError("a tooth trace has no points beyond its reach")
    return np.sqrt(np.maximum(square, 0.0))


def power_integral(exponent: complex, start: float, stop: float) -> complex:
    """∫ r^(exponent − 1) dr, through expm1, which keeps every digit of a thin shell."""
    if start == 0.0:
        return complex(stop**exponent / exponent)
    logarithm = np.log1p((stop - start) / start)
    return complex(start**exponent * np.expm1(exponent * logarithm) / exponent)

"""Tooth traces: the turn w(r) of a bevel gear's spherical section about its axis as the cone distance r grows."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.quadrature import gauss_legendre

_NODES = 40  # a smooth trace over a face width is resolved to rounding by half as many


@dataclass(frozen=True, kw_only=True)
class Trace(ABC):
    """A tooth trace, nought at its mean cone distance; positive turns are right-handed teeth.

    Seen from the apex, the outer half of a right-hand tooth is inclined clockwise, which is a positive
    turn about +z (ISO 23509, 3.1.3).
    """

    @abstractmethod
    def turn(self, distance: ArrayLike) -> Array:
        """w (...) at cone distances r (...), radians."""

    @abstractmethod
    def slope(self, distance: ArrayLike) -> Array:
        """dw/dr (...)."""

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^power e^{i harmonic w(r)} dr between two cone distances, by Gauss–Legendre quadrature."""
        x, weights = gauss_legendre(_NODES)
        half = (stop - start) / 2.0
        r = (start + stop) / 2.0 + half * x
        return complex(np.sum(weights * r**power * np.exp(1j * harmonic * self.turn(r))) * half)


@dataclass(frozen=True, kw_only=True)
class StraightTrace(Trace):
    """Straight teeth: w = 0."""

    def turn(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def slope(self, distance: ArrayLike) -> Array:
        return np.zeros(np.shape(distance))

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^power dr in closed form."""
        del harmonic
        return _power_integral(complex(power + 1), start, stop)


@dataclass(frozen=True, kw_only=True)
class LogarithmicTrace(Trace):
    """The logarithmic spiral w = k ln(r/r_m), which keeps its spiral angle all along: k = tan β_m / sin γ.

    rate            k
    mean_distance   r_m, where w = 0

    Source: Al-Daccak 1989, eqs. (3.20)–(3.21).
    """

    rate: float
    mean_distance: float

    def __post_init__(self) -> None:
        if not self.mean_distance > 0.0:
            raise ValueError(f"a mean cone distance is greater than 0, not {self.mean_distance:g}")

    def turn(self, distance: ArrayLike) -> Array:
        return self.rate * np.log(np.asarray(distance, float) / self.mean_distance)

    def slope(self, distance: ArrayLike) -> Array:
        return self.rate / np.asarray(distance, float)

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^p e^{ijw} dr = [r^{p+1} e^{ijw}/(p + 1 + ijk)] in closed form."""
        exponent = power + 1 + 1j * harmonic * self.rate
        phase = np.exp(-1j * harmonic * self.rate * np.log(self.mean_distance))
        return complex(phase * _power_integral(exponent, start, stop))


def _power_integral(exponent: complex, start: float, stop: float) -> complex:
    """∫ r^(exponent − 1) dr, through expm1, which keeps every digit of a thin shell."""
    if start == 0.0:
        return complex(stop**exponent / exponent)
    logarithm = np.log1p((stop - start) / start)
    return complex(start**exponent * np.expm1(exponent * logarithm) / exponent)

"""The logarithmic spiral."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from .trace import SpiralTrace, power_integral


@dataclass(frozen=True, kw_only=True)
class LogarithmicTrace(SpiralTrace):
    """The logarithmic spiral θ = tan β_m ln(r/r_m), which keeps its spiral angle all along.

    Source: Al-Daccak 1989, eqs. (3.20)–(3.21).
    """

    @property
    def reach(self) -> tuple[float, float]:
        return (0.0, np.inf)

    @property
    def rate(self) -> float:
        """k of w = k ln(r/r_m): tan β_m / sin γ, signed by the hand."""
        return float(self.ratio * np.tan(self.mean_spiral_angle))

    def crown_angle(self, distance: ArrayLike) -> Array:
        r = np.asarray(distance, float)
        return np.tan(self.mean_spiral_angle) * np.log1p((r - self.mean_distance) / self.mean_distance)

    def spiral_angle(self, distance: ArrayLike) -> Array:
        return np.full(np.shape(distance), self.mean_spiral_angle)

    def radial_integral(self, power: int, harmonic: int, start: float, stop: float) -> complex:
        """∫ r^p e^{ijw} dr = [r^{p+1} e^{ijw}/(p + 1 + ijk)] in closed form."""
        exponent = power + 1 + 1j * harmonic * self.rate
        phase = np.exp(-1j * harmonic * self.rate * np.log(self.mean_distance))
        return complex(phase * power_integral(exponent, start, stop))

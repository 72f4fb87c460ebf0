"""Polynomials of a motion's parameter, by which sections vary along it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array, ArrayLike

_REAL = 1e-9  # of a root's size: an imaginary part that rounding leaves in a double one


@dataclass(frozen=True, kw_only=True)
class Polynomial:
    """c₀ + c₁ x + c₂ x² + … of x = v − centre.

    coefficients   c₀, c₁, …: at least one
    centre         the parameter from which x is counted; near the motion's own keeps the digits
    """

    coefficients: tuple[float, ...]
    centre: float = 0.0

    def value(self, v: ArrayLike) -> Array:
        """At parameters v (...)."""
        return self._sum(self.coefficients, v)

    def derivative(self, v: ArrayLike) -> Array:
        """d/dv at parameters v (...)."""
        return self._sum([k * c for k, c in enumerate(self.coefficients)][1:] or [0.0], v)

    def __neg__(self) -> Polynomial:
        return replace(self, coefficients=tuple(-c for c in self.coefficients))

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        """Parameters strictly between two at which the derivative is nought."""
        slopes = [k * c for k, c in enumerate(self.coefficients)][1:]
        roots = np.roots(slopes[::-1])
        real = roots.real[np.abs(roots.imag) <= _REAL * np.abs(roots)] + self.centre
        return tuple(float(v) for v in np.sort(real) if start < v < finish)

    def _sum(self, coefficients: tuple[float, ...] | list[float], v: ArrayLike) -> Array:
        x = np.asarray(v, float) - self.centre
        found = np.zeros_like(x)
        for c in reversed(coefficients):
            found = found * x + c
        return found


def parabola(most: float, start: float, finish: float) -> Polynomial:
    """most (2 (v − start)/(finish − start) − 1)²: nought in the middle and `most` at both ends, as of crowning."""
    half = (finish - start) / 2.0
    return Polynomial(coefficients=(0.0, 0.0, most / half**2), centre=(start + finish) / 2.0)

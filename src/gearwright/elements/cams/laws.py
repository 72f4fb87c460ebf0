"""Motion laws: how a follower gets from rest to rest, s(x) from 0 to 1 over x from 0 to 1."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.polynomial import polynomial

from ...arrays import Array, ArrayLike


class Law(Protocol):
    """A law of motion from rest to rest; its velocity is continuous, at both ends it is 0."""

    @property
    def breaks(self) -> tuple[float, ...]:
        """Where, inside, one analytic piece ends and the next begins."""

    @property
    def starts_smoothly(self) -> bool:
        """Whether the acceleration is 0 at both ends, as beside a dwell it should be."""

    def derivatives(self, x: ArrayLike) -> Array:
        """s, s′, s″, s‴ (4, ...) at x (...)."""


@dataclass(frozen=True, kw_only=True)
class FixedLaw:
    """A law without free values, by its closed form."""

    formula: Callable[[Array], Array]
    breaks: tuple[float, ...] = ()
    starts_smoothly: bool = True

    def derivatives(self, x: ArrayLike) -> Array:
        """s, s′, s″, s‴ (4, ...) at x (...)."""
        return self.formula(np.asarray(x, float))


def _polynomial(*coefficients: float) -> Callable[[Array], Array]:
    """The law Σ c_k x^k, lowest power first."""
    series = [polynomial.polyder(np.array(coefficients), order) for order in range(4)]
    return lambda x: np.stack([np.asarray(polynomial.polyval(x, c)) for c in series])


def _harmonic(x: Array) -> Array:
    """(1 − cos πx)/2: half a turn of a point on a circle."""
    c, s = np.cos(np.pi * x), np.sin(np.pi * x)
    return np.stack([(1.0 - c) / 2.0, np.pi / 2.0 * s, np.pi**2 / 2.0 * c, -(np.pi**3) / 2.0 * s])


def _cycloidal(x: Array) -> Array:
    """x − sin 2πx/2π: a point on a rolling circle."""
    turn = 2.0 * np.pi
    c, s = np.cos(turn * x), np.sin(turn * x)
    return np.stack([x - s / turn, 1.0 - c, turn * s, turn**2 * c])


def _modified_sine(x: Array) -> Array:
    """The acceleration is a sine of a short period in the first and last eighth, of three times that between.

    Source: Norton, Cam Design and Manufacturing Handbook, ch. 3 (Neklutin's law).
    """
    middle = (x >= 0.125) & (x <= 0.875)
    k = np.where(middle, 1.0 / 3.0, 1.0)  # the middle sine's slowness
    angle = 4.0 * np.pi * k * x + np.where(middle, np.pi / 3.0, 0.0)
    start = np.where(middle, 2.0, np.where(x > 0.5, 4.0, 0.0))
    c, s = np.cos(angle), np.sin(angle)
    size = np.where(middle, 9.0, 1.0)
    return np.stack(
        [
            start + np.pi * x - size / 4.0 * s,
            np.pi * (1.0 - size * k * c),
            4.0 * np.pi**2 * size * k**2 * s,
            16.0 * np.pi**3 * size * k**3 * c,
        ]
    ) / (4.0 + np.pi)


FIXED_LAWS: dict[str, FixedLaw] = {
    "cycloidal": FixedLaw(formula=_cycloidal),
    "harmonic": FixedLaw(formula=_harmonic, starts_smoothly=False),
    "3-4-5": FixedLaw(formula=_polynomial(0, 0, 0, 10, -15, 6)),
    "4-5-6-7": FixedLaw(formula=_polynomial(0, 0, 0, 0, 35, -84, 70, -20)),
    "modified-sine": FixedLaw(formula=_modified_sine, breaks=(0.125, 0.875)),
}
"""The laws of the textbooks, by name."""

SPLINE = "spline"
"""The name of the law with free values."""

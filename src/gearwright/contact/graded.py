"""A function of one variable as polynomials on panels that shrink towards its foot, where its slope may be a root."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from ..arrays import Array, ArrayLike

_PANELS = 9  # halving: the innermost reaches 1/256 in the root of the height, 1.5e-5 of the height
_DEGREE = 24  # a root at, or anywhere below, the foot is then resolved to rounding on every panel
_LEAST = 1e-3  # of that root: nearer to the foot slopes are quotients of roundings, and carried on in x²


@dataclass(frozen=True, kw_only=True)
class Graded:
    """Chebyshev series in x = √((u − foot)/(head − foot)) on [0, 2^−8], [2^−8, 2^−7], … [1/2, 1].

    A flank that begins on its base cone has a half angle that goes as x³, one that begins a little above it has that
    singularity a little below its foot: no single series in u or x resolves both.

    series   (degree + 1, panels) of the values, over each panel from −1 to 1
    """

    foot: float
    head: float
    series: Array

    @classmethod
    def of(cls, function: Callable[[Array], Array], foot: float, head: float) -> Graded:
        """The same function between foot and head, where alone it is evaluated."""
        nodes = chebyshev.chebpts1(_DEGREE + 1)
        low, high = _bounds()
        x = (low + high) / 2.0 + (high - low) / 2.0 * nodes[:, None]
        values = function(np.clip(foot + (head - foot) * x * x, foot, head))
        series = np.linalg.solve(chebyshev.chebvander(nodes, _DEGREE), values)
        return cls(foot=foot, head=head, series=np.asarray(series, np.float64))

    def value(self, u: ArrayLike) -> Array:
        """Values (...) at places (...)."""
        return self._evaluated(self.series, self._root(u))

    def slope(self, u: ArrayLike) -> Array:
        """Derivatives (...) at places (...): those in x times dx/du = 1/(2x (head − foot))."""
        x = self._root(u)
        near, far = self._quotient(np.array([_LEAST, 2.0 * _LEAST]))
        carried_on = near + (far - near) * (x * x - _LEAST**2) / (3.0 * _LEAST**2)
        return np.where(x < _LEAST, carried_on, self._quotient(np.maximum(x, _LEAST)))

    def _quotient(self, x: Array) -> Array:
        low, high = _bounds()
        rising = self._evaluated(chebyshev.chebder(self.series) * (2.0 / (high - low)), x)
        return np.asarray(rising / (2.0 * x * (self.head - self.foot)), np.float64)

    def _root(self, u: ArrayLike) -> Array:
        fraction = (np.asarray(u, float) - self.foot) / (self.head - self.foot)
        return np.sqrt(np.clip(fraction, 0.0, 1.0))

    def _evaluated(self, series: Array, x: Array) -> Array:
        low, high = _bounds()
        panel = np.minimum(np.searchsorted(high, x), _PANELS - 1)
        local = (2.0 * x - low[panel] - high[panel]) / (high[panel] - low[panel])
        return np.asarray(chebyshev.chebval(local, series[:, panel], tensor=False), np.float64)


def _bounds() -> tuple[Array, Array]:
    """Where the panels begin and end (panels,)."""
    high: Array = np.exp2(np.arange(1 - _PANELS, 1, dtype=np.float64))
    low: Array = np.concatenate([np.zeros(1), high[:-1]])
    return low, high

"""The law with free values: a spline of degree 5 that starts and ends as a dwell does."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from ...arrays import Array, ArrayLike

_DEGREE = 5
_REST = 3  # control values of 0, and of 1, that make s′ and s″ vanish at an end


@dataclass(frozen=True, kw_only=True)
class SplineLaw:
    """The B-spline of degree 5 with control values 0, 0, 0, v₁ … v_n, 1, 1, 1 over equal spans.

    values   v₁ … v_n, the free ones; s grows throughout where they do

    Velocity and acceleration are 0 at both ends, so that with dwells or other moves it makes one periodic function
    that is twice continuously differentiable (four times inside a move).
    """

    values: tuple[float, ...]

    @property
    def breaks(self) -> tuple[float, ...]:
        return tuple(_knots(len(self.values))[_DEGREE + 1 : -_DEGREE - 1].tolist())

    @property
    def starts_smoothly(self) -> bool:
        return True

    def derivatives(self, x: ArrayLike) -> Array:
        """s, s′, s″, s‴ (4, ...) at x (...)."""
        constant, free = spline_basis(np.asarray(x, float).ravel(), len(self.values))
        return (constant + free @ np.array(self.values)).reshape(4, *np.shape(x))


def spline_basis(x: Array, count: int) -> tuple[Array, Array]:
    """The derivatives of a law with so many free values, at x (n,): (4, n) + (4, n, count) @ values."""
    from scipy.interpolate import BSpline

    spline = BSpline(_knots(count), np.eye(count + 2 * _REST), _DEGREE)
    x = np.clip(x, 0.0, 1.0)  # rounding may leave the last place of a move just beyond it
    table = np.stack([spline(x, nu=order) for order in range(4)])
    return table[..., -_REST:].sum(axis=-1), table[..., _REST:-_REST]


def even_values(count: int) -> tuple[float, ...]:
    """Control values on the straight line, from which a law is begun."""
    knots = _knots(count)
    return tuple(float(np.mean(knots[i + 1 : i + 1 + _DEGREE])) for i in range(_REST, _REST + count))


def fitted_values(derivatives: Array, x: Array, count: int) -> tuple[float, ...]:
    """The ascending control values whose law is nearest, in the mean square, to a law's s (n,) at x (n,)."""
    constant, free = spline_basis(x, count)
    found = np.linalg.lstsq(free[0], derivatives[0] - constant[0], rcond=None)[0]
    return tuple(np.maximum.accumulate(np.clip(found, 0.0, 1.0)).tolist())


@cache
def _knots(count: int) -> Array:
    spans = count + 2 * _REST - _DEGREE
    return np.concatenate([np.zeros(_DEGREE), np.linspace(0.0, 1.0, spans + 1), np.ones(_DEGREE)])

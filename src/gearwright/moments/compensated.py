"""Sums and products that keep what floating point drops.

Error-free transformations: a sum or product of two float64 numbers as a pair (value, error) whose
exact sum is the exact result. On them: sums with one rounding at the end, and doubled arithmetic
(about 32 digits, a number being a pair high + low). All functions work elementwise on arrays.

Sources: Knuth, TAOCP 2, §4.2.2 (two_sum); Dekker, Numer. Math. 18 (1971) (two_product, doubled
arithmetic); Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) (sums).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array

Doubled = tuple[Array, Array]
"""A number in doubled precision: high and low part, |low| ≤ ulp(high)/2."""

_SPLITTER = 2.0**27 + 1.0


def two_sum(a: Array, b: Array) -> Doubled:
    """a + b as (rounded sum, its rounding error), exactly, whatever the magnitudes."""
    total = a + b
    b_part = total - a
    return total, (a - (total - b_part)) + (b - b_part)


def two_product(a: Array, b: Array) -> Doubled:
    """a · b as (rounded product, its rounding error), exactly, for |a|, |b| < 1e290."""
    product = a * b
    a_high, a_low = _halves(a)
    b_high, b_low = _halves(b)
    return product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def _halves(a: Array) -> Doubled:
    wide = _SPLITTER * a
    high = wide - (wide - a)
    return high, a - high


def add(x: Doubled, y: Doubled) -> Doubled:
    """x + y, with an error of about 2⁻¹⁰⁵ (|x| + |y|)."""
    high, low = two_sum(x[0], y[0])
    return _renormalised(high, low + (x[1] + y[1]))


def subtract(x: Doubled, y: Doubled) -> Doubled:
    """x − y, with an error of about 2⁻¹⁰⁵ (|x| + |y|)."""
    return add(x, (-y[0], -y[1]))


def multiply(x: Doubled, y: Doubled) -> Doubled:
    """x · y, with a relative error of about 2⁻¹⁰³."""
    high, low = two_product(x[0], y[0])
    return _renormalised(high, low + (x[0] * y[1] + x[1] * y[0]))


def _renormalised(high: Array, low: Array) -> Doubled:
    total = high + low
    return total, low - (total - high)


def compensated_sum(values: Array) -> Array:
    """Σ over the last axis (..., n) → (...), as if added in doubled precision and rounded once."""
    return doubled_sum(values, np.zeros_like(values))


def doubled_sum(high: Array, low: Array) -> Array:
    """Σ (high + low) over the last axis, as if in doubled precision and rounded once.

    A tree of two_sum: each level halves the length and keeps its rounding errors apart.
    """
    count = high.shape[-1]
    if count == 0:
        return np.zeros(high.shape[:-1])
    while count > 1:
        half = count // 2
        odd_high, odd_low = high[..., 2 * half :], low[..., 2 * half :]
        total, error = two_sum(high[..., :half], high[..., half : 2 * half])
        error += low[..., :half] + low[..., half : 2 * half]
        high, low = np.concatenate([total, odd_high], -1), np.concatenate([error, odd_low], -1)
        count = high.shape[-1]
    return np.asarray(high[..., 0] + low[..., 0])


class RunningSum:
    """Lane-wise compensated sum of many blocks of the same shape, or narrower on the last axis."""

    def __init__(self, shape: tuple[int, ...]):
        self._high = np.zeros(shape)
        self._low = np.zeros(shape)

    def take(self, high: Array, low: Array | None = None) -> None:
        """Adds a block, in plain or doubled precision."""
        lanes = (..., slice(high.shape[-1]))
        total, error = two_sum(self._high[lanes], high)
        self._high[lanes] = total
        self._low[lanes] += error if low is None else error + low

    def total(self) -> Array:
        """The sum of everything taken, over the last axis, rounded once."""
        return doubled_sum(self._high, self._low)

"""Sums that keep what floating point drops.

The sum of two float64 numbers as a pair (value, error) whose exact sum is the exact result; on it, sums with one
rounding at the end. All functions work elementwise on arrays.

Sources: Knuth, TAOCP 2, §4.2.2 (two_sum); Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) (sums).
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array

Doubled = tuple[Array, Array]
"""A number in doubled precision: high and low part, |low| ≤ ulp(high)/2."""


def two_sum(a: Array, b: Array) -> Doubled:
    """a + b as (rounded sum, its rounding error), exactly, whatever the magnitudes."""
    total = a + b
    b_part = total - a
    return total, (a - (total - b_part)) + (b - b_part)


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

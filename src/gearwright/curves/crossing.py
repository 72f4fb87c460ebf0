"""Roots of many functions of one variable at once."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array

_MOST_STEPS = 60
_ROUNDING = 4.0 * np.finfo(float).eps


def crossing(function: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """Where functions change sign between low and high (n,), to rounding, by the Illinois rule.

    function   values (n,) of the functions at x (n,), one of each

    Where there is no change of sign, the end nearer to one.
    """
    a, b, at_a, at_b = low.astype(float), high.astype(float), function(low), function(high)
    done = at_b == 0.0
    for _ in range(_MOST_STEPS):
        rise = at_b - at_a
        secant = b - at_b * (b - a) / np.where(rise == 0.0, 1.0, rise)
        x = np.clip(np.where(rise == 0.0, a, secant), np.minimum(a, b), np.maximum(a, b))
        x = np.where(done, b, x)
        at_x = function(x)
        changed = at_x * at_b <= 0.0
        a, at_a = np.where(changed, b, a), np.where(changed, at_b, at_a / 2.0)
        done |= (np.abs(x - b) <= _ROUNDING * (1.0 + np.abs(x))) | (at_x == 0.0)
        b, at_b = x, at_x
        if np.all(done):
            break
    return b

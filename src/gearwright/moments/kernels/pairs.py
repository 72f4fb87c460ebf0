"""Sums and products of two numbers with their rounding errors, compiled: each pair's exact sum is the exact result.

Sources: Knuth, TAOCP 2, §4.2.2 (sums); Dekker, Numer. Math. 18 (1971) (products).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

from ...compiled import compiled
from .. import compensated

Pair = tuple[float, float]
"""A number as high and low part, |low| ≤ ulp(high)/2."""

_SPLITTER = 2.0**27 + 1.0

two_sum = cast("Callable[[Any, Any], Pair]", compiled(compensated.two_sum))


@compiled
def two_product(a: float, b: float) -> Pair:
    """a · b as rounded product and its rounding error."""
    wide_a, wide_b = _SPLITTER * a, _SPLITTER * b
    a_high, b_high = wide_a - (wide_a - a), wide_b - (wide_b - b)
    product = a * b
    rest = product - a_high * b_high - (a - a_high) * b_high - a_high * (b - b_high)
    return product, (a - a_high) * (b - b_high) - rest

"""Numbers as a sheet prints them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..parameters import Unit

_DECIMALS = {"mm": 3, "in": 4}
_LEAST_DIGITS = 5


def length(value: float, length_unit: str) -> str:
    """To a micrometre, or to 0.0001 in; of small lengths to five digits at least."""
    return decimal(value, _DECIMALS[length_unit])


def decimal(value: float, decimals: int) -> str:
    """To so many decimals, and to five digits at least, without zeros at the end."""
    if value and math.isfinite(value):
        decimals = max(decimals, _LEAST_DIGITS - 1 - math.floor(math.log10(abs(value))))
    text = f"{value:.{min(decimals, 15)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text in ("-0", "") else text.replace("-", "−")


def of_unit(value: float, unit: Unit, length_unit: str) -> str:
    """With the unit's sign: "52 mm", "20°"."""
    if unit == "angle":
        return f"{decimal(value, 4)}°"
    if unit == "length":
        return f"{length(value, length_unit)} {length_unit}"
    if unit == "area":
        return f"{decimal(value, _DECIMALS[length_unit])} {length_unit}²"
    return decimal(value, 4)

"""Units of parameters and of derived sizes, and values as a person reads them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real
from typing import Literal

Unit = Literal["length", "area", "angle", "mm", "per inch", ""]

MILLIMETRES = {"mm": 1.0, "in": 25.4}
"""Length units a person may choose, in millimetres."""

LEAST, MOST = 1e-12, 1e12
"""Limits of lengths, whose fifth powers must stay numbers."""

_LONGEST = 70  # characters of a value in a message


@dataclass(frozen=True)
class Size:
    """A derived size: its value (degrees where an angle), unit and the field's symbol."""

    value: float
    unit: Unit
    symbol: str
    meaning: str


def rounded_down(value: float) -> str:
    """A limit to four digits, never above it, so that what is followed is accepted."""
    if value <= 0.0 or not math.isfinite(value):
        return f"{value:.4g}"
    step = 10.0 ** (math.floor(math.log10(value)) - 3)
    return f"{math.floor(value / step) * step:.4g}"


def in_words(value: object, unit: Unit, length_unit: str) -> str:
    """A value as a person reads it, with its unit: "90 mm", "(16, 2)", "35°", "{circle = 3}"; long ones cut short."""
    if isinstance(value, Mapping):
        text = "{" + ", ".join(f"{name} = {in_words(one, unit, length_unit)}" for name, one in value.items()) + "}"
    elif isinstance(value, tuple | list):
        text = "(" + ", ".join(in_words(one, unit, length_unit) for one in value) + ")"
    else:
        suffix = {"length": f" {length_unit}", "angle": "°", "mm": " mm", "per inch": " /in"}.get(unit, "")
        text = f"{value:.6g}" if isinstance(value, float) and unit else str(value)
        return text + suffix if isinstance(value, Real) else repr(value)
    return text if len(text) <= _LONGEST else text[: _LONGEST - 2] + " …"

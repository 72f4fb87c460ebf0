"""Units of parameters and of derived sizes, and values as a person reads them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real
from typing import Literal

Unit = Literal["length", "area", "angle", "microradian", "mm", "per inch", ""]

LENGTH_UNITS = {"um": 1e-3, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Length units of files and of what is measured, in millimetres."""

MILLIMETRES = {unit: LENGTH_UNITS[unit] for unit in ("mm", "in")}
"""Length units that elements are given in, in millimetres."""

LEAST, MOST = 1e-12, 1e12
"""Limits of lengths, whose fifth powers must stay numbers."""

_LONGEST = 50  # characters of a list or table in a message


@dataclass(frozen=True)
class Size:
    """A derived size: its value (degrees where an angle), unit and the field's symbol."""

    value: float
    unit: Unit
    symbol: str
    meaning: str


def rounded_down(value: float, digits: int = 4) -> str:
    """A limit to so many digits, never above it, so that what is followed is accepted."""
    if value <= 0.0 or not math.isfinite(value):
        return f"{value:.{digits}g}"
    step = 10.0 ** (math.floor(math.log10(value)) + 1 - digits)
    return f"{math.floor(value / step) * step:.{digits}g}"


def rounded_up(value: float, digits: int = 4) -> str:
    """A least value to so many digits, never below it, so that what is followed is accepted."""
    if value <= 0.0 or not math.isfinite(value):
        return f"{value:.{digits}g}"
    step = 10.0 ** (math.floor(math.log10(value)) + 1 - digits)
    return f"{math.ceil(value / step) * step:.{digits}g}"


def in_words(value: object, unit: Unit, length_unit: str) -> str:
    """A value as a person reads it, with its unit: "90 mm", "(16, 2)", "35°", "{circle = 3}"."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name} = {in_words(one, '', '')}" for name, one in value.items()) + "}"
    if isinstance(value, tuple | list):
        return "(" + ", ".join(in_words(one, unit, length_unit) for one in value) + ")"
    is_number = isinstance(value, Real) and not isinstance(value, bool)
    if not is_number:
        return repr(value)
    suffix = {"length": f" {length_unit}", "angle": "°", "mm": " mm", "per inch": " /in"}.get(unit, "").rstrip()
    return (f"{value:.6g}" if isinstance(value, float) and unit else str(value)) + suffix


_WORDS: Mapping[Unit, str] = {"angle": "°", "microradian": "µrad", "mm": "mm", "per inch": "1/in", "": ""}


def unit_text(unit: Unit, length_unit: str) -> str:
    """The unit of a derived size as it stands beside a number: "mm²"."""
    lengths = {"length": length_unit, "area": f"{length_unit}²"}
    return lengths.get(unit) or _WORDS[unit]


def named(name: str, value: object, unit: Unit, length_unit: str) -> str:
    """A name with its value in words: "face_width = 90 mm"; without it where that is nothing, or a long list."""
    words = in_words(value, unit, length_unit)
    unspeakable = isinstance(value, Mapping | tuple | list) and len(words) > _LONGEST
    return name if value is None or unspeakable else f"{name} = {words}"

"""Lengths of SVG, and the unit that a page's width states."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z%]*)\s*")

_INCHES = {"in": 1.0, "cm": 1.0 / 2.54, "mm": 1.0 / 25.4, "pt": 1.0 / 72.0, "pc": 1.0 / 6.0}
"""Units of the real world (CSS Values and Units, §5.2)."""

_USER_UNITS_AN_INCH = 96.0


class Unusable(ValueError):
    """Something of an SVG file that cannot be read as an outline; says why and the way out."""


def length(element: Element, name: str, default: float = 0.0) -> float:
    """An attribute in user units, of which 96 are an inch. Raises Unusable where it is no length."""
    text = element.get(name)
    if text is None or text.strip() in ("", "auto"):
        return default
    number, unit = _parsed(element, name, text)
    if unit in ("", "px"):
        return number
    if unit not in _INCHES:
        raise Unusable(
            f"<{element.tag}> has {name}={text[:40]!r}; lengths without unit, in px, mm, cm, in, pt are read"
        )
    return number * _INCHES[unit] * _USER_UNITS_AN_INCH


def user_units(page: Element) -> tuple[tuple[float, float], str | None]:
    """Size (x, y) of a user unit in the unit of the page's width, and that unit; ((1, 1), None) without one.

    The view box is fitted to the page by the smaller of both scales, unless preserveAspectRatio is none.
    """
    width = _real(page, "width")
    if width is None:
        return (1.0, 1.0), None
    number, unit = width
    box = page.get("viewBox")
    if box is None:
        size = 1.0 / (_USER_UNITS_AN_INCH * _INCHES[unit])
        return (size, size), unit
    sides = _box(box)
    x = number / sides[0]
    height = _real(page, "height")
    if height is None:
        return (x, x), unit
    y = height[0] * _INCHES[height[1]] / _INCHES[unit] / sides[1]
    if page.get("preserveAspectRatio", "").strip().startswith("none"):
        return (x, y), unit
    return (min(x, y), min(x, y)), unit


def _box(text: str) -> tuple[float, float]:
    """Width and height of a view box."""
    try:
        numbers = [float(part) for part in re.split(r"[\s,]+", text.strip())]
    except ValueError:
        numbers = []
    if len(numbers) != 4 or not np.all(np.isfinite(numbers)) or min(numbers[2:]) <= 0.0:
        raise Unusable(f"viewBox={text[:60]!r} is not x, y, width and height of a page; mend or remove it")
    return numbers[2], numbers[3]


def _real(page: Element, name: str) -> tuple[float, str] | None:
    """A side of the page with its unit of the real world, if it has one."""
    text = page.get(name, "").strip()
    if not text or text == "auto":
        return None
    number, unit = _parsed(page, name, text)
    if unit in _INCHES and number <= 0.0:
        raise Unusable(f"the page has {name}={text[:40]!r}; it must be above 0")
    return (number, unit) if unit in _INCHES else None


def _parsed(element: Element, name: str, text: str) -> tuple[float, str]:
    match = _LENGTH.fullmatch(text)
    if not match or not np.isfinite(float(match[1])):
        raise Unusable(f"<{element.tag}> has {name}={text[:40]!r}, which is no length")
    return float(match[1]), match[2]

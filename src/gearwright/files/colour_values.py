"""Colours as files hold them."""

from __future__ import annotations

from ..colours import Colour

WHITE: Colour = (1.0, 1.0, 1.0)


def bytes_of(colour: Colour) -> tuple[int, int, int]:
    """sRGB values 0…255."""
    red, green, blue = (round(255.0 * min(max(value, 0.0), 1.0)) for value in colour)
    return red, green, blue


def linear(colour: Colour) -> tuple[float, float, float]:
    """Linear values 0…1 of the same primaries. Source: IEC 61966-2-1, the sRGB transfer function."""
    red, green, blue = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in colour)
    return red, green, blue

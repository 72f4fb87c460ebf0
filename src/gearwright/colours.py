"""Colours of parts, in pictures and in files: sRGB values 0…1."""

from __future__ import annotations

Colour = tuple[float, float, float]

BRASS: Colour = (0.80, 0.64, 0.36)
STEEL: Colour = (0.60, 0.66, 0.73)

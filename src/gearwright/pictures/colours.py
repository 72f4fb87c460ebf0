"""Colours as light and as numbers in a file."""

from __future__ import annotations

import numpy as np

from ..arrays import Array


def linear(colours: Array) -> Array:
    """Light intensities of sRGB values 0…1 (IEC 61966-2-1)."""
    return np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)


def gamma(intensities: Array) -> Array:
    """sRGB values 0…1 of light intensities: the inverse of linear."""
    clipped = np.clip(intensities, 0.0, 1.0)
    return np.where(clipped <= 0.0031308, clipped * 12.92, 1.055 * clipped ** (1 / 2.4) - 0.055)


def toned(intensities: Array) -> Array:
    """Intensities with highlights above 0.7 rolled off smoothly, so that nothing burns out to flat white."""
    over = np.maximum(intensities - 0.7, 0.0)
    return np.asarray(np.minimum(intensities, 0.7) + 0.3 * (1.0 - np.exp(-over / 0.3)))

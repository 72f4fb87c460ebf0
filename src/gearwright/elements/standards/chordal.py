"""Chordal thickness and the height above it, for a gear-tooth calliper set on the pitch circle."""

from __future__ import annotations

import numpy as np

from ..cylindrical.toothing import Toothing


def chordal(toothing: Toothing) -> tuple[float, float]:
    """Thickness s̄_n = d_n sin(s_n/d_n) and height h̄_a = h_a ± d_n/2 (1 − cos(s_n/d_n)) in the normal section.

    d_n = d/cos²β is the diameter of curvature of the pitch cylinder there, s_n = s_t cos β; − in internal gears.
    Source: ISO 21771, chordal tooth thickness.
    """
    diameter = 2.0 * toothing.pitch_radius / np.cos(toothing.helix_angle) ** 2
    angle = toothing.thickness * np.cos(toothing.helix_angle) / diameter
    rise = diameter / 2.0 * (1.0 - np.cos(angle))
    return float(diameter * np.sin(angle)), float(toothing.addendum + toothing.outward * rise)

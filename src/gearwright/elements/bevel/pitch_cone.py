"""Pitch cones of bevel gears: their angle, and which of them make a gear."""

from __future__ import annotations

import numpy as np

from ...parameters import Problems
from .. import refusals

_NEARLY_CYLINDRICAL = np.radians(0.01 * (1.0 - 1e-9))  # as the limit of pitch_angle


def require_cone(problems: Problems, *angles: float) -> None:
    """Adds a problem of the shaft angle where it makes a pitch cone (radians) too steep or too flat."""
    if max(angles) > np.pi / 2.0 + 1e-12:
        problems.add("shaft_angle", refusals.internal_bevel(max(angles)))
    elif min(angles) < _NEARLY_CYLINDRICAL:
        problems.add("shaft_angle", refusals.nearly_cylindrical(min(angles)))


def pitch_cone_angle(teeth: int, mate_teeth: int, shaft_angle: float) -> float:
    """δ = atan2(sin Σ, z₂/z₁ + cos Σ), radians, of the member with z₁ teeth. Source: ISO 23509, 6.2."""
    return float(np.arctan2(np.sin(shaft_angle), mate_teeth / teeth + np.cos(shaft_angle)))

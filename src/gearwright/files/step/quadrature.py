"""Properties of smooth solids by Open CASCADE's quadrature over their faces, cross-checked."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...arrays import Array
from ..contents import SmoothProperties

_ACCURACY = 1e-9
"""Relative, asked of the adaptive Gauss–Kronrod rule on every face."""

_AGREES = 2e-7
"""Relative difference of two volumes below which the plain Gauss rule has resolved every face, for moments as well.

It is exact where faces are elementary, and by far faster for moments: the adaptive rule spends minutes on moments that
vanish by symmetry. On faces bounded by splines it is silently wrong by 1e-3 and more, and so is the adaptive Gauss
rule, by tenths; both are never used there.
"""


def smooth_properties(solid: Any) -> SmoothProperties | None:
    """Volume, centroid and second moment of a solid's smooth shape; None where the quadrature fails."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    adaptive, plain = GProp_GProps(), GProp_GProps()
    failed = BRepGProp.VolumePropertiesGK_s(solid, adaptive, _ACCURACY, False, True, False, False) < 0.0
    volume = adaptive.Mass()
    if failed or not np.isfinite(volume) or volume == 0.0:
        return None
    BRepGProp.VolumeProperties_s(solid, plain)
    chosen = plain
    if not abs(plain.Mass() - volume) <= _AGREES * abs(volume):
        chosen = GProp_GProps()
        BRepGProp.VolumePropertiesGK_s(solid, chosen, _ACCURACY, False, True, True, True)
    centre, inertia = chosen.CentreOfMass(), _matrix(chosen.MatrixOfInertia())
    return SmoothProperties(
        volume=volume,
        centroid=np.array([centre.X(), centre.Y(), centre.Z()]),
        second_moment=0.5 * np.trace(inertia) * np.eye(3) - inertia,
    )


def _matrix(given: Any) -> Array:
    return np.array([[given.Value(row, column) for column in (1, 2, 3)] for row in (1, 2, 3)])

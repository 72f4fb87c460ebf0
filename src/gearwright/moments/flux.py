"""Moments of a body as the flux of a vector field through its boundary.

∫ f dV = ∮ f (r·n) dA / (degree + 3) for every homogeneous f, so that

    M = ∮ (r·n) [1/3 rᵀ/4; r/4 r rᵀ/5] dA

is an independent route to the moments of anything that has a boundary. Source: Al-Daccak 1989, ch. 4.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array

_DEGREE = np.add.outer([0, 1, 1, 1], [0, 1, 1, 1])
BY_ORDER: Array = 1.0 / (3.0 + _DEGREE)
"""1/(degree + 3) of each entry of the moment matrix."""


def flux_moments(points: Array, area_vectors: Array) -> Array:
    """Σ (r·n dA) [1/3 rᵀ/4; r/4 r rᵀ/5] (4, 4) over points (n, 3) with area vectors n dA (n, 3)."""
    weight = np.sum(points * area_vectors, axis=-1)
    homogeneous = np.concatenate([np.ones((len(points), 1)), points], axis=1)
    return BY_ORDER * ((homogeneous * weight[:, None]).T @ homogeneous)

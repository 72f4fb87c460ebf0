"""Moments of a region of the unit sphere from its boundary: solid angle, ∫ n dΩ and ∫ n nᵀ dΩ.

For a region S with its boundary counter-clockwise seen from outside, n on the boundary and −z outside S:

    Ω = ∮ z·(n×dn)/(1 + z·n),   N = ∫ n dΩ = ½ ∮ n×dn,   Q = ∫ n nᵀ dΩ = ⅓ (Ω 1 + sym ∮ (n×dn) nᵀ)     (M3)

spectrally accurate on smooth arcs. Source: the divergence theorem on the sphere; beyond Al-Daccak 1989.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from .matrix import moment_matrix, patterned


def region_moments(points: Array, tangents: Array, order: int = 1) -> Array:
    """The matrix [Ω Nᵀ; N Q] (4, 4) of a region of the unit sphere, eq. (M3).

    points, tangents   (n, 3)  nodes of the boundary and weighted tangents, region on the left
    order              the whole boundary is this many turns about z of the part given

    Each of the three boundary integrals is additive and turns with its part, so that a part of the
    boundary may be taken for all of it; −z must lie outside the region.
    """
    cross = np.cross(points, tangents)
    solid_angle = np.sum(cross[:, 2] / (1.0 + points[:, 2]))
    first = cross.sum(axis=0) / 2.0
    product = cross.T @ points
    second = (solid_angle * np.eye(3) + (product + product.T) / 2.0) / 3.0
    return patterned(moment_matrix(solid_angle, first, second), order)

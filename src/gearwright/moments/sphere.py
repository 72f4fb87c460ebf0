"""Moments of a region of the unit sphere from its boundary: solid angle, ∫ n dΩ and ∫ n nᵀ dΩ.

For a region S with its boundary counter-clockwise seen from outside, n on the boundary and −z outside S:

    Ω = ∮ z·(n×dn)/(1 + z·n),   N = ∫ n dΩ = ½ ∮ n×dn,   Q = ∫ n nᵀ dΩ = ⅓ (Ω 1 + sym ∮ (n×dn) nᵀ)     (M3)

spectrally accurate on smooth arcs. Source: the divergence theorem on the sphere; beyond Al-Daccak 1989.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array
from .matrix import moment_matrix, patterned
from .quadrature import gauss_legendre


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


_NODES = 32  # from one polar angle to another; the integrands have their poles a right angle from the levels' own


def level_region_moments(parts: Sequence[tuple[Array, Array, int]], levels: float | None) -> Array:
    """Moments (..., 4, 4) about the apex of the body between it and the part of a level at v = 1 that a region covers.

    parts    of the region's boundary: nodes (..., n, 3) on the unit sphere, weighted tangents, region on the left, and
             how many turns about z of the part make up the whole
    levels   λ of r cos(θ − λ) = v, radians; None for the sphere r = v

    With w = r³/3, r⁴/4 or r⁵/5 at polar angle θ, ∫ w(θ) g(φ) dΩ = ∮ W(θ) g(φ) dφ, W(θ) = ∫ w sin θ dθ from the pole
    where the region lies around it, else from anywhere. −z must lie outside the region.
    """
    steps = [(p[..., 0] * t[..., 1] - p[..., 1] * t[..., 0]) / (p[..., 0] ** 2 + p[..., 1] ** 2) for p, t, _ in parts]
    turns = sum(np.sum(step, axis=-1) * order for step, (_, _, order) in zip(steps, parts, strict=True))
    around = np.abs(turns) > np.pi
    found = np.zeros(())
    for step, (points, _, order) in zip(steps, parts, strict=True):
        rho = np.hypot(points[..., 0], points[..., 1])
        theta = np.arctan2(rho, points[..., 2])
        first = np.where(around, 0.0, levels or 0.0)[..., None]
        one, across, along, square, mixed, axial = _polar_primitives(first, theta, levels)
        x, y = points[..., 0] / rho, points[..., 1] / rho
        entries = [
            [one, across * x, across * y, along],
            [across * x, square * x * x, square * x * y, mixed * x],
            [across * y, square * x * y, square * y * y, mixed * y],
            [along, mixed * x, mixed * y, axial],
        ]
        rows = [np.stack([np.sum(entry * step, axis=-1) for entry in row], axis=-1) for row in entries]
        found = found + patterned(np.stack(rows, axis=-2), order)
    return found


def _polar_primitives(first: Array, theta: Array, levels: float | None) -> Array:
    """∫ of sin t r³/3; of sin² t and sin t cos t, r⁴/4; of sin³ t, sin² t cos t and sin t cos² t, r⁵/5 (6, ...)."""
    x, w = gauss_legendre(_NODES)
    half = (theta - first) / 2.0
    t = (theta + first)[..., None] / 2.0 + half[..., None] * x
    r = np.ones_like(t) if levels is None else 1.0 / np.cos(t - levels)
    s, c = np.sin(t), np.cos(t)
    cube = r * r * r
    fourth = cube * r
    third, quarter, fifth = s * cube / 3.0, s * fourth / 4.0, s * (fourth * r) / 5.0
    values = (third, s * quarter, c * quarter, s * s * fifth, s * c * fifth, c * c * fifth)
    return np.stack([(value @ w) * half for value in values])

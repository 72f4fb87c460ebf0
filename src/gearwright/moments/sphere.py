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


_NODES = 32  # from the pole to a polar angle, of sines and cosines


def level_region_moments(parts: Sequence[tuple[Array, Array, int]], levels: float | None) -> Array:
    """Moments (..., 4, 4) about the apex of the body between it and the part of a level at v = 1 that a region covers.

    parts    of the region's boundary: nodes (..., n, 3) on the unit sphere, weighted tangents, region on the left, and
             how many turns about z of the part make up the whole
    levels   λ of r cos(θ − λ) = v, radians; None for the sphere r = v

    With w = r³/3, r⁴/4 or r⁵/5 at polar angle θ, ∫ w(θ) g(φ) dΩ = ∮ W(θ) g(φ) dφ, W(θ) = ∫ w sin θ dθ from the pole
    where the region lies around it, else from anywhere. −z must lie outside the region, and cos(θ − λ) be positive.
    """
    steps = [(p[..., 0] * t[..., 1] - p[..., 1] * t[..., 0]) / (p[..., 0] ** 2 + p[..., 1] ** 2) for p, t, _ in parts]
    turns = sum(np.sum(step, axis=-1) * order for step, (_, _, order) in zip(steps, parts, strict=True))
    around = np.abs(turns) > np.pi
    found = np.zeros(())
    for step, (points, _, order) in zip(steps, parts, strict=True):
        rho = np.hypot(points[..., 0], points[..., 1])
        one, across, along, square, mixed, axial = _primitives(around[..., None], rho, points[..., 2], levels)
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


def _primitives(around: Array, rho: Array, height: Array, levels: float | None) -> Array:
    """∫ of ρ/3; of ρ²/4 and ρ z/4; of ρ³/5, ρ² z/5 and ρ z²/5 (6, ...) along the level's meridian up to a point.

    rho, height   (...)  of the point's direction on the unit sphere

    On a sphere by the polar angle; a cone's meridian is a straight line, ρ = sin λ + u cos λ and z = cos λ − u sin λ,
    along which r³ sin θ dθ = ρ du, and so on: polynomials in u = tan(θ − λ), whatever the angle.
    """
    if levels is None:
        x, w = gauss_legendre(_NODES)
        half = np.arctan2(rho, height) / 2.0
        angle = half[..., None] * (1.0 + x)
        out, up = np.sin(angle), np.cos(angle)
    else:
        c, s = np.cos(levels), np.sin(levels)
        first, last = np.where(around, -s / c, 0.0), (rho * c - height * s) / (height * c + rho * s)
        x, w = gauss_legendre(2)
        half = (last - first) / 2.0
        u = (last + first)[..., None] / 2.0 + half[..., None] * x
        out, up = s + u * c, c - u * s
    values = (out / 3.0, out**2 / 4.0, out * up / 4.0, out**3 / 5.0, out**2 * up / 5.0, out * up**2 / 5.0)
    return np.stack([(value @ w) * half for value in values])

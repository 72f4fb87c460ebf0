"""The exact spherical involute, the flank of a bevel gear on the unit sphere.

A great circle rolls without slip on a base cone of half-angle γ_b about +z; a point of it, starting on
the cone at azimuth 0, traces the curve. β is the roll angle about the cone, α = β sin γ_b the angle
unwound along the great circle, δ the polar angle and ψ the azimuth of the point. The curve runs from
its cusp on the base cone (β = 0) through the equator to the opposite cone δ = π − γ_b (α = π).
Source: Al-Daccak 1989, eqs. (3.1)–(3.14), there by the pole angle φ = β − ψ; here by roll, in which the
curve is analytic.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.quadrature import gauss_legendre
from .curve import Curve

_NEAR_CUSP = 1.0  # roll below which the azimuth is a quadrature: its closed form is a difference of O(β) in O(β³)
_CUSP_NODES = 16  # the integrand's poles are then ≥ 1 interval away: the error is below 1e-20
_MOST_STEPS = 60  # bisection alone would need 53


@dataclass(frozen=True, kw_only=True)
class SphericalInvolute(Curve):
    """The spherical involute of a base cone; u is the roll angle β about the cone, 0 at the cusp, radians.

    base_cone_angle   half-angle γ_b of the cone about +z, radians, 0 < γ_b < π/2

    Raises ValueError if the cone is not a cone.
    Source: Al-Daccak 1989, eqs. (3.7)–(3.14).
    """

    base_cone_angle: float

    def __post_init__(self) -> None:
        _require_cone(self.base_cone_angle)

    def point(self, u: ArrayLike) -> Array:
        beta = np.asarray(u, float)
        s, c = np.sin(self.base_cone_angle), np.cos(self.base_cone_angle)
        alpha = beta * s
        x = s * np.cos(alpha) * np.cos(beta) + np.sin(alpha) * np.sin(beta)
        y = s * np.cos(alpha) * np.sin(beta) - np.sin(alpha) * np.cos(beta)
        return np.stack([x, y, c * np.cos(alpha)], axis=-1)

    def derivative(self, u: ArrayLike) -> Array:
        beta = np.asarray(u, float)
        s, c = np.sin(self.base_cone_angle), np.cos(self.base_cone_angle)
        speed = c * np.sin(beta * s)
        return np.stack([speed * c * np.cos(beta), speed * c * np.sin(beta), -speed * s], axis=-1)


def polar_angle(roll: ArrayLike, base_cone_angle: float) -> Array:
    """Polar angle δ (...) at roll β (...): cos δ = cos γ_b cos α, radians."""
    _require_cone(base_cone_angle)
    s, c = np.sin(base_cone_angle), np.cos(base_cone_angle)
    alpha = np.asarray(roll, float) * s
    return np.arctan2(np.hypot(s * np.cos(alpha), np.sin(alpha)), c * np.cos(alpha))


def azimuth(roll: ArrayLike, base_cone_angle: float) -> Array:
    """Azimuth ψ (...) at roll β (...) from 0 to π/sin γ_b, radians, to relative machine precision.

    ψ = β − atan2(sin α, sin γ_b cos α), rearranged so that nothing cancels: near the cusp as the
    integral of dψ/dα = cos²γ_b sin²α / (sin γ_b (sin²γ_b + cos²γ_b sin²α)), elsewhere with β − α and
    φ − α, both of the order of cos²γ_b, in place of β and φ.
    Source: Al-Daccak 1989, eq. (3.9).
    """
    _require_cone(base_cone_angle)
    s, c = np.sin(base_cone_angle), np.cos(base_cone_angle)
    beta = np.asarray(roll, float)
    alpha = beta * s
    k = c * c / (1.0 + s)  # 1 − s without cancellation
    sin, cos = np.sin(alpha), np.cos(alpha)
    far = k * alpha / s - np.arctan2(k * sin * cos, s * cos * cos + sin * sin)
    x, w = gauss_legendre(_CUSP_NODES)
    squares = np.sin(np.where(beta < _NEAR_CUSP, alpha, 0.0)[..., None] * (x + 1.0) / 2.0) ** 2
    near = alpha / 2.0 * ((c * c * squares / (s * (s * s + c * c * squares))) @ w)
    return np.where(beta < _NEAR_CUSP, near, far)


def spherical_involute_function(pole_angle: ArrayLike, base_cone_angle: float) -> Array:
    """ψ = spinv(φ) (...): azimuth of the point whose angle at the pole is φ (...) in [0, π], radians.

    spinv(φ) = atan2(sin γ_b sin φ, cos φ)/sin γ_b − φ; the planar involute function is its limit γ_b → 0.
    Source: Al-Daccak 1989, eqs. (3.7), (3.9).
    """
    _require_cone(base_cone_angle)
    phi = np.asarray(pole_angle, float)
    if not np.all((phi >= 0.0) & (phi <= np.pi)):
        raise ValueError("the angle at the pole goes from 0 at the cusp to 180° at the end of the involute")
    s = np.sin(base_cone_angle)
    return azimuth(np.arctan2(s * np.sin(phi), np.cos(phi)) / s, base_cone_angle)


def roll_at_polar_angle(polar_angle: ArrayLike, base_cone_angle: float) -> Array:
    """Roll β (...) at which the curve reaches polar angle δ (...), γ_b ≤ δ ≤ π − γ_b, radians.

    From cos α = cos δ/cos γ_b by half angles, which keep every digit at both ends.
    Raises ValueError where the curve does not reach.
    """
    _require_cone(base_cone_angle)
    gamma, delta = base_cone_angle, np.asarray(polar_angle, float)
    slack = 4.0 * np.finfo(float).eps  # an end's own polar angle may round beyond it
    if not np.all((delta >= gamma - slack) & (delta <= np.pi - gamma + slack)):
        raise ValueError(
            f"the involute of a {np.degrees(gamma):.6g}° base cone lies between that angle and its supplement"
        )
    half_sum, half_difference = (delta + gamma) / 2.0, np.maximum(delta - gamma, 0.0) / 2.0
    sin_squared = np.sin(half_sum) * np.sin(half_difference)  # both times cos γ_b
    cos_squared = np.cos(half_sum) * np.cos(half_difference)
    return 2.0 * np.arctan2(np.sqrt(sin_squared), np.sqrt(np.maximum(cos_squared, 0.0))) / np.sin(gamma)


def roll_at_azimuth(azimuth_angle: ArrayLike, base_cone_angle: float) -> Array:
    """Roll β (...) at which the curve reaches azimuth ψ (...), 0 ≤ ψ ≤ π/sin γ_b − π, radians.

    Newton's method on ψ^{1/3}, nearly linear in β at the cusp, kept in a bracket; the upper half of the
    curve by its symmetry about the equator. Raises ValueError where the curve does not reach.
    Source: inverts Al-Daccak 1989, eq. (3.9); eq. (3.13) there has a derivative that vanishes at the cusp.
    """
    _require_cone(base_cone_angle)
    s, c = np.sin(base_cone_angle), np.cos(base_cone_angle)
    psi = np.asarray(azimuth_angle, float)
    whole = np.pi * c * c / (1.0 + s) / s
    if not np.all((psi >= 0.0) & (psi <= whole * (1.0 + 1e-15))):
        raise ValueError(f"the involute of this base cone spans azimuths from 0 to {np.degrees(whole):.6g}°")
    upper = psi > whole / 2.0
    target = np.cbrt(np.where(upper, np.maximum(whole - psi, 0.0), psi))
    low, high = np.zeros_like(target), np.full_like(target, np.pi / (2.0 * s))
    beta = np.minimum(np.cbrt(3.0 / (c * c)) * target, high)
    for _ in range(_MOST_STEPS):
        root = np.cbrt(azimuth(beta, base_cone_angle))
        low, high = np.where(root <= target, beta, low), np.where(root >= target, beta, high)
        squares = np.sin(beta * s) ** 2
        slope = c * c * squares / (s * s + c * c * squares)  # dψ/dβ
        newton = beta - 3.0 * root * root * (root - target) / np.where(slope > 0.0, slope, 1.0)
        following = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2.0)
        following = np.where(target == 0.0, 0.0, following)
        if np.all(np.abs(following - beta) <= 2.0 * np.finfo(float).eps * beta):
            break
        beta = following
    return np.where(upper, np.pi / s - following, following)


def _require_cone(angle: float) -> None:
    if not 0.0 < angle < np.pi / 2.0:
        raise ValueError(f"a base cone has a half-angle between 0 and 90°, not {np.degrees(angle):.6g}°")

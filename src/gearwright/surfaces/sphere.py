"""Spheres about the origin, the end faces of a bevel gear bounded by constant cone distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..moments.flux import BY_ORDER
from ..moments.matrix import moment_matrix
from ..moments.quadrature import gauss_legendre
from .surface import AXES, Surface

_LOWEST = -1.0 + 1e-9  # of a unit vector's z: below it lies −z but for rounding


@dataclass(frozen=True, kw_only=True)
class Sphere(Surface):
    """The sphere of a radius about the origin, normal outward, charted stereographically from −z.

    The chart is (x, y)/(r + z): conformal, the pole +z in the middle, −z at infinity.
    """

    radius: float

    def chart(self, points: Array) -> Array:
        return points[..., :2] / (self.radius + points[..., 2:])

    def point(self, chart: Array) -> Array:
        square = np.sum(chart * chart, axis=-1, keepdims=True)
        return self.radius * np.concatenate([2.0 * chart, 1.0 - square], axis=-1) / (1.0 + square)

    def deviation(self, points: Array) -> Array:
        return np.abs(np.linalg.norm(points, axis=-1) - self.radius)

    def spacing(self, tolerance: float, chart: Array) -> Array:
        step = np.sqrt(4.0 * self.radius * tolerance)  # the sagitta of a circle of half a square's diagonal
        return step * (1.0 + np.sum(chart * chart, axis=-1)) / (2.0 * self.radius)

    def area(self, points: Array, tangents: Array) -> float:
        return float(self.radius**2 * _polar_integrals(points / self.radius, tangents / self.radius)[0, 0])

    def extremes(self, directions: Array = AXES) -> Array:
        """On every axis but −z, which no face contains."""
        points = np.stack([directions, -directions], axis=1).reshape(-1, 3)
        return self.radius * points[points[:, 2] > _LOWEST]

    def flux(self, points: Array, tangents: Array) -> Array:
        region = _polar_integrals(points / self.radius, tangents / self.radius)
        scale = np.diag([1.0, self.radius, self.radius, self.radius])
        return self.radius**3 * BY_ORDER * (scale @ region @ scale)


def _polar_integrals(n: Array, dn: Array) -> Array:
    """[Ω Nᵀ; N Q] of a region of the unit sphere by integrals over azimuth.

    ∫ w(θ) g(φ) dΩ = ∮ W(cos θ) g(φ) dφ with W(u) = ∫_u¹ w du′, u = cos θ: another way than (M3), so that
    the flux stays an independent route. −z must lie outside the region.
    """
    x, y, u = n.T
    rho_squared = x * x + y * y
    rho = np.sqrt(rho_squared)
    azimuth_step = (x * dn[:, 1] - y * dn[:, 0]) / rho_squared
    c, s = x / rho, y / rho
    versine = np.where(u >= 0.0, rho_squared / (1.0 + np.abs(u)), 1.0 - u)  # 1 − u
    area = np.sum(versine * azimuth_step)
    transverse = _sine_squared_integral(np.arctan2(rho, u)) * azimuth_step
    square = versine**2 * (2.0 + u) / 3.0 * azimuth_step
    mixed = rho**3 / 3.0 * azimuth_step
    first = np.array([transverse @ c, transverse @ s, np.sum(rho_squared / 2.0 * azimuth_step)])
    second = np.array(
        [
            [square @ (c * c), square @ (c * s), mixed @ c],
            [square @ (c * s), square @ (s * s), mixed @ s],
            [mixed @ c, mixed @ s, np.sum(versine * (1.0 + u + u * u) / 3.0 * azimuth_step)],
        ]
    )
    return moment_matrix(area, first, second)


def _sine_squared_integral(theta: Array) -> Array:
    """∫₀^θ sin²t dt = (θ − sin θ cos θ)/2 (...), near the pole by quadrature, where the difference cancels."""
    x, w = gauss_legendre(12)
    near = np.where(theta < 0.5, theta, 0.0)
    quadrature = near / 2.0 * (np.sin(near[..., None] * (x + 1.0) / 2.0) ** 2 @ w)
    return np.where(theta < 0.5, quadrature, (theta - np.sin(theta) * np.cos(theta)) / 2.0)

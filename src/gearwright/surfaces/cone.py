"""Cones about z: the end faces of a bevel gear whose ends are perpendicular to its pitch cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..moments.flux import BY_ORDER
from ..moments.matrix import moment_matrix
from ..moments.quadrature import gauss_legendre
from .surface import AXES, Surface

_SAME = (
    1e-11  # radians, and of the distance: a line's direction is lost so far in the rounding of points near each other
)


@dataclass(frozen=True, kw_only=True)
class Cone(Surface):
    """The cone about z whose tangent planes are all at one distance from the origin, normal away from it.

    angle      γ of the pitch cone that it is perpendicular to, radians, 0 < γ ≤ π/2; at π/2 it is a cylinder
    distance   R from the origin, along the pitch cone: ρ sin γ + z cos γ = R

    With s along the generators from the pitch cone outward, ρ = R sin γ + s cos γ and z = R cos γ − s sin γ. The chart
    is e^q (cos φ, sin φ) with q = ∫ ds/ρ: conformal, as ds² + ρ² dφ² = ρ² (dq² + dφ²).
    """

    angle: float
    distance: float

    @property
    def _pitch_radius(self) -> float:
        return float(self.distance * np.sin(self.angle))

    def _along(self, points: Array) -> tuple[Array, Array]:
        """ρ and s (...) of points (..., 3)."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        rho = np.hypot(points[..., 0], points[..., 1])
        return rho, (rho - self._pitch_radius) * c - (points[..., 2] - self.distance * c) * s

    def coincides(self, other: Surface) -> bool:
        if not isinstance(other, Cone):
            return False
        near = abs(self.distance - other.distance) <= _SAME * self.distance
        return near and abs(self.angle - other.angle) <= _SAME

    def chart(self, points: Array) -> Array:
        c = np.cos(self.angle)
        rho, along = self._along(points)
        q = np.log1p(along * c / self._pitch_radius) / c
        return (np.exp(q) / rho)[..., None] * points[..., :2]

    def point(self, chart: Array) -> Array:
        c, s = np.cos(self.angle), np.sin(self.angle)
        size = np.hypot(chart[..., 0], chart[..., 1])
        with np.errstate(divide="ignore"):
            q = np.log(size)  # −∞ at the apex
        along = self._pitch_radius * np.expm1(q * c) / c
        rho = self._pitch_radius * np.exp(q * c)
        around = chart / np.where(size > 0.0, size, 1.0)[..., None]
        return np.concatenate([rho[..., None] * around, (self.distance * c - along * s)[..., None]], axis=-1)

    def deviation(self, points: Array) -> Array:
        rho = np.hypot(points[..., 0], points[..., 1])
        return np.abs(rho * np.sin(self.angle) + points[..., 2] * np.cos(self.angle) - self.distance)

    def spacing(self, tolerance: float, chart: Array) -> Array:
        """From the sagitta of half a square's diagonal across the generators, where the curvature is sin γ/ρ."""
        size = np.hypot(chart[..., 0], chart[..., 1])
        rho = self._pitch_radius * size ** np.cos(self.angle)
        return size * np.sqrt(4.0 * tolerance / (np.sin(self.angle) * rho))

    def area(self, points: Array, tangents: Array) -> float:
        return float(self._integrals(points, tangents)[0, 0])

    def extremes(self, directions: Array = AXES) -> Array:
        """Only where a normal has the direction: nowhere inside a face, since normals are the same along generators."""
        del directions
        return np.empty((0, 3))

    def flux(self, points: Array, tangents: Array) -> Array:
        return self.distance * BY_ORDER * self._integrals(points, tangents)

    def _integrals(self, points: Array, tangents: Array) -> Array:
        """∫ h hᵀ dA (4, 4), h = (1, x, y, z): the area element ρ ds dφ integrated along s, then around the loops.

        From the pitch cone on, s = 0; a face around the apex has what lies within that circle besides. The loops of a
        face belong together: around one that does not, the tip of a steep cone would drown it.
        """
        rho, along = self._along(points)
        step = (points[:, 0] * tangents[:, 1] - points[:, 1] * tangents[:, 0]) / rho**2  # dφ
        x, y = points[:, 0] / rho, points[:, 1] / rho
        one, radius, height, square, mixed, heights = self._primitives(along)
        around = round(float(np.sum(step)) / (2.0 * np.pi))
        first = np.array([(radius * step) @ x, (radius * step) @ y, height @ step])
        second = np.array(
            [
                [(square * step) @ (x * x), (square * step) @ (x * y), (mixed * step) @ x],
                [(square * step) @ (x * y), (square * step) @ (y * y), (mixed * step) @ y],
                [(mixed * step) @ x, (mixed * step) @ y, heights @ step],
            ]
        )
        found = moment_matrix(one @ step, first, second)
        if around == 0:
            return found
        one, _, height, square, _, heights = -self._primitives(np.array(-self.distance * np.tan(self.angle)))
        inner = np.pi * moment_matrix(2.0 * one, [0.0, 0.0, 2.0 * height], np.diag([square, square, 2.0 * heights]))
        return np.asarray(found + around * inner)

    def _primitives(self, along: Array) -> Array:
        """∫₀^s of ρ times 1, ρ, z, ρ², ρz, z² (6, ...): polynomials, exact by two nodes."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        x, w = gauss_legendre(2)
        t = along[..., None] * (x + 1.0) / 2.0
        rho, z = self._pitch_radius + t * c, self.distance * c - t * s
        values = np.stack([rho, rho * rho, rho * z, rho**3, rho * rho * z, rho * z * z])
        return np.asarray(values @ w * (along / 2.0))

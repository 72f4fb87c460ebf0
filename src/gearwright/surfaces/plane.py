"""Planes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..moments.boundary_integral import moment_matrix_2d, plane_moments
from ..moments.flux import BY_ORDER
from ..moments.matrix import affine
from .surface import AXES, Surface

_ORTHONORMAL = 1e-12


@dataclass(frozen=True, kw_only=True)
class Plane(Surface):
    """The plane through `origin` with orthonormal in-plane axes; its normal is x_axis × y_axis."""

    origin: tuple[float, float, float]
    x_axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
    y_axis: tuple[float, float, float] = (0.0, 1.0, 0.0)

    def __post_init__(self) -> None:
        if not np.allclose(self._axes @ self._axes.T, np.eye(2), rtol=0.0, atol=_ORTHONORMAL):
            raise ValueError("the axes of a plane must be orthonormal")

    @property
    def _axes(self) -> Array:
        return np.array([self.x_axis, self.y_axis])

    def chart(self, points: Array) -> Array:
        return (points - np.array(self.origin)) @ self._axes.T

    def point(self, chart: Array) -> Array:
        return np.array(self.origin) + chart @ self._axes

    def deviation(self, points: Array) -> Array:
        normal = np.cross(self.x_axis, self.y_axis)
        return np.abs((points - np.array(self.origin)) @ normal)

    def spacing(self, tolerance: float, chart: Array) -> Array:
        del tolerance
        return np.full(chart.shape[:-1], np.inf)

    def area(self, points: Array, tangents: Array) -> float:
        return float(plane_moments(self.chart(points), tangents @ self._axes.T)[0, 0])

    def extremes(self, directions: Array = AXES) -> Array:
        del directions
        return np.empty((0, 3))

    def flux(self, points: Array, tangents: Array) -> Array:
        region = moment_matrix_2d(plane_moments(self.chart(points), tangents @ self._axes.T))
        placed = affine(self._axes.T, self.origin)
        distance = float(np.dot(self.origin, np.cross(self.x_axis, self.y_axis)))
        return distance * BY_ORDER * (placed @ region @ placed.T)

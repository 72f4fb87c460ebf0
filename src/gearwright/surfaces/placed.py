"""Surfaces that were put elsewhere."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array
from ..moments.flux import flux_moments
from ..moments.matrix import transformed
from ..moments.quadrature import gauss_legendre
from ..placement import Placement
from .plane import Plane
from .surface import AXES, Surface


@dataclass(frozen=True, kw_only=True)
class PlacedSurface(Surface):
    """A surface under a rigid placement; its chart is the surface's own."""

    surface: Surface
    placement: Placement

    def chart(self, points: Array) -> Array:
        return self.surface.chart(self.placement.points_back(points))

    def point(self, chart: Array) -> Array:
        return self.placement.points(self.surface.point(chart))

    def deviation(self, points: Array) -> Array:
        return self.surface.deviation(self.placement.points_back(points))

    def spacing(self, tolerance: float, chart: Array) -> Array:
        return self.surface.spacing(tolerance, chart)

    def area(self, points: Array, tangents: Array) -> float:
        return self.surface.area(self.placement.points_back(points), self.placement.vectors_back(tangents))

    def extremes(self, directions: Array = AXES) -> Array:
        return self.placement.points(self.surface.extremes(self.placement.vectors_back(directions)))

    def flux(self, points: Array, tangents: Array) -> Array:
        """From the cone between the face and the surface's own origin o.

        There its sides have no flux, so that the face's own flux is the moment matrix of the cone, which moves by
        (M1). About the frame's origin the sides r = o + s (p − o) have some, cubic in s, and it is taken off.
        """
        cone = self.surface.flux(self.placement.points_back(points), self.placement.vectors_back(tangents))
        moved = transformed(cone, self.placement.matrix, self.placement.shift)
        origin = self.placement.shift
        arms = points - origin
        x, w = gauss_legendre(2)
        s = ((x + 1.0) / 2.0)[:, None, None]
        sides = s * np.cross(tangents, arms) * (w / 2.0)[:, None, None]  # outward: the face is seen from outside
        return moved - flux_moments((origin + s * arms).reshape(-1, 3), sides.reshape(-1, 3))


def placed_surface(surface: Surface, placement: Placement) -> Surface:
    """The surface put elsewhere, in the simplest form: planes stay planes."""
    if isinstance(surface, Plane):
        first, second = (placement.vectors(np.array(axis)) for axis in (surface.x_axis, surface.y_axis))
        x, y, z = (float(v) for v in placement.points(np.array(surface.origin)))
        return Plane(origin=(x, y, z), x_axis=_triple(first), y_axis=_triple(second))
    if isinstance(surface, PlacedSurface):
        return replace(surface, placement=placement.after(surface.placement))
    return PlacedSurface(surface=surface, placement=placement)


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in vector)
    return x, y, z

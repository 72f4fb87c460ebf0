"""Radial sweep of a section of the unit sphere: bevel gears."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.traces.straight import StraightTrace
from ..curves.traces.trace import Trace
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import radial_sweep
from ..sections.section import LoopedSection
from ..sections.sphere import SphericalSection
from ..surfaces.cone import Cone
from ..surfaces.plane import Plane
from ..surfaces.sphere import Sphere
from ..surfaces.surface import Surface
from .ends import Ends
from .levels import level_moments
from .motion import Motion


@dataclass(frozen=True, kw_only=True)
class Radial(Motion):
    """A region of the unit sphere moved outward from the apex, turning as its trace says: r = r(n, v) R_z(w(r)) n.

    levels   what the section lies on at parameter v. None: the sphere r = v. An angle λ, radians: the cone about z
             that is perpendicular to the cone of half-angle λ at the distance v, r cos(θ − λ) = v with the polar angle
             θ; at λ = 0 the plane z = v, at λ = π/2 a cylinder

    The turn follows the distance r from the apex whatever the levels: teeth run together sphere by sphere.
    Source: theory of (S2); Al-Daccak 1989, ch. 3, sweeps the same teeth between spheres as polyhedra.
    """

    trace: Trace
    levels: float | None = None

    def place(self, point: Array, v: ArrayLike) -> Array:
        distance = np.asarray(v, float) / self._height(point)
        return self._turned(point, distance) * distance[..., None]

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        height = self._height(point)
        distance = np.asarray(v, float) / height
        straight = self._turned(tangent, distance) * distance[..., None]
        if self.levels is None:
            return straight
        growth = -distance / height * self._height_rate(point, tangent)
        return straight + self._outward(point, distance) * growth[..., None]

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        height = self._height(point)
        return self._outward(point, np.asarray(v, float) / height) / height[..., None]

    def _outward(self, point: Array, distance: Array) -> Array:
        """∂r/∂r (..., 3): along the trace."""
        turned = self._turned(point, distance)
        across = np.stack([-turned[..., 1], turned[..., 0], np.zeros_like(turned[..., 0])], axis=-1)
        return turned + across * (distance * self.trace.slope(distance))[..., None]

    def _turned(self, point: Array, distance: Array) -> Array:
        w = self.trace.turn(distance)
        c, s = np.cos(w), np.sin(w)
        x, y, z = point[..., 0], point[..., 1], point[..., 2]
        return np.stack([c * x - s * y, s * x + c * y, z + np.zeros_like(w)], axis=-1)

    def _height(self, point: Array) -> Array:
        """v/r (...): cos(θ − λ) at unit points (..., 3); 1 for spheres."""
        if self.levels is None:
            return np.ones(point.shape[:-1])
        c, s = np.cos(self.levels), np.sin(self.levels)
        return point[..., 2] * c + (np.hypot(point[..., 0], point[..., 1]) * s if self.levels else 0.0)

    def _height_rate(self, point: Array, tangent: Array) -> Array:
        """What it grows by along tangents (..., 3)."""
        c, s = np.cos(self.levels or 0.0), np.sin(self.levels or 0.0)
        if not self.levels:
            return np.asarray(tangent[..., 2] * c)
        rho = np.hypot(point[..., 0], point[..., 1])
        return tangent[..., 2] * c + (point[..., 0] * tangent[..., 0] + point[..., 1] * tangent[..., 1]) * (s / rho)

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.asarray(v, float) ** 2 / self._height(point) ** 3

    def end_surface(self, v: float) -> Surface:
        if self.levels is None:
            return Sphere(radius=v)
        return Plane(origin=(0.0, 0.0, v)) if self.levels == 0.0 else Cone(angle=self.levels, distance=v)

    @property
    def layered(self) -> bool:
        return True

    def station(self, v: float) -> str:
        return f"cone distance {v:.6g}"

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        """(S2) where the levels are spheres; else, and where the section varies, sums over the levels.

        A section with three or more equal sectors has the same moments on every sphere however it is turned, and so
        has the body. Others that turn have no reduction between cones and planes, or where they vary.
        """
        if not isinstance(section, SphericalSection):
            return None
        start, finish = ends.start, ends.finish
        # the difference of two cone distances loses what their ratio to the width says
        width_error = float(np.finfo(float).eps) * finish / (finish - start)
        if self.levels is None and not section.varies:
            matrix = radial_sweep(section.moments, lambda p, j: self.trace.radial_integral(p, j, start, finish))
            body = about_centroid(matrix, "exact", section.moments_error)
        elif section.order >= 3 or isinstance(self.trace, StraightTrace):
            body = level_moments(section, self.levels, start, finish)
        else:
            return None
        return replace(body, error_bound=body.error_bound + width_error)

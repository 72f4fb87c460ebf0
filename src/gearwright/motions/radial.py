"""Radial sweep of a section of the unit sphere: bevel gears."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.traces.trace import Trace
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import radial_sweep
from ..sections.section import LoopedSection
from ..sections.sphere import SphericalSection
from ..surfaces.sphere import Sphere
from ..surfaces.surface import Surface
from .ends import ConstantEnd, End, Ends
from .motion import Motion


@dataclass(frozen=True, kw_only=True)
class Radial(Motion):
    """r = v R_z(w(v)) n: a region of the unit sphere moved outward from the apex, turning as its trace says.

    Source: theory of (S2); Al-Daccak 1989, ch. 3, sweeps the same teeth as polyhedra.
    """

    trace: Trace

    def place(self, point: Array, v: ArrayLike) -> Array:
        v = np.asarray(v, float)
        return self._turned(point, v) * v[..., None]

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        return self.place(tangent, v)

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        v = np.asarray(v, float)
        turned = self._turned(point, v)
        across = np.stack([-turned[..., 1], turned[..., 0], np.zeros_like(turned[..., 0])], axis=-1)
        return turned + across * (v * self.trace.slope(v))[..., None]

    def _turned(self, point: Array, v: Array) -> Array:
        w = self.trace.turn(v)
        c, s = np.cos(w), np.sin(w)
        x, y, z = point[..., 0], point[..., 1], point[..., 2]
        return np.stack([c * x - s * y, s * x + c * y, z + np.zeros_like(w)], axis=-1)

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.asarray(v, float) ** 2 + np.zeros(point.shape[:-1])

    def end_surface(self, end: End) -> Surface:
        if not isinstance(end, ConstantEnd):
            raise TypeError("a radial sweep ends on spheres of constant cone distance")
        return Sphere(radius=end.parameter)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        constants = ends.constants
        if constants is None or not isinstance(section, SphericalSection) or section.varies:
            return None
        start, finish = constants
        matrix = radial_sweep(section.moments, lambda p, j: self.trace.radial_integral(p, j, start, finish))
        # the difference of two cone distances loses what their ratio to the width says
        width_error = float(np.finfo(float).eps) * finish / (finish - start)
        body = about_centroid(matrix, "exact", section.moments_error)
        return replace(body, error_bound=body.error_bound + width_error)

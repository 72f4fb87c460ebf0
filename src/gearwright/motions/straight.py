"""Straight extrusion along z."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import straight_sweep
from ..sections.plane import Section
from ..sections.section import LoopedSection
from ..surfaces.surface import Surface
from .ends import Ends
from .motion import Motion
from .parallel import in_space, level_plane
from .plane_quadrature import quadrature_moments


@dataclass(frozen=True, kw_only=True)
class Straight(Motion):
    """r = (x, y, v): a plane section moved along its normal. Source: Al-Daccak 1989, eq. (5.15)."""

    def place(self, point: Array, v: ArrayLike) -> Array:
        return in_space(point, v)

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        return in_space(tangent, np.zeros(np.shape(v)))

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        return in_space(np.zeros_like(point), np.ones(np.shape(v)))

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.ones(np.broadcast_shapes(point.shape[:-1], np.shape(v)))

    def end_surface(self, v: float) -> Surface:
        return level_plane(v)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        if not isinstance(section, Section):
            return None
        start, finish = ends.start, ends.finish
        if section.varies:
            return quadrature_moments(self, section, start, finish)
        local = section.local_moments
        matrix = straight_sweep(local.values, finish - start)
        middle = np.array([*local.origin, (start + finish) / 2.0])
        return about_centroid(matrix, "exact", section.moments_error, middle)

    @property
    def layered(self) -> bool:
        return True

    def station(self, v: float) -> str:
        return f"height {v:.6g}"

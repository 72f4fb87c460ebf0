"""Straight extrusion along z."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import straight_sweep
from ..sections.section import LoopedSection
from ..surfaces.plane import Plane
from ..surfaces.surface import Surface
from .ends import ConstantEnd, End, Ends
from .motion import Motion


@dataclass(frozen=True, kw_only=True)
class Straight(Motion):
    """r = (x, y, v): a plane section moved along its normal. Source: Al-Daccak 1989, eq. (5.15)."""

    def place(self, point: Array, v: ArrayLike) -> Array:
        z = np.broadcast_to(v, point.shape[:-1])
        return np.concatenate([point, z[..., None]], axis=-1)

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point, v
        return np.concatenate([tangent, np.zeros((*tangent.shape[:-1], 1))], axis=-1)

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        del v
        return np.broadcast_to([0.0, 0.0, 1.0], (*point.shape[:-1], 3)).copy()

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.ones(np.broadcast_shapes(point.shape[:-1], np.shape(v)))

    def end_surface(self, end: End) -> Surface:
        if not isinstance(end, ConstantEnd):
            raise TypeError("a straight extrusion ends on planes of constant z")
        return Plane(origin=(0.0, 0.0, end.parameter))

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        constants = ends.constants
        if constants is None:
            return None
        start, finish = constants
        matrix = straight_sweep(section.moments, finish - start)
        middle = np.array([0.0, 0.0, (start + finish) / 2.0])
        return about_centroid(matrix, "exact", section.moments_error, middle)

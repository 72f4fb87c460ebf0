"""The concept of a parallel sweep: the section stays in planes of constant z and is mapped linearly in each."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments
from ..sections.plane import Section
from ..sections.section import LoopedSection
from ..surfaces.plane import Plane
from ..surfaces.surface import Surface
from .ends import Ends
from .motion import Motion
from .plane_quadrature import quadrature_moments


@dataclass(frozen=True, kw_only=True)
class ParallelMotion(Motion):
    """r = (A(v) p + h(v), v) with A (2, 2) and h (2,): twist, scaling, shear and skew in any mixture.

    Source: Al-Daccak 1989, eqs. (5.3)–(5.13), where A = [f₁ g₁; f₂ g₂] and h = (h₁, h₂).
    """

    @abstractmethod
    def linear(self, v: ArrayLike) -> Array:
        """A (..., 2, 2) at parameters v (...)."""

    @abstractmethod
    def linear_rate(self, v: ArrayLike) -> Array:
        """dA/dv (..., 2, 2)."""

    @abstractmethod
    def offset(self, v: ArrayLike) -> Array:
        """h (..., 2) at parameters v (...)."""

    @abstractmethod
    def offset_rate(self, v: ArrayLike) -> Array:
        """dh/dv (..., 2)."""

    def place(self, point: Array, v: ArrayLike) -> Array:
        return in_space(applied(self.linear(v), point) + self.offset(v), v)

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        return in_space(applied(self.linear(v), tangent), np.zeros(np.shape(v)))

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        return in_space(applied(self.linear_rate(v), point) + self.offset_rate(v), np.ones(np.shape(v)))

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.linalg.det(self.linear(v)) + np.zeros(point.shape[:-1])

    def end_surface(self, v: float) -> Surface:
        return level_plane(v)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        if not isinstance(section, Section):
            return None
        return quadrature_moments(self, section, ends.start, ends.finish)

    @property
    def layered(self) -> bool:
        return True

    def station(self, v: float) -> str:
        return f"height {v:.6g}"

    def remedy(self, point: Array, v: float) -> str:
        element = float(self.jacobian(point, v))
        return f"the map's determinant f₁g₂ − f₂g₁ is {element:.4g} there; it must stay greater than 0"


def level_plane(height: float) -> Plane:
    """The plane z = height on which a parallel sweep ends; its normal is +z."""
    return Plane(origin=(0.0, 0.0, height))


def in_space(vectors: Array, z: ArrayLike) -> Array:
    """(x, y, z) (..., 3) of plane vectors (..., 2) and z (...), broadcast against each other."""
    shape = np.broadcast_shapes(vectors.shape[:-1], np.shape(z))
    plane = np.broadcast_to(vectors, (*shape, 2))
    return np.concatenate([plane, np.broadcast_to(z, shape)[..., None]], axis=-1)


def applied(matrices: Array, vectors: Array) -> Array:
    """Products (..., m) of matrices (..., m, n) and vectors (..., n)."""
    return (matrices @ vectors[..., None])[..., 0]

"""The concept of a parallel sweep: the section stays in planes of constant z and is mapped linearly in each."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments, about_centroid
from ..moments.boundary_integral import moment_matrix_2d
from ..moments.quadrature import converged, gauss_legendre
from ..moments.sweep import parallel_sweep
from ..sections.plane import Section
from ..sections.section import LoopedSection
from ..surfaces.plane import Plane
from ..surfaces.surface import Surface
from .ends import ConstantEnd, End, Ends
from .motion import Motion


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
        return in_space(_mapped(self.linear(v), point) + self.offset(v), v)

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        return in_space(_mapped(self.linear(v), tangent), np.zeros(np.shape(v)))

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        return in_space(_mapped(self.linear_rate(v), point) + self.offset_rate(v), np.ones(np.shape(v)))

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return np.linalg.det(self.linear(v)) + np.zeros(point.shape[:-1])

    def end_surface(self, end: End) -> Surface:
        return level_plane(end)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        """By quadrature of (S1), nodes increased until it settles; about the middle of the section's way."""
        constants = ends.constants
        if constants is None or not isinstance(section, Section):
            return None
        start, finish = constants
        local = section.local_moments
        middle = (start + finish) / 2.0
        origin = self.place(local.origin, middle)
        size = float(np.cbrt(local.area * (finish - start)))
        unit = np.outer([1.0, size, size, size], [1.0, size, size, size]) * size**3

        def scaled(nodes: int) -> Array:
            x, w = gauss_legendre(nodes)
            v = middle + (finish - start) / 2.0 * x
            weights = w * (finish - start) / 2.0 * np.linalg.det(self.linear(v))
            shifts = self.place(np.broadcast_to(local.origin, (nodes, 2)), v) - origin
            return parallel_sweep(moment_matrix_2d(local.values), self.linear(v), shifts, weights) / unit

        matrix, error = converged(scaled)
        return about_centroid(matrix * unit, "exact", error + section.moments_error, origin)


def level_plane(end: End) -> Plane:
    """The plane z = constant on which a parallel sweep ends; its normal is +z. Raises TypeError for other ends."""
    if not isinstance(end, ConstantEnd):
        raise TypeError("a parallel sweep ends on planes of constant z")
    return Plane(origin=(0.0, 0.0, end.parameter))


def in_space(vectors: Array, z: ArrayLike) -> Array:
    """(x, y, z) (..., 3) of plane vectors (..., 2) and z (...), broadcast against each other."""
    shape = np.broadcast_shapes(vectors.shape[:-1], np.shape(z))
    plane = np.broadcast_to(vectors, (*shape, 2))
    return np.concatenate([plane, np.broadcast_to(z, shape)[..., None]], axis=-1)


def _mapped(linear: Array, vectors: Array) -> Array:
    """A p (..., 2) of matrices (..., 2, 2) and vectors (..., 2)."""
    return (linear @ vectors[..., None])[..., 0]

"""Elliptic arcs in the plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class EllipticArc(Curve):
    """The elliptic arc centre + a cos u + b sin u, for any two vectors a, b: an affine image of a circle's.

    a, b   a pair of conjugate half diameters; the half axes, where they are at right angles
    """

    centre: tuple[float, float]
    a: tuple[float, float]
    b: tuple[float, float]

    def point(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)[..., None]
        return np.asarray(self.centre) + np.asarray(self.a) * np.cos(u) + np.asarray(self.b) * np.sin(u)

    def derivative(self, u: ArrayLike) -> Array:
        u = np.asarray(u, float)[..., None]
        return np.asarray(self.b) * np.cos(u) - np.asarray(self.a) * np.sin(u)

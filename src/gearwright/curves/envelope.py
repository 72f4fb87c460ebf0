"""Curves given by their tangents: the support function and where each tangent touches."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True, eq=False)
class Tangents:
    """Tangents of a plane curve at parameters (...).

    normal   (..., 2)  unit normals n(ν), outwards
    support  (...)     p, distance of the tangent from the origin along n
    along    (...)     q = dp/dν, from the foot of that distance to the point that is touched, along t = dn/dν
    speed    (...)     of that point along t, by the parameter; ρ dν/du with ρ = p + d²p/dν²
    """

    normal: Array
    support: Array
    along: Array
    speed: Array


@dataclass(frozen=True, kw_only=True)
class Envelope(Curve):
    """The envelope of the lines r·n = p: the points p n + q t.

    tangents   u (...) → the tangents there; analytic over the interval

    Source: Al-Daccak 1989, ch. 4.5.1 (Angeles & López-Cajún 1988).
    """

    tangents: Callable[[Array], Tangents]

    def point(self, u: ArrayLike) -> Array:
        found = self.tangents(np.asarray(u, float))
        return found.support[..., None] * found.normal + found.along[..., None] * _left(found.normal)

    def derivative(self, u: ArrayLike) -> Array:
        found = self.tangents(np.asarray(u, float))
        return found.speed[..., None] * _left(found.normal)


def _left(normal: Array) -> Array:
    """Vectors (..., 2) turned by a right angle counter-clockwise."""
    return np.stack([-normal[..., 1], normal[..., 0]], axis=-1)

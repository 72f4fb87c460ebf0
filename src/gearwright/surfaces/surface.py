"""The concept of a surface that carries an end face."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array

AXES: Array = np.eye(3)
"""The directions of the coordinates."""


@dataclass(frozen=True, kw_only=True)
class Surface(ABC):
    """An oriented surface with a chart: loops counter-clockwise in the chart bound a face with its natural normal.

    Two surfaces are one if they compare equal, or `coincides` says so.
    """

    def coincides(self, other: Surface) -> bool:
        """Whether another surface is this one, but for the rounding of what it was made from."""
        return self == other

    @abstractmethod
    def chart(self, points: Array) -> Array:
        """Chart coordinates (..., 2) of points (..., 3) on the surface; conformal, so that shapes are kept."""

    @abstractmethod
    def point(self, chart: Array) -> Array:
        """Points (..., 3) of the surface at chart coordinates (..., 2)."""

    @abstractmethod
    def deviation(self, points: Array) -> Array:
        """Distance (...) of points (..., 3) from the surface."""

    @abstractmethod
    def spacing(self, tolerance: float, chart: Array) -> Array:
        """Chart distance (...) between neighbours of a square lattice whose triangles keep a chord tolerance."""

    @abstractmethod
    def area(self, points: Array, tangents: Array) -> float:
        """Area of the face, negative where its loops run clockwise in the chart; arguments as for flux."""

    @abstractmethod
    def extremes(self, directions: Array = AXES) -> Array:
        """Points (n, 3) at which the coordinate along one of some unit vectors (k, 3) is stationary on the surface."""

    @abstractmethod
    def flux(self, points: Array, tangents: Array) -> Array:
        """∫ (r·n) [1/3 rᵀ/4; r/4 r rᵀ/5] dA (4, 4): the face's share of the moments of the body it bounds.

        points, tangents   (n, 3)  nodes of the loops and weighted tangents, in space
        """

"""Properties of a plane section: area, centroid, second and third moments."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array
from ..moments.plane import PlaneMoments


@dataclass(frozen=True, kw_only=True, eq=False)
class SectionProperties:
    """Moments of a region of the plane, in the length unit it was drawn in.

    local        moments to order 3 about a point near the section
    perimeter    length of all loops, holes included
    error_bound  bound on the relative error of the moments about that point

    Moments of area are about axes: I_x = ∫ y² dA about the x axis, I_y = ∫ x² dA about the y axis; the product is
    I_xy = +∫ xy dA. Those named `central_` are about axes through the centroid, the others through the origin.
    """

    local: PlaneMoments
    perimeter: float
    error_bound: float

    @property
    def area(self) -> float:
        return self.local.area

    @property
    def centroid(self) -> Array:
        """(2,)."""
        return self.local.centroid

    @property
    def moments(self) -> Array:
        """m[a, b] = ∫ x^a y^b dA (4, 4) for a + b ≤ 3, about the origin."""
        return self.local.about((0.0, 0.0))

    @property
    def central_moments(self) -> Array:
        """m[a, b] (4, 4) for a + b ≤ 3, about the centroid."""
        return self.local.about(self.centroid)

    @property
    def second_moments(self) -> Array:
        """I_x and I_y (2,) about the axes of the frame."""
        return _second(self.moments)

    @property
    def product(self) -> float:
        """I_xy = +∫ xy dA about the origin."""
        return float(self.moments[1, 1])

    @property
    def central_second_moments(self) -> Array:
        """I_x and I_y (2,) about parallel axes through the centroid."""
        return _second(self.central_moments)

    @property
    def central_product(self) -> float:
        """I_xy = +∫ xy dA about the centroid."""
        return float(self.central_moments[1, 1])

    @property
    def polar_moment(self) -> float:
        """∫ r² dA about the centroid, I_x + I_y."""
        return float(np.sum(self.central_second_moments))

    @property
    def principal_axes(self) -> Array:
        """Directions of the principal axes through the centroid as columns (2, 2): right-handed, in the order of
        the principal moments; the first one points to +x (or +y)."""
        m = self.central_moments
        difference, product = m[2, 0] - m[0, 2], m[1, 1]
        negligible = self.error_bound * (m[2, 0] + m[0, 2])
        if np.hypot(difference, 2.0 * product) <= negligible:
            return np.eye(2)  # every axis is a principal one
        angle = np.arctan2(2.0 * product, difference) / 2.0  # of the axis of greatest extent: least moment about it
        c, s = np.cos(angle), np.sin(angle)
        return np.array([[c, -s], [s, c]])

    @property
    def principal_moments(self) -> Array:
        """Moments of area (2,) about the principal axes, ascending."""
        m = self.central_moments
        second = np.array([[m[0, 2], -m[1, 1]], [-m[1, 1], m[2, 0]]])
        axes = self.principal_axes
        return np.asarray(np.sort(np.einsum("ik,ij,jk->k", axes, second, axes)))

    @property
    def radii_of_gyration(self) -> Array:
        """√(principal moment / area) (2,)."""
        return np.sqrt(self.principal_moments / self.area)

    def to_dict(self) -> dict[str, Any]:
        """Everything by name as plain numbers and lists, for JSON."""
        names = (
            "area perimeter centroid second_moments product central_second_moments central_product polar_moment"
            " principal_moments principal_axes radii_of_gyration moments error_bound"
        )
        values = {name: getattr(self, name) for name in names.split()}
        return {name: v.tolist() if isinstance(v, np.ndarray) else v for name, v in values.items()}


def _second(moments: Array) -> Array:
    return np.array([moments[0, 2], moments[2, 0]])

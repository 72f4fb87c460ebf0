"""Plane sections."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array
from ..moments.boundary_integral import plane_moments
from ..moments.plane import PlaneMoments
from .loop import Loop
from .section import LoopedSection


@dataclass(frozen=True, kw_only=True)
class Section(LoopedSection):
    """A region of the plane bounded by loops of curves (d = 2)."""

    @cached_property
    def _frame(self) -> tuple[Array, float]:
        """A point in the middle of the section (where it has symmetry, the origin), and its size from there."""
        points = np.concatenate([self._own(loop).quadrature(8)[0] for loop in self.loops])
        middle = np.zeros(2) if self.order > 1 else (points.min(axis=0) + points.max(axis=0)) / 2.0
        return middle, float(np.max(np.abs(points - middle))) or 1.0

    def _own(self, loop: Loop) -> Loop:
        """A loop as periods about the origin, or, where the section has no symmetry, as a whole."""
        return loop if self.order > 1 else loop.with_copies(1)

    def _integral(self, loops: tuple[Loop, ...], nodes: int) -> Array:
        """In the section's own frame, its size as the unit."""
        middle, size = self._frame
        parts = []
        for loop in map(self._own, loops):
            points, tangents = loop.quadrature(nodes)
            parts.append(plane_moments((points - middle) / size, tangents / size, order=loop.copies))
        return sum(parts[1:], start=parts[0])

    @cached_property
    def local_moments(self) -> PlaneMoments:
        """Moments to order 3 on the true curves, about a point near the section."""
        middle, size = self._frame
        values, _ = self._converged
        powers = np.add.outer(np.arange(len(values)), np.arange(len(values)))
        return PlaneMoments(origin=middle, values=values * size ** (2.0 + powers))

    @property
    def moments(self) -> Array:
        """m[a, b] = ∫ x^a y^b dA (4, 4) for a + b ≤ 3, about the section's origin."""
        return self.local_moments.about((0.0, 0.0))

"""Swept solids: section + motion + ends."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..boundary.boundary import Boundary
from ..boundary.swept import swept_boundary
from ..errors import GeometryError, Problem
from ..moments.body import BodyMoments
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.section import LoopedSection
from .solid import Solid, flux_moments

_SAMPLES = 8  # points a curve


@dataclass(frozen=True, kw_only=True)
class Swept(Solid):
    """A section moved by a motion between ends.

    Raises GeometryError where the ends do not go with the motion, or the motion turns the section inside out.
    """

    section: LoopedSection
    motion: Motion
    ends: Ends

    def __post_init__(self) -> None:
        refusal = self.motion.refusal(self.ends)
        problems = [Problem("the ends", refusal)] if refusal else self._inversions()
        if problems:
            raise GeometryError("The section cannot be swept so", problems)

    def _inversions(self) -> list[Problem]:
        """Where the volume element is negative, at points all along the section and three stations of the motion."""
        points = np.concatenate([loop.quadrature(_SAMPLES)[0] for loop in self.section.loops])
        problems = []
        for fraction in (0.0, 0.5, 1.0):
            stations = self.ends.value(points, np.full(len(points), fraction))
            elements = self.motion.jacobian(points, stations)
            worst = int(np.argmin(elements))
            if elements[worst] < 0.0:
                problems.append(
                    Problem(
                        f"section point {np.round(points[worst], 6).tolist()} at parameter {stations[worst]:.6g}",
                        "moves backwards there; keep the section on one side of the axis, or bend the path less",
                    )
                )
        return problems

    @cached_property
    def boundary(self) -> Boundary:
        return swept_boundary(self.section, self.motion, self.ends)

    @cached_property
    def moments(self) -> BodyMoments:
        """From the section's moments where the motion knows how, else by flux through the boundary."""
        return self.motion.moments(self.section, self.ends) or flux_moments(self.boundary)

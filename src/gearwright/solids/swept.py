"""Swept solids: section + motion + ends."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..boundary.boundary import Boundary
from ..boundary.swept import swept_boundary
from ..errors import GeometryError, Problem
from ..moments.body import BodyMoments
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.section import LoopedSection
from .inversions import inversions
from .solid import Solid, flux_moments
from .varying import varying_problems


@dataclass(frozen=True, kw_only=True, repr=False)
class Swept(Solid):
    """A section moved by a motion between ends.

    Raises GeometryError where the ends do not go with the motion, the motion turns the section inside out, or a section
    that varies falls apart on the way.
    """

    section: LoopedSection
    motion: Motion
    ends: Ends

    def __post_init__(self) -> None:
        refusal = self.motion.refusal(self.ends)
        problems = [Problem("the ends", refusal)] if refusal else self._problems()
        if problems:
            raise GeometryError("The section cannot be swept so", problems)

    def __repr__(self) -> str:
        return f"<Swept: {self.section!r} by {type(self.motion).__name__}>"

    def _problems(self) -> list[Problem]:
        varying = varying_problems(self.section, self.motion, self.ends) if self.section.varies else []
        return varying or inversions(self.section, self.motion, self.ends)

    @cached_property
    def boundary(self) -> Boundary:
        return swept_boundary(self.section, self.motion, self.ends)

    @cached_property
    def moments(self) -> BodyMoments:
        """From the section's moments where the motion knows how, else by flux through the boundary."""
        return self.motion.moments(self.section, self.ends) or flux_moments(self.boundary)

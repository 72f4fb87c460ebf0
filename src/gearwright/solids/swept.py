"""Swept solids: section + motion + ends."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..boundary.boundary import Boundary
from ..boundary.swept import swept_boundary
from ..moments.body import BodyMoments
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.section import LoopedSection
from .solid import Solid, flux_moments


@dataclass(frozen=True, kw_only=True)
class Swept(Solid):
    """A section moved by a motion between ends."""

    section: LoopedSection
    motion: Motion
    ends: Ends

    @cached_property
    def boundary(self) -> Boundary:
        return swept_boundary(self.section, self.motion, self.ends)

    @cached_property
    def moments(self) -> BodyMoments:
        """From the section's moments where the motion knows how, else by flux through the boundary."""
        return self.motion.moments(self.section, self.ends) or flux_moments(self.boundary)

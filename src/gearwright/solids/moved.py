"""Solids put elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..boundary.boundary import Boundary
from ..boundary.placed import placed_boundary
from ..moments.body import BodyMoments
from ..motions.placed import placed_moments
from ..placement import Placement
from .solid import Solid


@dataclass(frozen=True, kw_only=True, repr=False)
class Moved(Solid):
    """A solid under a rigid placement: its boundary and its moments move with it."""

    solid: Solid
    placement: Placement

    def __repr__(self) -> str:
        return f"<Moved: {self.solid!r}>"

    @cached_property
    def boundary(self) -> Boundary:
        return placed_boundary(self.solid.boundary, self.placement)

    @cached_property
    def moments(self) -> BodyMoments:
        return placed_moments(self.solid.moments, self.placement)

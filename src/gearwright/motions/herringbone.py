"""Extrusion twisted to the middle of its length and back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments, summed
from ..sections.section import LoopedSection
from .ends import Ends
from .extrusion import Extrusion
from .parallel import ParallelMotion


@dataclass(frozen=True, kw_only=True)
class Herringbone(ParallelMotion):
    """p ↦ R(θ) p at height v from 0 to L, θ growing evenly from 0 to the twist at L/2 and falling back to 0 at L.

    length   L
    twist    angle of the middle against both ends, radians; right-handed in the lower half if positive

    Either half is a twisted extrusion; they meet in the plane v = L/2, where the motion has a break.
    """

    length: float
    twist: float

    @property
    def middle(self) -> float:
        return self.length / 2.0

    @property
    def lower(self) -> Extrusion:
        """The motion below the middle."""
        return Extrusion(length=self.middle, twist=self.twist)

    @property
    def upper(self) -> Extrusion:
        """The motion above the middle: turned by 2·twist at v = 0, were it to start there."""
        return Extrusion(length=self.middle, twist=-self.twist, near_angle=2.0 * self.twist)

    def linear(self, v: ArrayLike) -> Array:
        return self._either(v, self.lower.linear(v), self.upper.linear(v))

    def linear_rate(self, v: ArrayLike) -> Array:
        return self._either(v, self.lower.linear_rate(v), self.upper.linear_rate(v))

    def _either(self, v: ArrayLike, below: Array, above: Array) -> Array:
        return np.where((np.asarray(v, float) < self.middle)[..., None, None], below, above)

    def offset(self, v: ArrayLike) -> Array:
        return np.zeros((*np.shape(v), 2))

    def offset_rate(self, v: ArrayLike) -> Array:
        return np.zeros((*np.shape(v), 2))

    def breaks(self, ends: Ends) -> tuple[float, ...]:
        return (self.middle,) if ends.start < self.middle < ends.finish else ()

    def smooth_piece(self, span: Ends) -> Extrusion:
        return self.lower if span.start + span.finish < self.length else self.upper

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        """The sum of both halves, each in closed form."""
        spans = ends.spans(self.breaks(ends))
        parts = [self.smooth_piece(span).moments(section, span) for span in spans]
        found = [part for part in parts if part is not None]
        return summed(found) if len(found) == len(spans) else None

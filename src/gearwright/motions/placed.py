"""Motions of a section whose solid was put elsewhere."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import gcd

from ..arrays import Array, ArrayLike
from ..curves.curve import Curve
from ..moments.body import BodyMoments
from ..moments.matrix import transformed
from ..placement import Placement
from ..sections.section import LoopedSection
from ..surfaces.placed import placed_surface
from ..surfaces.surface import Surface
from .ends import Ends
from .motion import Motion


@dataclass(frozen=True, kw_only=True)
class Placed(Motion):
    """r = R m(p, v) + t: another motion m, and then a rigid placement."""

    motion: Motion
    placement: Placement

    def place(self, point: Array, v: ArrayLike) -> Array:
        return self.placement.points(self.motion.place(point, v))

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        return self.placement.vectors(self.motion.carry(point, tangent, v))

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        return self.placement.vectors(self.motion.velocity(point, v))

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return self.motion.jacobian(point, v)

    def end_surface(self, v: float) -> Surface:
        return placed_surface(self.motion.end_surface(v), self.placement)

    def swept_surface(self, curve: Curve) -> Surface | None:
        surface = self.motion.swept_surface(curve)
        return None if surface is None else placed_surface(surface, self.placement)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        moments = self.motion.moments(section, ends)
        return None if moments is None else placed_moments(moments, self.placement)

    def refusal(self, ends: Ends) -> str | None:
        return self.motion.refusal(ends)

    def breaks(self, ends: Ends) -> tuple[float, ...]:
        return self.motion.breaks(ends)

    def smooth_piece(self, span: Ends) -> Motion:
        return replace(self, motion=self.motion.smooth_piece(span))

    def panels(self, start: float, finish: float) -> tuple[float, ...]:
        return self.motion.panels(start, finish)

    def station(self, v: float) -> str:
        return self.motion.station(v)

    def remedy(self, point: Array, v: float) -> str:
        return self.motion.remedy(point, v)

    @property
    def has_still_points(self) -> bool:
        return self.motion.has_still_points

    @property
    def rotation_order(self) -> int:
        """That of the motion where the axis stays, half turns only where it is turned over, else 1."""
        if self.placement.keeps_axis:
            return self.motion.rotation_order
        return gcd(self.motion.rotation_order, 2) if self.placement.flips_axis else 1

    @property
    def layered(self) -> bool:
        """That of the motion; its planes are turned with it."""
        return self.motion.layered

    def closed(self, ends: Ends) -> bool:
        return self.motion.closed(ends)


def placed(motion: Motion, placement: Placement) -> Placed:
    """The motion put elsewhere; of one that already was, both placements in one."""
    if isinstance(motion, Placed):
        return replace(motion, placement=placement.after(motion.placement))
    return Placed(motion=motion, placement=placement)


def placed_moments(moments: BodyMoments, placement: Placement) -> BodyMoments:
    """The moments of the body put elsewhere: its point near the centroid moves, its tensors turn."""
    return replace(
        moments,
        origin=placement.points(moments.origin),
        matrix=transformed(moments.matrix, placement.matrix),
    )

"""Flanks on the unit sphere with relief: a little is taken off along the normal great circle towards the tip."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .rolled import RolledCurve


@dataclass(frozen=True, kw_only=True)
class RelievedRolled(RolledCurve):
    """A flank P moved into its tooth along its normal great circle N: P cos c + N sin c.

    flank         the curve it departs from, of the same pitch cone; u is its parameter
    amount        C, what is taken off at the parameter `full`, radians on the unit sphere
    begin, full   parameters between which the relief c = C ((u − begin)/(full − begin))^power grows
    power         1: straight from where it begins, 2: parabolic, tangent to the flank

    The normal great circle passes the pitch point, so that the relief adds to the contact's distance from it.
    Source: ISO 21771, tip relief as amounts along the line of action, on great circles.
    """

    flank: RolledCurve
    amount: float
    begin: float
    full: float
    power: int

    def __post_init__(self) -> None:
        if self.flank.pitch_angle != self.pitch_angle:
            raise ValueError("a relieved flank has the pitch cone of the flank it departs from")

    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn, bearing, distance = self.flank.contact(u)
        return turn, bearing, distance + self.amount * self._share(u) ** self.power

    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turning, swing, speed = self.flank.contact_rates(u)
        rate = self.amount * self.power * self._share(u) ** (self.power - 1) / (self.full - self.begin)
        return turning, swing, speed + rate

    def _share(self, u: ArrayLike) -> Array:
        return (np.asarray(u, float) - self.begin) / (self.full - self.begin)

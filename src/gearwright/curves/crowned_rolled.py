"""Flanks on the unit sphere with profile crowning: they turn into their tooth away from the pitch cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .rolled import RolledCurve


@dataclass(frozen=True, kw_only=True)
class CrownedRolled(RolledCurve):
    """A flank turned about the gear's axis by ε = E (u/u_E)², nothing on the pitch cone.

    flank    the curve it departs from, of the same pitch cone; u is its parameter, 0 on the pitch cone
    amount   E, radians about the axis; positive turns the flank on the clockwise side into its tooth
    full     u_E at which it has all of it

    Polar angles stay as they are. Source: ISO 21771, profile crowning, of which the normal amount is E sin γ_b for an
    involute.
    """

    flank: RolledCurve
    amount: float
    full: float

    def __post_init__(self) -> None:
        if self.flank.pitch_angle != self.pitch_angle:
            raise ValueError("a crowned flank has the pitch cone of the flank it departs from")

    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn, bearing, distance = self.flank.contact(u)
        return turn + self._crown_turn * (np.asarray(u, float) / self.full) ** 2, bearing, distance

    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turning, swing, speed = self.flank.contact_rates(u)
        return turning + 2.0 * self._crown_turn * np.asarray(u, float) / self.full**2, swing, speed

    @property
    def _crown_turn(self) -> float:
        """Turn of the crown gear that turns the gear by E."""
        return float(self.amount * np.sin(self.pitch_angle))

"""The spherical involute as a crown gear leaves it on a pitch cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .rolled import RolledCurve


@dataclass(frozen=True, kw_only=True)
class RolledInvolute(RolledCurve):
    """The spherical involute of a pitch cone γ and a pressure angle a; u is the crown gear's turn, 0 at the pitch cone.

    pressure_angle   a, between the great circle of action and the pitch plane, radians

    Its contacts stay on one great circle, at the distance −u cos a from the pitch point. The curve is the
    `SphericalInvolute` of the base cone sin γ_b = sin γ cos a, turned; that one counts its roll from the cusp.
    """

    pressure_angle: float

    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn = np.asarray(u, float)
        return turn, np.full_like(turn, self.pressure_angle), -np.cos(self.pressure_angle) * turn

    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn = np.asarray(u, float)
        return np.ones_like(turn), np.zeros_like(turn), np.full_like(turn, -np.cos(self.pressure_angle))

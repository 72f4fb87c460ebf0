"""The rounded tip of the crown gear's tooth that generates the root of a bevel gear."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..gear_loop import NEXT_TO_NOTHING
from .spherical_flank import SphericalFlank


@dataclass(frozen=True, kw_only=True)
class CrownTip:
    """The end of a crown gear's tooth, its corners small circles tangent to its flanks and to its tip parallel.

    flank        form of the flanks; of the gear that it generates, or the crown gear's own
    half_width   of the crown gear's tooth on its pitch plane, radians about its axis
    depth        θ_f of its tip above the pitch plane, towards the gear's axis, radians
    radius       ρ of the small circles, angular

    Source: ISO 53, the basic rack's tip, on the sphere.
    """

    flank: SphericalFlank
    half_width: float
    depth: float
    radius: float

    @property
    def centre_depth(self) -> float:
        """Angle of the corners' centres above the pitch plane."""
        return self.depth - self.radius

    @cached_property
    def tangent(self) -> tuple[float, float]:
        """Turn u and bearing at which flank and corner touch the gear together."""
        return self.flank.tip_tangent(self.centre_depth, self.radius)

    @property
    def reaches(self) -> bool:
        """Whether the crown gear has a flank down to its corner: an involute one ends at its own base cone."""
        return self.flank.crown_reaches(self.centre_depth, self.radius)

    @property
    def land(self) -> float:
        """Half the land between the corners, radians about the crown gear's axis; 0 where they leave none."""
        found = self._land(self.radius)
        return found if abs(found) > NEXT_TO_NOTHING * self.half_width else 0.0

    @cached_property
    def largest_radius(self) -> float:
        """ρ that leaves no land, as the corners then make one; not positive where the flanks meet before the tip."""
        from scipy.optimize import brentq

        most = self.depth + self.flank.pressure_angle
        sharp = self._land(0.0)
        if sharp <= 0.0 or self._land(most) >= 0.0:
            return min(sharp, 0.0) if sharp <= 0.0 else most
        return float(brentq(self._land, 0.0, most, xtol=1e-15))

    def _land(self, radius: float) -> float:
        """Half the land that corners of a radius leave; negative where they overlap."""
        depth = self.depth - radius
        turn, bearing = self.flank.tip_tangent(depth, radius)
        longitude = np.arcsin(np.clip(np.tan(depth) / np.tan(bearing), -1.0, 1.0))
        return float(self.half_width + longitude + turn)

"""The rounded bottom of a rack's space, or tip of its tooth, in the transverse plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..gear_loop import NEXT_TO_NOTHING


@dataclass(frozen=True, kw_only=True)
class RackTip:
    """The end of a symmetric trapezium with round corners.

    half_width       of the trapezium on the pitch line
    depth            of its land below that line
    pressure_angle   α_t of its sides against the normal of the pitch line, transverse, radians
    stretch          1/cos β, of the transverse section along the pitch line: corners round in the normal section
                     are elliptic in this one
    radius           ρ of the corners in the normal section

    Source: ISO 53; ISO 21771, ch. 4.
    """

    half_width: float
    depth: float
    pressure_angle: float
    stretch: float
    radius: float

    @property
    def half_axes(self) -> tuple[float, float]:
        """Of a corner's ellipse, along the pitch line and across it."""
        return self.stretch * self.radius, self.radius

    @property
    def _tangent(self) -> tuple[float, float]:
        """Where the side is tangent to the corner, from the ellipse's centre and by its radius."""
        c, s = np.cos(self.pressure_angle), np.sin(self.pressure_angle)
        root = np.hypot(self.stretch * c, s)
        return float(self.stretch**2 * c / root), float(s / root)

    @property
    def _shrinking(self) -> float:
        """By how much half the land shrinks as the radius grows."""
        x, y = self._tangent
        return float(x - (1.0 - y) * np.tan(self.pressure_angle))

    @property
    def _sharp_land(self) -> float:
        """Half the land between sharp corners."""
        return float(self.half_width - self.depth * np.tan(self.pressure_angle))

    @property
    def largest_radius(self) -> float:
        """ρ that leaves no land; negative where the sides meet before it."""
        return self._sharp_land / self._shrinking

    @property
    def land(self) -> float:
        """Half the land between the corners."""
        found = self._sharp_land - self.radius * self._shrinking
        return found if found > NEXT_TO_NOTHING * self.half_width else 0.0

    @property
    def side_end(self) -> tuple[float, float]:
        """Where a side ends at its corner: distance from the middle, and depth below the pitch line."""
        x, y = self._tangent
        return self.land + self.radius * x, self.depth - self.radius * (1.0 - y)

"""How the axes of a pair stand, and how far from where they should."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array


@dataclass(frozen=True, kw_only=True)
class Misalignment:
    """Errors of mounting, all nought for axes that stand as designed.

    shaft_angle       ΔΣ added to the angle between the axes, radians
    pinion, gear      shift of a member along its own axis, away from the apex, length
    offset            shift of the gear along +y, at right angles to both axes, length
    """

    shaft_angle: float = 0.0
    pinion: float = 0.0
    gear: float = 0.0
    offset: float = 0.0

    @property
    def keeps_apex(self) -> bool:
        """Whether the members still share their apex, so that spheres about it do not mix."""
        return self.pinion == self.gear == self.offset == 0.0

    def gear_seat(self, shaft_angle: float) -> tuple[Array, Array]:
        """Axes (3, 3), as columns, and apex (3,) of the gear in the pinion's frame: its x axis faces the pinion."""
        c, s = np.cos(shaft_angle + self.shaft_angle), np.sin(shaft_angle + self.shaft_angle)
        axes = np.array([[-c, 0.0, s], [0.0, -1.0, 0.0], [s, 0.0, c]])
        apex = self.gear * axes[:, 2] - np.array([0.0, 0.0, self.pinion]) + np.array([0.0, self.offset, 0.0])
        return axes, apex


ALIGNED = Misalignment()

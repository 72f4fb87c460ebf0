"""A bore with a keyway, in the plane across its axis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...curves.arc import Arc
from ...curves.line import lines_through
from ...sections.loop import Loop


@dataclass(frozen=True, kw_only=True)
class KeyedBore:
    """A round bore about the origin with a rectangular keyway centred on +x.

    radius         of the bore
    width, depth   of the keyway; the depth, t₂, is from the bore's circle on +x to the keyway's plane floor
    """

    radius: float
    width: float
    depth: float

    @property
    def floor(self) -> float:
        """Distance of the keyway's floor from the axis."""
        return self.radius + self.depth

    @property
    def corner_radius(self) -> float:
        """Distance of the floor's corners from the axis: the circle around all of it."""
        return float(np.hypot(self.floor, self.width / 2.0))

    def loop(self) -> Loop:
        """Its outline as that of a hole, clockwise."""
        half = self.width / 2.0
        mouth = float(np.arcsin(half / self.radius))
        arc = Arc(radius=self.radius, interval=(-mouth, mouth - 2.0 * np.pi))
        walls = lines_through(np.array([arc.end, (self.floor, half), (self.floor, -half), arc.start]))
        return Loop(curves=(arc, *walls))

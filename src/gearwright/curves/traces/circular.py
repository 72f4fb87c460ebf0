"""The arc of a circle, which single indexing with a face-mill cutter cuts."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from .cutter_arc import CutterArc
from .trace import SpiralTrace


@dataclass(frozen=True, kw_only=True)
class CircularTrace(SpiralTrace):
    """The face-milled trace: an arc of the cutter's radius on the crown gear; of mean spiral angle 0 a zerol tooth.

    cutter_radius   r_c

    sin β = (r² + r_c² − S²)/(2 r r_c), S² = r_m² + r_c² − 2 r_m r_c sin β_m, for |S − r_c| ≤ r ≤ S + r_c.
    Source: ISO 23509 (face milling).
    """

    cutter_radius: float

    @property
    def reach(self) -> tuple[float, float]:
        return self._arc.reach

    def crown_angle(self, distance: ArrayLike) -> Array:
        return self._arc.polar_angle(distance)

    def spiral_angle(self, distance: ArrayLike) -> Array:
        return np.arctan2(*self._arc.components(distance))

    @cached_property
    def _arc(self) -> CutterArc:
        return CutterArc(radius=self.cutter_radius, mean_distance=self.mean_distance, mean_angle=self.mean_spiral_angle)

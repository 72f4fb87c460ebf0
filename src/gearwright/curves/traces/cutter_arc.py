"""The arc that a blade of a circular cutter describes in the crown plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array, ArrayLike
from .trace import root


@dataclass(frozen=True, kw_only=True)
class CutterArc:
    """A circle of radius r_c through the mean point, at an angle β there to its radius r_m, as r grows.

    Its centre lies at S from the apex, S² = r_m² + r_c² − 2 r_m r_c sin β_m, and the arc runs from |S − r_c| to
    S + r_c. With δ = (r² − r_m²)/(2 r_c): r sin β = r_m sin β_m + δ, and the angle about the centre from the
    mean point is 2 atan(δ/(r cos β + r_m cos β_m)), which needs no S and keeps its digits near r_m.

    radius          r_c > 0
    mean_distance   r_m
    mean_angle      β_m in (−90°, 90°), radians
    """

    radius: float
    mean_distance: float
    mean_angle: float

    def __post_init__(self) -> None:
        if not self.radius > 0.0:
            raise ValueError(f"a cutter's radius is greater than 0, not {self.radius:g}")

    @property
    def reach(self) -> tuple[float, float]:
        """|S − r_c| and S + r_c; their product is |S² − r_c²| = r_m |r_m − 2 r_c sin β_m|, which does not cancel."""
        across = self.mean_distance * np.sin(self.mean_angle) - self.radius
        greatest = float(np.hypot(self.mean_distance * np.cos(self.mean_angle), across)) + self.radius
        product = self.mean_distance * abs(self.mean_distance - 2.0 * self.radius * np.sin(self.mean_angle))
        return (float(product / greatest), greatest)

    def components(self, distance: ArrayLike) -> tuple[Array, Array]:
        """r sin β (...) and r cos β (...). Raises ValueError beyond the reach."""
        r = np.asarray(distance, float)
        across = self._excess(r) + self.mean_distance * np.sin(self.mean_angle)
        return across, root((r - across) * (r + across), r)

    def central_angle(self, distance: ArrayLike) -> Array:
        """Angle (...) about the centre of the circle from the mean point to r (...), radians."""
        return 2.0 * self._half_angle(np.asarray(distance, float))

    def polar_angle(self, distance: ArrayLike) -> Array:
        """Angle (...) about the apex from the mean point to r (...), radians."""
        half = self._half_angle(np.asarray(distance, float))
        chord, heading = 2.0 * self.radius * np.sin(half), self.mean_angle + half
        return np.arctan2(chord * np.sin(heading), self.mean_distance + chord * np.cos(heading))

    def _excess(self, r: Array) -> Array:
        return (r - self.mean_distance) * (r + self.mean_distance) / (2.0 * self.radius)

    def _half_angle(self, r: Array) -> Array:
        mean = self.mean_distance * np.cos(self.mean_angle)
        return np.arctan(self._excess(r) / (self.components(r)[1] + mean))

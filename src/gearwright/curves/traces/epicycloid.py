"""The extended epicycloid, which continuous indexing with a face-hobbing cutter cuts."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array, ArrayLike
from .cutter_arc import CutterArc
from .trace import SpiralTrace


@dataclass(frozen=True, kw_only=True)
class EpicycloidTrace(SpiralTrace):
    """The face-hobbed trace E(t) = S e^{it} + r_c e^{i((1 + z_p/z₀)t + c)}: the cutter turns as the crown gear does.

    cutter_radius   r_c
    blade_groups    z₀
    crown_teeth     z_p = z/sin γ

    While a blade describes an arc of a circle about the cutter's centre, by an angle τ, the crown gear turns by
    τ z₀/z_p. The arc stands at β_m − ν to the mean radius, sin ν = z₀ r_m cos β_m/(z_p r_c), so that
    the trace stands at β_m; |E| = r is that of the arc alone, which gives τ from r in closed form.
    Source: ISO 23509 (face hobbing).
    """

    cutter_radius: float
    blade_groups: int
    crown_teeth: float

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self._lead_sine < 1.0:
            least = self._lead_sine * self.cutter_radius
            raise ValueError(f"so many blade groups need a cutter radius of more than {least:g}")

    @property
    def reach(self) -> tuple[float, float]:
        return self._arc.reach

    def crown_angle(self, distance: ArrayLike) -> Array:
        return self._arc.polar_angle(distance) + self._share * self._arc.central_angle(distance)

    def spiral_angle(self, distance: ArrayLike) -> Array:
        r = np.asarray(distance, float)
        across, along = self._arc.components(r)
        return np.arctan2(across + self._share * r**2 / self.cutter_radius, along)

    @property
    def _share(self) -> float:
        """What the crown gear turns for each turn of the cutter."""
        return self.blade_groups / self.crown_teeth

    @property
    def _lead_sine(self) -> float:
        """sin ν."""
        return float(self._share * self.mean_distance * np.cos(self.mean_spiral_angle) / self.cutter_radius)

    @cached_property
    def _arc(self) -> CutterArc:
        return CutterArc(
            radius=self.cutter_radius,
            mean_distance=self.mean_distance,
            mean_angle=float(self.mean_spiral_angle - np.arcsin(self._lead_sine)),
        )

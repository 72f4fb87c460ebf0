"""Where the axes of a pair are, and how its profile shifts go with that."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .mesh import distance_of_shifts, shifts_of_distance
from .toothing import Toothing


@dataclass(frozen=True, kw_only=True)
class AxesOfGears:
    """The axes of two gears whose profile shifts or whose distance is given; the other follows.

    pinion, gear   teeth in numbers, without profile shift
    given          profile shifts of both, or None
    distance       of the axes, or None

    With both given the pair runs at that distance; with neither the shifts are 0. Shifts that follow from the
    distance are half of their sum each.
    """

    pinion: Toothing
    gear: Toothing
    given: tuple[float, float] | None
    distance: float | None

    @property
    def reference(self) -> float:
        """a_d = r₂ ± r₁, without profile shift."""
        return self.gear.pitch_radius + self.gear.outward * self.pinion.pitch_radius

    @property
    def least(self) -> float:
        """r_b2 ± r_b1, beyond which axes must be apart for a line of action."""
        return self.gear.base_radius + self.gear.outward * self.pinion.base_radius

    @cached_property
    def shifts(self) -> tuple[float, float] | None:
        """x₁ and x₂; None where the axes are too near."""
        if self.given is not None:
            return self.given
        if self.distance is None:
            return 0.0, 0.0
        total = shifts_of_distance(self.pinion, self.gear, self.distance)
        return None if total is None else (total / 2.0, total / 2.0)

    @cached_property
    def centre_distance(self) -> float | None:
        """a; None where the profile shifts allow none."""
        if self.distance is not None:
            return self.distance if self.distance > self.least else None
        x1, x2 = self.shifts or (0.0, 0.0)
        return distance_of_shifts(self.pinion.shifted(x1), self.gear.shifted(x2))

    @property
    def modification(self) -> float:
        """y = (a − a_d)/m_n."""
        return ((self.centre_distance or np.nan) - self.reference) / self.pinion.module

    def addendum_down_to(self, radius: float) -> float:
        """Addendum of an internal gear whose tips meet the pinion's involutes at a radius on these.

        On the line of action that is at ρ₂ = a sin α_wt + ρ₁ from the gear's base circle.
        """
        distance = self.centre_distance or self.reference
        first = self.pinion.base_radius * float(self.pinion.roll(radius))
        second = float(np.sqrt(distance**2 - self.least**2)) + first
        return self.gear.pitch_radius - float(np.hypot(self.gear.base_radius, second))

    @property
    def members(self) -> tuple[Toothing, Toothing]:
        return self.pinion, self.gear

    @property
    def shortening(self) -> float:
        """k = y − (x₁ + x₂) modules by which tips are changed to keep the clearance; an internal pair needs none."""
        if self.gear.internal:
            return 0.0
        return min(0.0, self.modification - sum(self.shifts or (0.0, 0.0)))


@dataclass(frozen=True, kw_only=True)
class AxisOverRack:
    """The axis of a pinion over a rack's pitch plane, by its profile shift or its distance; the other follows."""

    pinion: Toothing
    given: tuple[float, float] | None
    distance: float | None

    @property
    def reference(self) -> float:
        """r₁, without profile shift."""
        return self.pinion.pitch_radius

    @property
    def least(self) -> float:
        return 0.0

    @property
    def shifts(self) -> tuple[float, float]:
        """x₁, and 0 for the rack."""
        if self.given is not None:
            return self.given[0], 0.0
        away = 0.0 if self.distance is None else (self.distance - self.reference) / self.pinion.module
        return away, 0.0

    @property
    def centre_distance(self) -> float:
        """From the pinion's axis to the rack's pitch plane."""
        return self.reference + self.shifts[0] * self.pinion.module if self.distance is None else self.distance

    @property
    def shortening(self) -> float:
        """A rack's pitch plane moves with the profile shift: the clearance stays."""
        return 0.0

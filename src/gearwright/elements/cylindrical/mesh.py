"""An involute pinion in mesh: the path of contact, ratios, sliding, backlash and clearance."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...curves.involute import inverse_involute_function, involute_function
from .external_tooth import ExternalTooth
from .internal_tooth import InternalTooth
from .rack_tooth import RackTooth
from .toothing import Toothing

_ROUNDING = 1e-14  # of a radius: what arcs on it are computed to
_NOTABLE = 1e-3  # modules: the proportions of basic racks are rounded to so much


@dataclass(frozen=True, kw_only=True)
class Mesh(ABC):
    """A pinion and its mate at a distance. Lengths in one unit, angles in radians, transverse section.

    The place of contact on the line of action is told by ρ₁, its distance from where that line touches the pinion's
    base circle. Source: ISO 21771, ch. 7.
    """

    pinion: ExternalTooth
    centre_distance: float

    @property
    @abstractmethod
    def working_pressure_angle(self) -> float:
        """α_wt."""

    @property
    @abstractmethod
    def _range_of_mate(self) -> tuple[float, float]:
        """ρ₁ between which the mate's flank lasts."""

    @property
    @abstractmethod
    def backlash(self) -> float:
        """j_wt, circumferential on the working circle; negative where teeth would jam."""

    @property
    @abstractmethod
    def clearances(self) -> tuple[float, float]:
        """From the pinion's tips to the mate's roots, and from the mate's tips to the pinion's roots."""

    @abstractmethod
    def specific_sliding(self, string: float) -> tuple[float, float]:
        """Sliding over rolling velocity on pinion and mate at ρ₁ > 0."""

    @property
    @abstractmethod
    def reference_distance(self) -> float:
        """The distance without profile shift."""

    @property
    def base_pitch(self) -> float:
        return self.pinion.toothing.base_pitch

    @property
    def working_radius(self) -> float:
        """r_w1 = r_b1/cos α_wt."""
        return float(self.pinion.toothing.base_radius / np.cos(self.working_pressure_angle))

    @property
    def normal_backlash(self) -> float:
        """j_bn = j_wt cos α_wt cos β_b."""
        leaning = np.cos(self.working_pressure_angle) * np.cos(self.pinion.toothing.base_helix_angle)
        return float(self.backlash * leaning)

    @cached_property
    def path(self) -> tuple[float, float]:
        """ρ₁ where contact begins and ends, on the involutes of both members."""
        toothing = self.pinion.toothing
        own = [toothing.base_radius * float(toothing.roll(r)) for r in self._radii_of_pinion]
        return max(own[0], self._range_of_mate[0]), min(own[1], self._range_of_mate[1])

    @property
    def _radii_of_pinion(self) -> tuple[float, float]:
        return self.pinion.form_radius, self.pinion.flank.usable_tip_radius

    @property
    def truncated(self) -> bool:
        """Whether the pinion's involute begins where the mate's tip has been already, by more than rounded racks do."""
        toothing = self.pinion.toothing
        begins = toothing.base_radius * float(toothing.roll(self.pinion.form_radius))
        return self._range_of_mate[0] < begins - _NOTABLE * toothing.module

    @property
    def contact_ratio(self) -> float:
        """ε_α, the length of the path of contact by the base pitch."""
        return max(0.0, self.path[1] - self.path[0]) / self.base_pitch


@dataclass(frozen=True, kw_only=True)
class GearMesh(Mesh):
    """A pinion with an external or internal gear."""

    gear: ExternalTooth | InternalTooth

    @property
    def _sign(self) -> int:
        return self.gear.toothing.outward

    @property
    def working_pressure_angle(self) -> float:
        bases = self.gear.toothing.base_radius + self._sign * self.pinion.toothing.base_radius
        return float(np.arccos(bases / self.centre_distance))

    @property
    def reference_distance(self) -> float:
        return self.gear.toothing.pitch_radius + self._sign * self.pinion.toothing.pitch_radius

    @property
    def between_tangents(self) -> float:
        """Distance a sin α_wt between the points where the line of action touches the base circles."""
        return float(self.centre_distance * np.sin(self.working_pressure_angle))

    def string_of_gear(self, string: float) -> float:
        """ρ₂ at ρ₁."""
        return self.between_tangents - self._sign * string

    @property
    def _range_of_mate(self) -> tuple[float, float]:
        toothing, gear = self.gear.toothing, self.gear
        ends = [
            toothing.base_radius * float(toothing.roll(r)) for r in (gear.flank.usable_tip_radius, gear.form_radius)
        ]
        first, last = (self._sign * (self.between_tangents - end) for end in ends)
        return first, last

    @property
    def backlash(self) -> float:
        radii = self.working_radius, self.gear.toothing.base_radius / np.cos(self.working_pressure_angle)
        teeth = (self.pinion.toothing, self.gear.toothing)
        thick = sum(one.thickness_at(radius) * radius for one, radius in zip(teeth, radii, strict=True))
        return _unless_rounding(float(2.0 * np.pi * radii[0] / teeth[0].teeth - thick), float(max(radii)))

    @property
    def clearances(self) -> tuple[float, float]:
        one, other, sign = self.pinion.toothing, self.gear.toothing, self._sign
        return (
            sign * (self.centre_distance - other.root_radius) - one.tip_radius,
            sign * (self.centre_distance - other.tip_radius) - one.root_radius,
        )

    def specific_sliding(self, string: float) -> tuple[float, float]:
        """ζ₁ = 1 − (ρ₂/ρ₁)(z₁/z₂) and ζ₂ = 1 − (ρ₁/ρ₂)(z₂/z₁), which is −∞ on the gear's base circle."""
        faster = self.string_of_gear(string) / string * self.pinion.toothing.teeth / self.gear.toothing.teeth
        return 1.0 - faster, 1.0 - 1.0 / faster if faster else -np.inf


@dataclass(frozen=True, kw_only=True)
class RackMesh(Mesh):
    """A pinion with a rack; the distance is from the pinion's axis to the rack's pitch plane."""

    rack: RackTooth

    @property
    def working_pressure_angle(self) -> float:
        return self.pinion.toothing.transverse_pressure_angle

    @property
    def reference_distance(self) -> float:
        return self.pinion.toothing.pitch_radius

    @property
    def offset(self) -> float:
        """How far the rack's pitch plane is outside the pinion's pitch circle."""
        return self.centre_distance - self.reference_distance

    @property
    def _range_of_mate(self) -> tuple[float, float]:
        sine = np.sin(self.working_pressure_angle)
        at_pitch = self.pinion.toothing.pitch_radius * sine
        heights = self.offset - self.rack.addendum, self.offset + self.rack.space.side_end[1]
        return float(at_pitch + heights[0] / sine), float(at_pitch + heights[1] / sine)

    @property
    def backlash(self) -> float:
        toothing = self.pinion.toothing
        left = toothing.circular_pitch - toothing.thickness - 2.0 * self.rack.half_thickness(self.offset)
        return _unless_rounding(float(left), self.centre_distance)

    @property
    def clearances(self) -> tuple[float, float]:
        toothing = self.pinion.toothing
        return (
            self.centre_distance + self.rack.dedendum - toothing.tip_radius,
            self.centre_distance - self.rack.addendum - toothing.root_radius,
        )

    def specific_sliding(self, string: float) -> tuple[float, float]:
        """ζ₁ = 1 − r sin α/ρ₁ and ζ₂ = 1 − ρ₁/(r sin α): the rack's contact moves with one velocity."""
        faster = self.pinion.toothing.pitch_radius * np.sin(self.working_pressure_angle) / string
        return float(1.0 - faster), float(1.0 - 1.0 / faster)


def _unless_rounding(backlash: float, radius: float) -> float:
    """A backlash, or exactly 0 where it is no more than the rounding of arcs on that radius."""
    return backlash if abs(backlash) > _ROUNDING * radius else 0.0


def distance_of_shifts(pinion: Toothing, gear: Toothing) -> float | None:
    """The centre distance without backlash at which the profile shifts let the gears run; None where there is none.

    inv α_wt = inv α_t + 2 tan α_n (x₁ + x₂)/(z₁ ± z₂), a = (r_b2 ± r_b1)/cos α_wt; − in an internal pair.
    """
    sign = gear.outward
    shifts = pinion.profile_shift + gear.profile_shift
    teeth = pinion.teeth + sign * gear.teeth
    if not shifts:
        return gear.pitch_radius + sign * pinion.pitch_radius
    turned = float(involute_function(pinion.transverse_pressure_angle))
    target = turned + 2.0 * np.tan(pinion.pressure_angle) * shifts / teeth
    if target <= 0.0:
        return None
    working = float(inverse_involute_function(target))
    return float((gear.base_radius + sign * pinion.base_radius) / np.cos(working))


def least_sum_of_shifts(pinion: Toothing, gear: Toothing) -> float:
    """The sum x₁ + x₂ of profile shifts at which the base circles touch; of an internal pair, the largest sum."""
    teeth = pinion.teeth + gear.outward * gear.teeth
    turned = float(involute_function(pinion.transverse_pressure_angle))
    return float(-turned * teeth / (2.0 * np.tan(pinion.pressure_angle)))


def shifts_of_distance(pinion: Toothing, gear: Toothing, distance: float) -> float | None:
    """The sum x₁ + x₂ of profile shifts that runs without backlash at a centre distance; None where none does."""
    sign = gear.outward
    bases = gear.base_radius + sign * pinion.base_radius
    if distance <= bases:
        return None
    working = float(np.arccos(bases / distance))
    wider = float(involute_function(working) - involute_function(pinion.transverse_pressure_angle))
    return float(wider * (pinion.teeth + sign * gear.teeth) / (2.0 * np.tan(pinion.pressure_angle)))

"""Pairs of gears on parallel axes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import ParameterError
from ...parameters import Problems, Size, declared, member_value
from .. import declarations as d
from .. import refusals
from ..element import Element
from ..following import Following
from ..pair import Pair
from ..standards.iso_53 import BASIC_RACKS
from .centre_distance import AxesOfGears, AxisOverRack
from .cylindrical_gear import CylindricalGear
from .external_gear import ExternalGear
from .helical_gear import HelicalGear
from .helix import Helix, require_one_module
from .herringbone_gear import HerringboneGear
from .internal_gear import InternalGear
from .mesh import GearMesh, Mesh, RackMesh, least_sum_of_shifts
from .mesh_checks import check_mesh
from .mesh_sizes import mesh_remarks, mesh_sizes
from .placing import gears_in_mesh, pinion_on_rack, rack_following
from .rack import Rack
from .sharing import second_values_without_use, values_of_member
from .spur_gear import SpurGear
from .toothing import Toothing

MEMBERS: dict[str, tuple[type[ExternalGear], type[CylindricalGear | Rack]]] = {
    "spur": (SpurGear, SpurGear),
    "helical": (HelicalGear, HelicalGear),
    "herringbone": (HerringboneGear, HerringboneGear),
    "internal": (HelicalGear, InternalGear),
    "rack": (HelicalGear, Rack),
}
"""What pinion and gear of each kind of pair are; a helical pinion of helix angle 0 is a spur gear."""

_HELICAL = {"kind": ("helical", "herringbone", "internal", "rack")}
_SETTLED = ("module", "hand")
_MOST_SHIFT = 2.0  # modules: no tooth has room for more
_OF_THE_AXES = (
    "kind", "teeth", "module", "transverse_module", "diametral_pitch", "pressure_angle", "helix_angle",
    "profile_shift", "centre_distance", "length_unit",
)  # fmt: skip


@dataclass(frozen=True, kw_only=True, repr=False)
class GearPair(Pair):
    """Two gears on parallel axes, or a pinion and a rack, in mesh.

    teeth             pinion first; what is given once holds for both members
    kind              of the gear: "spur", "helical", "herringbone", "internal" or "rack"
    helix_angle       0 if not given, for an internal pair or a rack and pinion
    hand              of the pinion; its mate has the other one, in an internal pair the same
    profile_shift     0 if neither it nor the centre distance is given
    centre_distance   of the axes, or from the pinion's axis to the rack's pitch plane. Without profile shifts
                      their sum follows from it, half for each member (a rack has none); with them the pair runs at
                      that distance with the backlash that this makes

    Frame: pinion axis z through the origin, the gear's axis (the rack's pitch plane) at +x; that of an internal gear
    at −x. Raises ParameterError with every problem found. Source: ISO 21771.
    """

    kind: str = declared(d.PAIR_KIND, default="spur")
    teeth: tuple[int, int] = declared(d.TEETH, members="each")
    module: float | None = declared(d.MODULE, default=None)
    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None, only=_HELICAL)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    face_width: float | tuple[float, float] = declared(d.FACE_WIDTH, members="both")
    pressure_angle: float = declared(d.NORMAL_PRESSURE_ANGLE, default=20.0)
    helix_angle: float | None = declared(d.HELIX_ANGLE, default=None, only=_HELICAL)
    hand: str = declared(d.HELIX_HAND, default="right", only=_HELICAL)
    profile_shift: float | tuple[float, float] | None = declared(d.PROFILE_SHIFT, default=None, members="both")
    centre_distance: float | None = declared(d.CENTRE_DISTANCE, default=None)
    basic_rack: str = declared(d.BASIC_RACK, default="iso-53-a")
    addendum: float | tuple[float, float] | None = declared(d.ADDENDUM, default=None, members="both")
    addendum_coefficient: float | tuple[float, float] | None = declared(
        d.ADDENDUM_COEFFICIENT, default=None, members="both"
    )
    dedendum: float | tuple[float, float] | None = declared(d.DEDENDUM, default=None, members="both")
    dedendum_coefficient: float | tuple[float, float] | None = declared(
        d.DEDENDUM_COEFFICIENT, default=None, members="both"
    )
    tip_diameter: tuple[float, float] | None = declared(
        d.TIP_DIAMETER, default=None, members="both", only={"kind": ("spur", "helical", "herringbone", "internal")}
    )
    tip_shortening: str = declared(d.TIP_SHORTENING, default="full")
    circular_thickness: float | tuple[float, float] | None = declared(
        d.CIRCULAR_THICKNESS, default=None, members="both"
    )
    backlash: float = declared(d.BACKLASH, default=0.0)
    root: str = declared(d.GEAR_ROOT, default="fillet")
    rack_tip_radius: float | tuple[float, float] | None = declared(d.RACK_TIP_RADIUS, default=None, members="both")
    rack_tip_coefficient: float | tuple[float, float] | None = declared(
        d.RACK_TIP_COEFFICIENT, default=None, members="both"
    )
    fillet_radius: float | None = declared(d.FILLET_RADIUS, default=None, only={"kind": ("internal", "rack")})
    tip_relief: float | tuple[float, float] = declared(d.TIP_RELIEF, default=0.0, members="both")
    tip_relief_height: float | tuple[float, float] | None = declared(d.TIP_RELIEF_HEIGHT, default=None, members="both")
    tip_relief_form: str = declared(d.TIP_RELIEF_FORM, default="linear")
    tip_chamfer: float | tuple[float, float] = declared(d.TIP_CHAMFER, default=0.0, members="both")
    crowning: float | tuple[float, float] = declared(d.CROWNING, default=0.0, members="both")
    bore: float | tuple[float, float] | None = declared(d.BORE, default=None, members="both")
    keyway: str | tuple[str, str] | None = declared(d.KEYWAY, default=None, members="both")
    keyway_width: float | tuple[float, float] | None = declared(d.KEYWAY_WIDTH, default=None, members="both")
    keyway_depth: float | tuple[float, float] | None = declared(d.KEYWAY_DEPTH, default=None, members="both")
    hub_diameter: float | tuple[float, float] | None = declared(d.HUB_DIAMETER, default=None, members="both")
    hub_length: float | tuple[float, float] | None = declared(d.HUB_LENGTH, default=None, members="both")
    hub_offset: float | tuple[float, float] = declared(d.HUB_OFFSET, default=0.0, members="both")
    rim_diameter: float | tuple[float, float] | None = declared(d.RIM_DIAMETER, default=None, members="both")
    web_thickness: float | tuple[float, float] | None = declared(d.WEB_THICKNESS, default=None, members="both")
    web_holes: int | tuple[int, int] | None = declared(d.WEB_HOLES, default=None, members="both")
    web_hole_diameter: float | tuple[float, float] | None = declared(d.WEB_HOLE_DIAMETER, default=None, members="both")
    web_hole_circle: float | tuple[float, float] | None = declared(d.WEB_HOLE_CIRCLE, default=None, members="both")
    outer_diameter: float | None = declared(d.OUTER_DIAMETER, default=None, only={"kind": ("internal",)})
    rack_height: float | None = declared(d.RACK_HEIGHT, default=None, only={"kind": ("rack",)})
    pin_diameter: float | tuple[float, float] | None = declared(d.PIN_DIAMETER, default=None, members="both")
    span_teeth: int | tuple[int, int] | None = declared(d.SPAN_TEETH, default=None, members="both")
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_module(problems, self)
        if self.kind in ("helical", "herringbone") and self.helix_angle is None:
            problems.add("helix_angle", f"is needed: {d.HELIX_ANGLE.meaning}")
        if problems.counted() and problems.sound("kind"):
            self._check_shared(problems)
        ready = problems.counted() and problems.computable(*_OF_THE_AXES) and problems.sound("kind", "teeth", "module")
        if ready:
            self._check_axes(problems)
        if ready and problems.sound("teeth", "profile_shift", "centre_distance"):
            self._check_members(problems)
            if problems.sound():
                for name, message in check_mesh(self.mesh, self.length_unit):
                    problems.add("centre_distance" if self._shifts_follow else name, message)
        problems.raise_any()

    def _check_shared(self, problems: Problems) -> None:
        """Adds values that the gear has no use for, and face widths that do not go together."""
        for name in second_values_without_use(self, MEMBERS[self.kind][1]):
            problems.add(name, refusals.no_second(self.kind))
        widths = self.face_width
        if self.kind == "herringbone" and isinstance(widths, tuple) and widths[0] != widths[1]:
            problems.add("face_width", refusals.UNLIKE_HALVES)

    @property
    def _shifts_follow(self) -> bool:
        """Whether the profile shifts are what the centre distance needs."""
        return self.profile_shift is None and self.centre_distance is not None

    def _check_members(self, problems: Problems) -> None:
        """Adds problems of the members; where a profile shift is one that follows from the distance, of that."""
        settled = (*_SETTLED, "profile_shift") if self._shifts_follow else _SETTLED
        builds = {"pinion": lambda: self.pinion, "gear": self._gear_of_sound_pinion}
        problems.add_members(builds, settled)
        if self._shifts_follow and problems.sound():
            try:
                for build in builds.values():
                    build()
            except ParameterError:
                self._add_far_shift(problems)

    def _gear_of_sound_pinion(self) -> Element | None:
        """The gear; None for an internal one whose tips would have to clear a pinion that cannot be built."""
        if self.kind == "internal":
            try:
                _ = self.pinion
            except ParameterError:
                return None
        return self.gear

    def _add_far_shift(self, problems: Problems) -> None:
        largest = max(self.axes.shifts or (0.0, 0.0), key=abs)
        of = "the pinion" if self.kind == "rack" else "each"
        problems.add("centre_distance", refusals.far_shift(largest, of, self.axes.reference, self.length_unit))

    def _check_axes(self, problems: Problems) -> None:
        """Adds problems of where the axes are, before there are members."""
        if self.kind == "internal" and self.teeth[1] <= self.teeth[0]:
            problems.add("teeth", refusals.NO_ROOM_INSIDE)
        elif self.axes.shifts is None or (self.centre_distance is not None and self.axes.centre_distance is None):
            problems.add("centre_distance", refusals.near_axes(self.axes.least, self.length_unit))
        elif self.axes.centre_distance is None:
            limit = least_sum_of_shifts(*self.axes.members)
            problems.add("profile_shift", refusals.no_distance(limit, internal=self.kind == "internal"))
        elif self.profile_shift is None and max(map(abs, self.axes.shifts)) > _MOST_SHIFT:
            self._add_far_shift(problems)

    @cached_property
    def axes(self) -> AxesOfGears | AxisOverRack:
        """Where the axes are, and the profile shifts that go with it."""
        helix = Helix.of(self)
        angle = float(np.radians(self.pressure_angle))
        pinion, gear = (
            Toothing.basic(teeth, helix.normal_module, angle, helix.angle, internal=internal)
            for teeth, internal in zip(self.teeth, (False, self.kind == "internal"), strict=True)
        )
        shifts = self.profile_shift
        given = None if shifts is None else (member_value(shifts, 0) or 0.0, member_value(shifts, 1) or 0.0)
        if self.kind == "rack":
            return AxisOverRack(pinion=pinion, given=given, distance=self.centre_distance)
        return AxesOfGears(pinion=pinion, gear=gear, given=given, distance=self.centre_distance)

    def _values(self, member: int) -> dict[str, Any]:
        """The parameters of a member that are this pair's own."""
        values = values_of_member(self, member, MEMBERS[self.kind][member])
        if "helix_angle" in values:
            values["helix_angle"] = self.helix_angle or 0.0
        if "profile_shift" in values:
            values["profile_shift"] = (self.axes.shifts or (0.0, 0.0))[member]
        return values

    @cached_property
    def pinion(self) -> ExternalGear:
        """The first member, in its own frame."""
        values = self._values(0)
        return MEMBERS[self.kind][0](**self._shortened(values))

    @cached_property
    def gear(self) -> CylindricalGear | Rack:
        """The second member, in its own frame."""
        values = self._values(1)
        if "hand" in values and self.kind != "internal":
            values["hand"] = "left" if self.hand == "right" else "right"
        if self.kind == "internal":
            return InternalGear(**self._clear_of_the_pinion(values))
        return MEMBERS[self.kind][1](**(values if self.kind == "rack" else self._shortened(values)))

    def _shortened(self, values: dict[str, Any]) -> dict[str, Any]:
        """A member's parameters with its tips shortened so that the clearance stays."""
        k = self.axes.shortening
        if not k or not self._shortens(values):
            return values
        addendum = self._asked_addendum(values) + k * self.axes.pinion.module
        changed = {**values, "addendum_coefficient": None, "addendum": addendum}
        return changed if addendum > 0.0 else values  # so that the member tells what is wrong

    def _clear_of_the_pinion(self, values: dict[str, Any]) -> dict[str, Any]:
        """An internal gear's parameters with its tips shortened so that they stay on the pinion's involutes."""
        axes = self.axes
        if not self._shortens(values) or not isinstance(axes, AxesOfGears):
            return values
        largest = axes.addendum_down_to(self.pinion.tooth.form_radius)
        if self._asked_addendum(values) <= largest or largest <= 0.0:
            return values
        return {**values, "addendum_coefficient": None, "addendum": largest}

    def _asked_addendum(self, values: dict[str, Any]) -> float:
        """A member's addendum by its coefficient and profile shift, before tips are shortened."""
        coefficient = values["addendum_coefficient"] or BASIC_RACKS[self.basic_rack].addendum
        return float((coefficient + values["profile_shift"]) * self.axes.pinion.module)

    def _shortens(self, values: dict[str, Any]) -> bool:
        """Whether a member's tips are free to be shortened."""
        own = values["addendum"] is not None or values.get("tip_diameter") is not None
        return self.tip_shortening == "full" and not own

    @cached_property
    def mesh(self) -> Mesh:
        """Both members' teeth at their distance."""
        distance = self.axes.centre_distance or self.axes.reference
        if isinstance(self.gear, Rack):
            return RackMesh(pinion=self.pinion.tooth, rack=self.gear.tooth, centre_distance=distance)
        return GearMesh(pinion=self.pinion.tooth, gear=self.gear.tooth, centre_distance=distance)

    @property
    def overlap(self) -> float:
        """ε_β = b sin β/(π m_n) of the common face width, of either half of herringbone teeth."""
        width = min(self.pinion.face_width, self.gear.face_width) / (2.0 if self.kind == "herringbone" else 1.0)
        return float(width * np.sin(self.pinion.helix.angle) / (np.pi * self.pinion.normal_module))

    def placements(self, turn: float = 0.0) -> tuple[Array, Array]:
        """Rigid motions (4, 4) of pinion and gear into mesh, with the pinion turned by so many degrees.

        At turn 0 the pinion's first tooth points at +x, into the middle of a space of its mate.
        """
        angle = float(np.radians(turn))
        distance = self.mesh.centre_distance
        if isinstance(self.gear, Rack):
            pitch = self.gear.tooth.circular_pitch
            return pinion_on_rack(self.pinion.pitch_radius, distance, self.teeth[1], pitch, angle)
        return gears_in_mesh(self.teeth, distance, angle, internal=self.kind == "internal")

    @property
    def following(self) -> Following:
        """How the gear follows the pinion: opposite outside, the same way inside; a rack until the teeth end."""
        if isinstance(self.gear, Rack):
            return rack_following(self.pinion.pitch_radius, self.teeth[1], self.gear.tooth.circular_pitch)
        sign = 1.0 if self.kind == "internal" else -1.0
        return Following(ratio=sign * self.teeth[0] / self.teeth[1])

    @property
    def remarks(self) -> list[str]:
        """What is unusual about the pair, though it can be built."""
        members = dict.fromkeys([*self.pinion.remarks, *self.gear.remarks])
        return [*members, *mesh_remarks(self.mesh, self.overlap)]

    @property
    def description(self) -> str:
        """A few words that tell this pair from others."""
        helix = f", β = {self.helix_angle:g}°" if self.helix_angle else ""
        distance = f"a = {self.mesh.centre_distance:.5g} {self.length_unit}"
        return f"{self.teeth[0]}/{self.teeth[1]} teeth, {self.kind}{helix}, {distance}"

    def sizes(self) -> dict[str, Size]:
        """Sizes of the pair; each member has its own."""
        return mesh_sizes(self.mesh, self.overlap, self.axes.shifts or (0.0, 0.0))

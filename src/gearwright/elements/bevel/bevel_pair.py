"""A pair of bevel gears."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...parameters import Problems, Size, declared, member_value
from .. import declarations as d
from .. import remarks
from ..element import module_in, require_one_pitch
from ..following import Following
from ..pair import Pair
from ..standards.bevels.proportions import Pair as Proportions
from .bevel_gear import BevelGear
from .meshing import contact_ratio, meshing_placements
from .pair_checks import check_engagement, check_pair, given_by
from .pair_sizes import bevel_pair_sizes
from .pitch_cone import pitch_cone_angle
from .sizing import EXPLICIT, ISO, SHIFTED, SYSTEMS, TAPERED, Sizing, design_of, explicit, is_sized, taper_of
from .spiral import HOBBED, MILLED
from .spiral_checks import require_spiral
from .tooth import BevelTooth

_FROM_THE_PAIR = ("pitch_angle", "mate_teeth")


@dataclass(frozen=True, kw_only=True, repr=False)
class BevelPair(Pair):
    """A bevel pinion and gear on intersecting axes, pinion first.

    Sizing is explicit, as Al-Daccak 1989 has it: working depth (default two modules), whole depth
    (default 2.25 modules) and the gear's addendum (default half the working depth), at the outer end;
    or by a standard, which settles these, the thicknesses and the angles of tip and root cones.
    Both members share the cone distance; the gear has the other hand. Raises ParameterError with every
    problem of both members and of their engagement.
    """

    teeth: tuple[int, int] = declared(d.TEETH, members="each")
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    shaft_angle: float = declared(d.SHAFT_ANGLE, default=90.0)
    face_width: float = declared(d.FACE_WIDTH)
    standard: str = declared(d.BEVEL_STANDARD, default="explicit")
    taper: str | None = declared(d.DEPTH_TAPER, default=None, only={"standard": TAPERED})
    iso_method: int | None = declared(d.ISO_METHOD, default=None, only={"standard": ISO})
    profile_shift: float | None = declared(d.BEVEL_SHIFT, default=None, only={"standard": SHIFTED})
    thickness_modification: float | None = declared(d.THICKNESS_MODIFICATION, default=None, only={"standard": SYSTEMS})
    working_depth: float | None = declared(d.WORKING_DEPTH, default=None, only={"standard": EXPLICIT})
    whole_depth: float | None = declared(d.WHOLE_DEPTH, default=None, only={"standard": EXPLICIT})
    gear_addendum: float | None = declared(d.GEAR_ADDENDUM, default=None, only={"standard": EXPLICIT})
    pressure_angle: float = declared(d.BEVEL_PRESSURE_ANGLE, default=20.0)
    tooth_form: str | tuple[str, str] = declared(d.TOOTH_FORM, default="involute", members="both")
    circular_thickness: float | tuple[float, float] | None = declared(
        d.CIRCULAR_THICKNESS, default=None, members="both"
    )
    backlash: float = declared(d.BACKLASH, default=0.0)
    normal_backlash: float | None = declared(d.NORMAL_BACKLASH, default=None)
    root: str | tuple[str, str] = declared(d.ROOT, default="fillet", members="both")
    crown_tip_radius: float | tuple[float, float] | None = declared(d.CROWN_TIP_RADIUS, default=None, members="both")
    tip_relief: float | tuple[float, float] = declared(d.TIP_RELIEF, default=0.0, members="both")
    tip_relief_height: float | tuple[float, float] | None = declared(
        d.BEVEL_TIP_RELIEF_HEIGHT, default=None, members="both"
    )
    tip_relief_form: str | tuple[str, str] = declared(d.TIP_RELIEF_FORM, default="linear", members="both")
    profile_crowning: float | tuple[float, float] = declared(d.PROFILE_CROWNING, default=0.0, members="both")
    crowning: float | tuple[float, float] = declared(d.CROWNING, default=0.0, members="both")
    trace: str = declared(d.TRACE, default="straight")
    spiral_angle: float = declared(d.SPIRAL_ANGLE, default=0.0)
    cutter_radius: float | None = declared(d.CUTTER_RADIUS, default=None, only={"trace": MILLED})
    blade_groups: int | None = declared(d.BLADE_GROUPS, default=None, only={"trace": HOBBED})
    hand: str = declared(d.HAND, default="right")
    ends: str | tuple[str, str] = declared(d.BEVEL_ENDS, default="conical", members="both")
    bore: float | tuple[float, float] | None = declared(d.BORE, default=None, members="both")
    keyway: str | tuple[str, str] | None = declared(d.KEYWAY, default=None, members="both")
    keyway_width: float | tuple[float, float] | None = declared(d.KEYWAY_WIDTH, default=None, members="both")
    keyway_depth: float | tuple[float, float] | None = declared(d.KEYWAY_DEPTH, default=None, members="both")
    mounting_distance: float | tuple[float, float] | None = declared(d.MOUNTING_DISTANCE, default=None, members="both")
    hub_diameter: float | tuple[float, float] | None = declared(d.HUB_DIAMETER, default=None, members="both")
    hub_length: float | tuple[float, float] | None = declared(d.BEVEL_HUB_LENGTH, default=None, members="both")
    rim_diameter: float | tuple[float, float] | None = declared(d.RIM_DIAMETER, default=None, members="both")
    web_thickness: float | tuple[float, float] | None = declared(d.BEVEL_WEB_THICKNESS, default=None, members="both")
    web_holes: int | tuple[int, int] | None = declared(d.WEB_HOLES, default=None, members="both")
    web_hole_diameter: float | tuple[float, float] | None = declared(d.WEB_HOLE_DIAMETER, default=None, members="both")
    web_hole_circle: float | tuple[float, float] | None = declared(d.WEB_HOLE_CIRCLE, default=None, members="both")
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_pitch(problems, self.module, self.diametral_pitch)
        if problems.counted() and check_pair(problems, self) and is_sized(problems, self):
            members = {"pinion": lambda: self.pinion, "gear": lambda: self.gear}
            problems.add_members(members, settled=_FROM_THE_PAIR, said_here=given_by(self))
        require_spiral(problems, self)
        if problems.sound():
            check_engagement(problems, self)
        problems.raise_any()

    @property
    def outer_module(self) -> float:
        """m_et, in the length unit."""
        return module_in(self.length_unit, self.module, self.diametral_pitch)

    @property
    def outer_working_depth(self) -> float:
        """As given, two modules, or what a standard makes it."""
        if self.standard != "explicit":
            return sum(one.addendum for one in self.proportions)
        return 2.0 * self.outer_module if self.working_depth is None else self.working_depth

    @property
    def outer_whole_depth(self) -> float:
        """As given, 2.25 modules, or what a standard makes it."""
        if self.standard != "explicit":
            return self.proportions[0].depth
        return 2.25 * self.outer_module if self.whole_depth is None else self.whole_depth

    @property
    def explicit_gear_addendum(self) -> float:
        """As given, or half the working depth."""
        return self.outer_working_depth / 2.0 if self.gear_addendum is None else self.gear_addendum

    @cached_property
    def pitch_cone_angles(self) -> tuple[float, float]:
        """δ₁, δ₂, radians."""
        z1, z2 = self.teeth
        shaft = float(np.radians(self.shaft_angle))
        return pitch_cone_angle(z1, z2, shaft), pitch_cone_angle(z2, z1, shaft)

    @property
    def cone_distance(self) -> float:
        """R_e."""
        return float(self.teeth[0] * self.outer_module / (2.0 * np.sin(self.pitch_cone_angles[0])))

    @cached_property
    def proportions(self) -> Proportions:
        """Of both members, their thickness before backlash. Raises ParameterError where a standard has none."""
        if self.standard != "explicit":
            return Sizing.of(self).proportions(design_of(self, self.teeth, float(np.radians(self.shaft_angle))))
        second = self.explicit_gear_addendum
        addenda = (self.outer_working_depth - second, second)
        thickness, taper = np.pi * self.outer_module / 2.0, taper_of(self.taper)
        one, other = (
            explicit(height, self.outer_whole_depth - height, thickness, self.cone_distance, taper)
            for height in addenda
        )
        return one, other

    @property
    def clearance(self) -> float:
        """Least from a tip to the mate's root, at the outer and the inner end, length."""
        width = self.face_width
        return min(
            float(roots.dedendum - tips.addendum - s * (np.tan(roots.dedendum_angle) - np.tan(tips.addendum_angle)))
            for tips, roots in (self.proportions, self.proportions[::-1])
            for s in (0.0, width)
        )

    def _member(self, member: int) -> BevelGear:
        """A member whose sizes are explicit: what a standard settled is handed on."""
        own = {field.name for field in fields(BevelGear)} & {field.name for field in fields(self)}
        values = {name: member_value(getattr(self, name), member) for name in own - _SETTLED}
        shape = self.proportions[member]
        if self.standard != "explicit":
            transverse = np.tan(np.radians(self.pressure_angle)) / np.cos(np.radians(self.spiral_angle))
            values["pressure_angle"] = float(np.degrees(np.arctan(transverse)))
            values["circular_thickness"] = values["circular_thickness"] or shape.thickness
        return self._with_fitting_tip(
            BevelGear(
                **{
                    **values,
                    "mate_teeth": self.teeth[1 - member],
                    "addendum": shape.addendum,
                    "dedendum": shape.dedendum,
                    "addendum_angle": float(np.degrees(shape.addendum_angle)),
                    "dedendum_angle": float(np.degrees(shape.dedendum_angle)),
                    "hand": self.hand if member == 0 else {"left": "right", "right": "left"}.get(self.hand, self.hand),
                }
            )
        )

    def _with_fitting_tip(self, gear: BevelGear) -> BevelGear:
        """The member with a crown tip radius, where none was given, that leaves room in the clearance.

        A corner of the crown gear's tip leaves its flank ρ(1 − sin a) above its own tip.
        """
        if gear.root != "fillet" or gear.crown_tip_radius is not None:
            return gear
        room = self.clearance / (1.0 - float(np.sin(gear.transverse_pressure_angle)))
        return gear if gear.generating_tip_radius <= room else replace(gear, crown_tip_radius=max(room, 0.0) or None)

    @cached_property
    def pinion(self) -> BevelGear:
        """The first member, in its own frame."""
        return self._member(0)

    @cached_property
    def gear(self) -> BevelGear:
        """The second member, in its own frame."""
        return self._member(1)

    def teeth_on_sphere(self, distance: float) -> tuple[BevelTooth, BevelTooth]:
        """The teeth of both members at a distance from the apex, as they meet there."""
        return (
            self.pinion.bevel_teeth.on_spheres().tooth(distance),
            self.gear.bevel_teeth.on_spheres().tooth(distance),
        )

    @property
    def remarks(self) -> list[str]:
        """What is unusual about the pair, though it can be built."""
        unit = self.length_unit
        return [
            *remarks.wide_face(self.face_width, self.cone_distance, unit),
            *remarks.unusual_depth("working_depth", self.outer_working_depth, self.outer_module, unit, 2),
            *dict.fromkeys([*self.pinion.tooth_remarks, *self.gear.tooth_remarks]),
            *remarks.low_contact_ratio(contact_ratio(*self.teeth_on_sphere(self.pinion.mean_distance))),
        ]

    @property
    def description(self) -> str:
        """A few words that tell this pair from others."""
        spiral = "straight" if self.trace == "straight" else f"{self.trace} spiral {self.spiral_angle:g}°"
        return f"{self.teeth[0]}/{self.teeth[1]} teeth, {spiral}, Σ = {self.shaft_angle:g}°"

    def placements(self, turn: float = 0.0) -> tuple[Array, Array]:
        """Rigid motions (4, 4) of pinion and gear into mesh, with the pinion turned by so many degrees.

        Common apex at the origin, pinion axis +z, gear axis at the shaft angle towards +x.
        """
        return meshing_placements(np.radians(self.shaft_angle), *self.teeth, np.radians(turn))

    @property
    def following(self) -> Following:
        """Seen from the apex, or from behind both, pinion and gear turn opposite ways."""
        return Following(ratio=-self.teeth[0] / self.teeth[1])

    def sizes(self) -> dict[str, Size]:
        """Sizes of the pair; each member has its own."""
        return bevel_pair_sizes(self)


_SETTLED = {"standard", "taper", "iso_method", "profile_shift", "thickness_modification", "hand"}
"""What a member has otherwise than its pair."""

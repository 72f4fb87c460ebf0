"""A pair of bevel gears."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...parameters import Problems, Size, declared, member_value, rounded_down
from .. import declarations as d
from .. import refusals, remarks
from ..element import module_in, require_angle_of_trace, require_one_pitch
from ..pair import Pair
from ..standards.bevels.design import BevelDesign
from ..standards.bevels.proportions import Pair as Proportions
from .bevel_gear import BevelGear
from .meshing import contact_ratio, interference_limit, meshing_placements
from .pitch_cone import pitch_cone_angle, require_cone
from .sizing import EXPLICIT, SHIFTED, SYSTEMS, require_standard, standard_proportions, unbuilt_taper

_OF_THE_CONES = ("teeth", "module", "diametral_pitch", "shaft_angle", "length_unit")
_OF_THE_DEPTHS = ("working_depth", "whole_depth", "gear_addendum")
_OF_THE_STANDARD = (
    *("standard", "profile_shift", "thickness_modification"),
    *("face_width", "pressure_angle", "trace", "spiral_angle"),
)


@dataclass(frozen=True, kw_only=True)
class BevelPair(Pair):
    """A bevel pinion and gear on intersecting axes, pinion first.

    Sizing is explicit, as Al-Daccak 1989 has it: working depth (default two modules), whole depth
    (default 2.25 modules) and the gear's addendum (default half the working depth), at the outer end;
    or by a standard, which settles these and the thicknesses (elements/standards/bevels).
    Both members share the cone distance; the gear has the other hand. Raises ParameterError with every
    problem of both members and of their engagement.
    """

    teeth: tuple[int, int] = declared(d.TEETH, members="each")
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    shaft_angle: float = declared(d.SHAFT_ANGLE, default=90.0)
    face_width: float = declared(d.FACE_WIDTH)
    standard: str = declared(d.BEVEL_STANDARD, default="explicit")
    working_depth: float | None = declared(d.WORKING_DEPTH, default=None, only={"standard": EXPLICIT})
    whole_depth: float | None = declared(d.WHOLE_DEPTH, default=None, only={"standard": EXPLICIT})
    gear_addendum: float | None = declared(d.GEAR_ADDENDUM, default=None, only={"standard": EXPLICIT})
    profile_shift: float | None = declared(d.BEVEL_SHIFT, default=None, only={"standard": SHIFTED})
    thickness_modification: float | None = declared(d.THICKNESS_MODIFICATION, default=None, only={"standard": SYSTEMS})
    pressure_angle: float = declared(d.PRESSURE_ANGLE, default=20.0)
    circular_thickness: float | tuple[float, float] | None = declared(
        d.CIRCULAR_THICKNESS, default=None, members="both"
    )
    backlash: float = declared(d.BACKLASH, default=0.0)
    bore: float | tuple[float, float] | None = declared(d.BORE, default=None, members="both")
    trace: str = declared(d.TRACE, default="straight")
    spiral_angle: float = declared(d.SPIRAL_ANGLE, default=0.0)
    hand: str = declared(d.HAND, default="right")
    root: str = declared(d.ROOT, default="radial")
    ends: str = declared(d.BEVEL_ENDS, default="spherical")
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_pitch(problems, self.module, self.diametral_pitch)
        require_angle_of_trace(problems, self.trace, self.spiral_angle)
        computable = (
            problems.counted() and problems.computable(*_OF_THE_CONES, *_OF_THE_DEPTHS) and problems.sound("module")
        )
        computable = computable and self._check_cones(problems) and self._check_standard(problems)
        if computable and self._check_depths(problems):
            members = {"pinion": lambda: self.pinion, "gear": lambda: self.gear}
            problems.add_members(members, settled=("mate_teeth",))
        if problems.sound():
            self._check_engagement(problems)
        problems.raise_any()

    def _check_cones(self, problems: Problems) -> bool:
        require_cone(problems, *self._pitch_cone_angles)
        return problems.sound("shaft_angle")

    def _check_standard(self, problems: Problems) -> bool:
        if self.standard == "explicit":
            return True
        if not problems.computable(*_OF_THE_STANDARD):
            return False
        require_standard(problems, self.standard, self.spiral_angle)
        if self.face_width >= self._cone_distance:
            problems.add("face_width", refusals.wide_face(self._cone_distance, self.length_unit))
        return problems.sound(*_OF_THE_CONES, *_OF_THE_STANDARD)

    def _check_depths(self, problems: Problems) -> bool:
        unit = self.length_unit
        if self._whole_depth <= self._working_depth:
            problems.add(
                "whole_depth",
                f"must be greater than the working depth, {self._working_depth:.4g} {unit}; "
                "their difference is the clearance at the root",
            )
        if self._gear_addendum >= self._working_depth:
            problems.add(
                "gear_addendum",
                f"less than the working depth, {self._working_depth:.4g} {unit}; the rest is the pinion's addendum",
            )
        return problems.sound("whole_depth", "gear_addendum")

    def _check_engagement(self, problems: Problems) -> None:
        unit, members = self.length_unit, (self.pinion, self.gear)
        for member, mate, name in zip(members, members[::-1], ("pinion", "gear"), strict=True):
            limit = interference_limit(member.tooth, mate.tooth)
            if member.face_angle > limit + 1e-12:
                most = member.cone_distance * np.tan(limit - member.pitch_cone_angle)
                problems.add(
                    "standard" if self._settled else "gear_addendum" if name == "gear" else "working_depth",
                    f"interference: the {name}'s tip, {member.outer_addendum:.4g} {unit} above its pitch cone, "
                    f"would meet its mate below the base cone; at most {rounded_down(most)} {unit} for that addendum "
                    "(more teeth or a larger pressure angle allow more)",
                )
        pitch = np.pi * self.pinion.outer_module
        thickness = self.pinion.outer_thickness + self.gear.outer_thickness
        if thickness > pitch * (1.0 + 1e-12):
            problems.add(
                "circular_thickness",
                f"interference: the two teeth are together {thickness:.4g} {unit} thick and share a pitch of "
                f"{pitch:.4g} {unit}; make them thinner",
            )

    @property
    def _module(self) -> float:
        return module_in(self.length_unit, self.module, self.diametral_pitch)

    @cached_property
    def _settled(self) -> Proportions | None:
        """What a standard settles; None where sizes are explicit. The pressure angle is the transverse one."""
        if self.standard == "explicit":
            return None
        spiral = np.radians(self.spiral_angle)
        design = BevelDesign(
            teeth=self.teeth,
            module=self._module,
            shaft_angle=float(np.radians(self.shaft_angle)),
            face_width=self.face_width,
            pressure_angle=float(np.arctan(np.tan(np.radians(self.pressure_angle)) * np.cos(spiral))),
            spiral_angle=float(spiral),
        )
        return standard_proportions(
            self.standard,
            design,
            profile_shift=self.profile_shift,
            thickness_modification=self.thickness_modification or 0.0,
        )

    @property
    def _cone_distance(self) -> float:
        return float(self.teeth[0] * self._module / (2.0 * np.sin(self._pitch_cone_angles[0])))

    @property
    def _working_depth(self) -> float:
        if self._settled:
            return self._settled[0].addendum + self._settled[1].addendum
        return 2.0 * self._module if self.working_depth is None else self.working_depth

    @property
    def _whole_depth(self) -> float:
        if self._settled:
            return self._settled[0].depth
        return 2.25 * self._module if self.whole_depth is None else self.whole_depth

    @property
    def _gear_addendum(self) -> float:
        if self._settled:
            return self._settled[1].addendum
        return self._working_depth / 2.0 if self.gear_addendum is None else self.gear_addendum

    @cached_property
    def _pitch_cone_angles(self) -> tuple[float, float]:
        z1, z2 = self.teeth
        shaft = np.radians(self.shaft_angle)
        return pitch_cone_angle(z1, z2, shaft), pitch_cone_angle(z2, z1, shaft)

    def _member(self, member: int) -> BevelGear:
        addendum = (self._working_depth - self._gear_addendum, self._gear_addendum)[member]
        thickness = member_value(self.circular_thickness, member)
        if thickness is None and self._settled:
            thickness = self._settled[member].thickness
        other_hand = "left" if self.hand == "right" else "right"
        return BevelGear(
            teeth=self.teeth[member],
            module=self.module,
            diametral_pitch=self.diametral_pitch,
            mate_teeth=self.teeth[1 - member],
            shaft_angle=self.shaft_angle,
            face_width=self.face_width,
            addendum=addendum,
            dedendum=self._whole_depth - addendum,
            pressure_angle=self.pressure_angle,
            circular_thickness=thickness,
            backlash=self.backlash,
            bore=member_value(self.bore, member),
            trace=self.trace,
            spiral_angle=self.spiral_angle,
            hand=(self.hand, other_hand)[member],
            root=self.root,
            ends=self.ends,
            length_unit=self.length_unit,
        )

    @cached_property
    def pinion(self) -> BevelGear:
        """The first member, in its own frame."""
        return self._member(0)

    @cached_property
    def gear(self) -> BevelGear:
        """The second member, in its own frame."""
        return self._member(1)

    @property
    def remarks(self) -> list[str]:
        """What is unusual about the pair, though it can be built."""
        unit, built = self.length_unit, (self.pinion, self.gear)
        angles = (built[0].face_angle - built[0].pitch_cone_angle, built[1].face_angle - built[1].pitch_cone_angle)
        return [
            *(unbuilt_taper(self.standard, self._settled, angles) if self._settled else []),
            *remarks.wide_face(self.face_width, self.pinion.cone_distance, unit),
            *remarks.unusual_depth("working_depth", self._working_depth, self._module, unit, 2),
            *remarks.low_contact_ratio(contact_ratio(self.pinion.tooth, self.gear.tooth)),
        ]

    @property
    def description(self) -> str:
        """A few words that tell this pair from others."""
        spiral = f"{self.trace} spiral {self.spiral_angle:g}°" if self.spiral_angle else "straight"
        return f"{self.teeth[0]}/{self.teeth[1]} teeth, {spiral}, Σ = {self.shaft_angle:g}°"

    def placements(self, turn: float = 0.0) -> tuple[Array, Array]:
        """Rigid motions (4, 4) of pinion and gear into mesh, with the pinion turned by so many degrees.

        Common apex at the origin, pinion axis +z, gear axis at the shaft angle towards +x.
        """
        return meshing_placements(np.radians(self.shaft_angle), *self.teeth, np.radians(turn))

    def sizes(self) -> dict[str, Size]:
        """Sizes of the pair; each member has its own."""
        pinion, gear = self.pinion, self.gear
        limits = [float(np.degrees(interference_limit(a.tooth, b.tooth))) for a, b in ((pinion, gear), (gear, pinion))]
        return {
            "shaft_angle": Size(self.shaft_angle, "angle", "Σ", "angle between the axes"),
            "gear_ratio": Size(self.teeth[1] / self.teeth[0], "", "u", "teeth of the gear over teeth of the pinion"),
            "outer_module": Size(pinion.outer_module, "length", "m_et", "transverse module at the outer end"),
            "cone_distance": Size(pinion.cone_distance, "length", "R_e", "outer cone distance"),
            "working_depth": Size(self._working_depth, "length", "h_wk", "sum of the addenda, outer"),
            "whole_depth": Size(self._whole_depth, "length", "h_e", "addendum and dedendum of a member, outer"),
            "clearance": Size(self._whole_depth - self._working_depth, "length", "c", "from tip to mate's root, outer"),
            "contact_ratio": Size(contact_ratio(pinion.tooth, gear.tooth), "", "ε_α", "transverse contact ratio"),
            "pinion_face_angle_limit": Size(limits[0], "angle", "δ_a1max", "face angle at which interference begins"),
            "gear_face_angle_limit": Size(limits[1], "angle", "δ_a2max", "face angle at which interference begins"),
        }

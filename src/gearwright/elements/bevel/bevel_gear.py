"""One bevel gear."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from ...curves.traces.trace import Trace
from ...parameters import Problems, Size, declared
from ...sheets.content import Row
from ...sheets.views import View
from ...solids.solid import Solid
from ...solids.swept import Swept
from .. import declarations as d
from .. import remarks
from ..blanks.blank import Blank
from ..data_rows import bevel_rows
from ..element import SMOOTH, Element, module_in, require_one_pitch
from ..standards.bevels.member import BevelMember
from ..standards.bevels.proportions import Proportions
from .bevel_checks import check_cone, check_face, check_given, check_shape
from .bevel_sizes import bevel_sizes, outer_tip_thickness
from .bevel_views import bevel_views
from .body import BevelBody
from .depth_line import DepthLine
from .pitch_cone import pitch_cone_angle
from .sizing import EXPLICIT, ISO, SHIFTED, SYSTEMS, TAPERED, Sizing, design_of, explicit, is_sized, taper_of
from .spiral import HOBBED, MILLED, spiral_of
from .spiral_checks import require_spiral
from .teeth import BevelTeeth
from .tooth import BevelTooth
from .tooth_ends import ToothEnds

_USUAL_TIP = 0.25  # modules: what a clearance of 0.188 modules leaves room for
_LEAVES_LAND = 0.99  # of the largest tip radius that fits
_RELIEF_HEIGHT = 0.6  # modules


@dataclass(frozen=True, kw_only=True, repr=False)
class BevelGear(Element):
    """A bevel gear: teeth of exact form on the sphere, along any tooth trace, on a body with plane faces.

    Frame: apex at the origin, body on +z, first tooth centred on +x at the mean cone distance.
    The pitch cone is given by its half-angle, or by the mate's teeth and the shaft angle. Sizing is explicit: addendum
    (default one module), dedendum (default 1.25 modules) and circular thickness (default half the pitch) at the outer
    end; or by a standard, beside a mate. Raises ParameterError with every problem found.
    Source: Al-Daccak 1989, ch. 3, with the base cone sin γ_b = sin γ cos a that makes pairs conjugate; ISO 23509.
    """

    teeth: int = declared(d.TEETH)
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    mate_teeth: int | None = declared(d.MATE_TEETH, default=None)
    shaft_angle: float | None = declared(d.SHAFT_ANGLE, default=None)
    pitch_angle: float | None = declared(d.PITCH_ANGLE, default=None)
    face_width: float = declared(d.FACE_WIDTH)
    standard: str = declared(d.BEVEL_STANDARD, default="explicit")
    taper: str | None = declared(d.DEPTH_TAPER, default=None, only={"standard": TAPERED})
    iso_method: int | None = declared(d.ISO_METHOD, default=None, only={"standard": ISO})
    profile_shift: float | None = declared(d.BEVEL_SHIFT, default=None, only={"standard": SHIFTED})
    thickness_modification: float | None = declared(d.THICKNESS_MODIFICATION, default=None, only={"standard": SYSTEMS})
    addendum: float | None = declared(d.ADDENDUM, default=None, only={"standard": EXPLICIT})
    dedendum: float | None = declared(d.DEDENDUM, default=None, only={"standard": EXPLICIT})
    addendum_angle: float | None = declared(d.ADDENDUM_ANGLE, default=None, only={"standard": EXPLICIT})
    dedendum_angle: float | None = declared(d.DEDENDUM_ANGLE, default=None, only={"standard": EXPLICIT})
    pressure_angle: float = declared(d.BEVEL_PRESSURE_ANGLE, default=20.0)
    tooth_form: str = declared(d.TOOTH_FORM, default="involute")
    circular_thickness: float | None = declared(d.CIRCULAR_THICKNESS, default=None)
    backlash: float = declared(d.BACKLASH, default=0.0)
    normal_backlash: float | None = declared(d.NORMAL_BACKLASH, default=None)
    root: str = declared(d.ROOT, default="fillet")
    crown_tip_radius: float | None = declared(d.CROWN_TIP_RADIUS, default=None, only={"root": ("fillet",)})
    tip_relief: float = declared(d.TIP_RELIEF, default=0.0)
    tip_relief_height: float | None = declared(d.BEVEL_TIP_RELIEF_HEIGHT, default=None)
    tip_relief_form: str = declared(d.TIP_RELIEF_FORM, default="linear")
    profile_crowning: float = declared(d.PROFILE_CROWNING, default=0.0)
    crowning: float = declared(d.CROWNING, default=0.0)
    trace: str = declared(d.TRACE, default="straight")
    spiral_angle: float = declared(d.SPIRAL_ANGLE, default=0.0)
    cutter_radius: float | None = declared(d.CUTTER_RADIUS, default=None, only={"trace": MILLED})
    blade_groups: int | None = declared(d.BLADE_GROUPS, default=None, only={"trace": HOBBED})
    hand: str = declared(d.HAND, default="right")
    ends: str = declared(d.BEVEL_ENDS, default="conical")
    bore: float | None = declared(d.BORE, default=None)
    keyway: str | None = declared(d.KEYWAY, default=None)
    keyway_width: float | None = declared(d.KEYWAY_WIDTH, default=None)
    keyway_depth: float | None = declared(d.KEYWAY_DEPTH, default=None)
    mounting_distance: float | None = declared(d.MOUNTING_DISTANCE, default=None)
    hub_diameter: float | None = declared(d.HUB_DIAMETER, default=None)
    hub_length: float | None = declared(d.BEVEL_HUB_LENGTH, default=None)
    rim_diameter: float | None = declared(d.RIM_DIAMETER, default=None)
    web_thickness: float | None = declared(d.BEVEL_WEB_THICKNESS, default=None)
    web_holes: int | None = declared(d.WEB_HOLES, default=None)
    web_hole_diameter: float | None = declared(d.WEB_HOLE_DIAMETER, default=None)
    web_hole_circle: float | None = declared(d.WEB_HOLE_CIRCLE, default=None)
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_pitch(problems, self.module, self.diametral_pitch)
        check_cone(problems, self)
        check_given(problems, self)
        if check_face(problems, self) and is_sized(problems, self):
            check_shape(problems, self)
        require_spiral(problems, self)
        problems.raise_any()

    @property
    def smooth_tolerance(self) -> float:
        return SMOOTH * self.outer_module

    @cached_property
    def outer_module(self) -> float:
        """Module at the outer end, in the length unit."""
        return module_in(self.length_unit, self.module, self.diametral_pitch)

    @property
    def pitch_radius(self) -> float:
        return self.teeth * self.outer_module / 2.0

    @cached_property
    def pitch_cone_angle(self) -> float:
        """γ, radians: atan2(sin Σ, z₂/z₁ + cos Σ) where it follows from the mate."""
        if self.pitch_angle is not None:
            return float(np.radians(self.pitch_angle))
        return pitch_cone_angle(self.teeth, self.mate_teeth or self.teeth, self._shaft_angle)

    @property
    def _shaft_angle(self) -> float:
        return float(np.radians(90.0 if self.shaft_angle is None else self.shaft_angle))

    @property
    def cone_distance(self) -> float:
        """R_e, from the apex to the outer end of the pitch line."""
        return float(self.pitch_radius / np.sin(self.pitch_cone_angle))

    @property
    def inner_distance(self) -> float:
        return self.cone_distance - self.face_width

    @property
    def mean_distance(self) -> float:
        return self.cone_distance - self.face_width / 2.0

    @cached_property
    def transverse_pressure_angle(self) -> float:
        """a_t, radians; with a standard tan a_t = tan a_n/cos β_m."""
        angle = float(np.radians(self.pressure_angle))
        if self.standard == "explicit":
            return angle
        return float(np.arctan(np.tan(angle) / np.cos(np.radians(self.spiral_angle))))

    @cached_property
    def normal_pressure_angle(self) -> float:
        """a_n at mid-face, radians: tan a_n = tan a_t cos β_m."""
        return float(np.arctan(np.tan(self.transverse_pressure_angle) * np.cos(np.radians(self.spiral_angle))))

    @cached_property
    def proportions(self) -> Proportions:
        """Heights, their angles and the thickness before backlash, as given or as the standard has them."""
        if self.standard != "explicit":
            teeth = (self.teeth, self.mate_teeth or self.teeth)
            found = Sizing.of(self).proportions(design_of(self, teeth, self._shaft_angle))[0]
            return found if self.circular_thickness is None else replace(found, thickness=self.circular_thickness)
        module = self.outer_module
        found = explicit(
            module if self.addendum is None else self.addendum,
            1.25 * module if self.dedendum is None else self.dedendum,
            np.pi * module / 2.0 if self.circular_thickness is None else self.circular_thickness,
            self.cone_distance,
            taper_of(self.taper),
        )
        given = {"addendum_angle": self.addendum_angle, "dedendum_angle": self.dedendum_angle}
        return replace(found, **{name: float(np.radians(angle)) for name, angle in given.items() if angle is not None})

    @property
    def member(self) -> BevelMember:
        """The gear in numbers, as sizing systems have it; its thickness without backlash."""
        return BevelMember(
            teeth=self.teeth,
            module=self.outer_module,
            pitch_angle=self.pitch_cone_angle,
            face_width=self.face_width,
            pressure_angle=self.normal_pressure_angle,
            spiral_angle=float(np.radians(self.spiral_angle)),
            proportions=replace(self.proportions, thickness=self.outer_thickness),
        )

    @property
    def circular_backlash(self) -> float:
        """j_t on the outer pitch circle; of a normal one j_t = j_n/(cos a_n cos β_e) = j_n √(1/cos²β_e + tan²a_t)."""
        if self.normal_backlash is None:
            return self.backlash
        spiral = float(self.tooth_trace.spiral_angle(self.cone_distance))
        return self.normal_backlash * float(np.hypot(1.0 / np.cos(spiral), np.tan(self.transverse_pressure_angle)))

    @property
    def outer_thickness(self) -> float:
        """Circular thickness on the outer pitch circle, half the backlash taken off."""
        return self.proportions.thickness - self.circular_backlash / 2.0

    @cached_property
    def tooth_ends(self) -> ToothEnds:
        kind: Literal["conical", "spherical", "flat"] = (
            "conical" if self.ends == "conical" else "flat" if self.ends == "flat" else "spherical"
        )
        return ToothEnds(
            kind=kind, pitch_angle=self.pitch_cone_angle, inner=self.inner_distance, outer=self.cone_distance
        )

    @cached_property
    def bevel_teeth(self) -> BevelTeeth:
        """The teeth in numbers."""
        sharp = self._sharp_teeth
        if self.root != "fillet":
            return sharp
        return replace(sharp, tip_radius=self.generating_tip_radius)

    @property
    def generating_tip_radius(self) -> float:
        """ρ of the crown gear's tip at the outer end: as given; else a quarter of the module, or what fits."""
        if self.crown_tip_radius is not None:
            return self.crown_tip_radius
        usual, sharp = _USUAL_TIP * self.outer_module, self._sharp_teeth
        # a root arc that shrinks to nothing at one end alone would make the section another one there
        largest = sharp.largest_tip_radius * (_LEAVES_LAND if sharp.varies else 1.0)
        return min(usual, largest) if largest > 0.0 else usual

    @cached_property
    def _sharp_teeth(self) -> BevelTeeth:
        shape, distance = self.proportions, self.cone_distance
        height = _RELIEF_HEIGHT * self.outer_module if self.tip_relief_height is None else self.tip_relief_height
        return BevelTeeth(
            teeth=self.teeth,
            pitch_angle=self.pitch_cone_angle,
            pressure_angle=self.transverse_pressure_angle,
            form="octoid" if self.tooth_form == "octoid" else "involute",
            ends=self.tooth_ends,
            tips=DepthLine(outer=distance, height=shape.addendum, angle=shape.addendum_angle),
            roots=DepthLine(outer=distance, height=-shape.dedendum, angle=-shape.dedendum_angle),
            thickness=self.outer_thickness / self.pitch_radius,
            relief=self.tip_relief,
            relief_height=height,
            relief_power=1 if self.tip_relief_form == "linear" else 2,
            profile_crowning=self.profile_crowning,
            crowning=self.crowning,
        )

    @property
    def tooth(self) -> BevelTooth:
        """The tooth at the outer end, on the sphere."""
        return self.bevel_teeth.outer

    @property
    def tooth_trace(self) -> Trace:
        """The turn of the section along the face; positive for a right-hand spiral."""
        return spiral_of(self).tooth_trace

    @property
    def blank(self) -> Blank:
        """What is inside the teeth; where its hub is, `body` says."""
        names = [name for name in Blank.names() if name != "hub_offset"]
        return Blank(**{name: getattr(self, name) for name in names})

    @cached_property
    def body(self) -> BevelBody:
        """What carries the teeth."""
        return BevelBody(
            ends=self.tooth_ends,
            root_angle=self.bevel_teeth.least_root_angle,
            depth=self.proportions.depth,
            blank=self.blank,
            mounting_distance=self.mounting_distance,
        )

    @property
    def upward(self) -> Literal[1, -1]:
        """Apex up: its teeth face the apex."""
        return -1

    @property
    def remarks(self) -> list[str]:
        unit = self.length_unit
        return [
            *remarks.wide_face(self.face_width, self.cone_distance, unit),
            *remarks.unusual_depth("addendum", self.proportions.addendum, self.outer_module, unit, 1),
            *self.tooth_remarks,
        ]

    @property
    def tooth_remarks(self) -> list[str]:
        """What is unusual about the shape of its teeth."""
        return [
            *remarks.thin_tip(outer_tip_thickness(self), self.outer_module, self.length_unit),
            *(remarks.undercut_by_crown(self.teeth) if self.bevel_teeth.undercut else []),
        ]

    @property
    def description(self) -> str:
        spiral = "" if self.trace == "straight" else f", {self.hand}-hand spiral {self.spiral_angle:g}°"
        return f"z = {self.teeth}, δ = {np.degrees(self.pitch_cone_angle):.4g}°{spiral}"

    def ring(self, hole_angle: float | None) -> Solid:
        """The teeth and what is below them, down to a cone of a polar angle about the apex."""
        ends = self.tooth_ends
        return Swept(section=self.bevel_teeth.section(hole_angle), motion=ends.motion(self.tooth_trace), ends=ends.ends)

    @cached_property
    def solid(self) -> Solid:
        """The spherical section swept radially, and a body of revolution glued in it."""
        return self.body.solid(self.ring)

    def sizes(self) -> dict[str, Size]:
        """Sizes of this gear alone, at its outer end unless they say otherwise."""
        return bevel_sizes(self)

    def views(self) -> tuple[View, ...]:
        return bevel_views(self)

    def data_rows(self) -> tuple[Row, ...]:
        return bevel_rows(self)

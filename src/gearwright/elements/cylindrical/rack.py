"""Racks."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...motions.ends import between
from ...motions.extrusion import Extrusion
from ...motions.motion import Motion
from ...motions.straight import Straight
from ...parameters import LENGTH_UNITS, Problems, Size, declared
from ...sections.plane import Section
from ...sheets.content import Row
from ...sheets.views import View
from ...solids.solid import Solid
from ...solids.swept import Swept
from .. import declarations as d
from .. import refusals
from ..data_rows import cylindrical_rows
from ..element import SMOOTH, Element, require_at_most_one
from ..standards.iso_53 import BASIC_RACKS
from .helix import HELIX_NUMBERS, Helix, require_one_module
from .rack_tooth import RackTooth
from .rack_views import rack_views
from .sizes import in_unit

_BACK = 2.0  # modules from the roots to the back
_NUMBERS = (
    "teeth", "module", "diametral_pitch", "face_width", "pressure_angle", "basic_rack", "addendum",
    "addendum_coefficient", "dedendum", "dedendum_coefficient", "circular_thickness", "backlash", "fillet_radius",
    "rack_height", "length_unit", *HELIX_NUMBERS,
)  # fmt: skip


@dataclass(frozen=True, kw_only=True, repr=False)
class Rack(Element):
    """A rack with straight or helical teeth.

    Frame: pitch plane x = 0, teeth towards +x, one after another along +y, the first one centred on +x at z = 0;
    z from 0 to the face width. It ends in the middle of spaces. Raises ParameterError with every problem found.
    Source: ISO 53.
    """

    teeth: int = declared(d.TEETH)
    module: float | None = declared(d.MODULE, default=None)
    transverse_module: float | None = declared(d.TRANSVERSE_MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    face_width: float = declared(d.FACE_WIDTH)
    pressure_angle: float = declared(d.NORMAL_PRESSURE_ANGLE, default=20.0)
    helix_angle: float = declared(d.HELIX_ANGLE, default=0.0)
    hand: str = declared(d.HELIX_HAND, default="right")
    basic_rack: str = declared(d.BASIC_RACK, default="iso-53-a")
    addendum: float | None = declared(d.ADDENDUM, default=None)
    addendum_coefficient: float | None = declared(d.ADDENDUM_COEFFICIENT, default=None)
    dedendum: float | None = declared(d.DEDENDUM, default=None)
    dedendum_coefficient: float | None = declared(d.DEDENDUM_COEFFICIENT, default=None)
    circular_thickness: float | None = declared(d.CIRCULAR_THICKNESS, default=None)
    backlash: float = declared(d.BACKLASH, default=0.0)
    fillet_radius: float | None = declared(d.FILLET_RADIUS, default=None)
    rack_height: float | None = declared(d.RACK_HEIGHT, default=None)
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_module(problems, self)
        require_at_most_one(problems, self, "addendum", "addendum_coefficient")
        require_at_most_one(problems, self, "dedendum", "dedendum_coefficient")
        if problems.computable(*_NUMBERS) and problems.sound("module"):
            self._check_tooth(problems)
        problems.raise_any()

    def _check_tooth(self, problems: Problems) -> None:
        tooth, unit = self.tooth, self.length_unit
        largest = tooth.space.largest_radius
        if tooth.thickness <= 0.0:
            problems.add("backlash", refusals.no_tooth_left(2.0 * self._nominal_thickness, unit))
        elif tooth.thickness >= tooth.circular_pitch or largest <= 0.0:
            most = tooth.circular_pitch - 2.0 * tooth.dedendum * np.tan(tooth.transverse_pressure_angle)
            most += self._nominal_thickness - tooth.thickness
            problems.add("circular_thickness", refusals.meeting_teeth(float(most), unit))
        elif self.fillet_radius is not None and self.fillet_radius > largest * (1.0 + 1e-12):
            problems.add("fillet_radius", refusals.wide_fillet(largest, unit))
        elif tooth.space.side_end[1] <= -tooth.addendum:
            problems.add("fillet_radius", "leaves no straight flank; a smaller one does")
        if tooth.tip_half <= 0.0 < tooth.thickness:
            limit = tooth.thickness / 2.0 / np.tan(tooth.transverse_pressure_angle)
            problems.add("addendum", refusals.pointed_tooth(float(limit), unit))
        if self.back <= tooth.dedendum:
            problems.add("rack_height", f"must be greater than the dedendum, {tooth.dedendum:.4g} {unit}")

    @property
    def helix(self) -> Helix:
        """Its module and helix."""
        return Helix.of(self)

    @property
    def smooth_tolerance(self) -> float:
        return SMOOTH * self.normal_module

    @cached_property
    def normal_module(self) -> float:
        """m_n in the length unit."""
        return self.helix.normal_module

    @property
    def _nominal_thickness(self) -> float:
        if self.circular_thickness is not None:
            return self.circular_thickness
        return float(np.pi * self.normal_module / np.cos(self.helix.angle) / 2.0)

    @cached_property
    def tooth(self) -> RackTooth:
        rack, module = BASIC_RACKS[self.basic_rack], self.normal_module
        addendum = (self.addendum_coefficient or rack.addendum) * module if self.addendum is None else self.addendum
        dedendum = (self.dedendum_coefficient or rack.dedendum) * module if self.dedendum is None else self.dedendum
        bare = RackTooth(
            module=module,
            pressure_angle=float(np.radians(self.pressure_angle)),
            helix_angle=self.helix.angle,
            addendum=addendum,
            dedendum=dedendum,
            thickness=self._nominal_thickness - self.backlash / 2.0,
            fillet_radius=0.0,
        )
        fitting = max(0.0, min(rack.tip_radius * module, bare.space.largest_radius))
        return bare.with_fillet(fitting if self.fillet_radius is None else self.fillet_radius)

    @property
    def back(self) -> float:
        """From the pitch plane to the back."""
        return self.tooth.dedendum + _BACK * self.normal_module if self.rack_height is None else self.rack_height

    @property
    def profile(self) -> Section:
        """The transverse section at z = 0."""
        return self.tooth.section(self.teeth, self.back)

    @property
    def motion(self) -> Motion:
        """How the transverse section moves from z = 0 to the face width: sheared by b tan β along +y if right-hand."""
        shift = float(self.helix.sense * self.face_width * np.tan(self.helix.angle))
        return Extrusion(length=self.face_width, skew=(0.0, shift)) if shift else Straight()

    @cached_property
    def solid(self) -> Solid:
        return Swept(section=self.profile, motion=self.motion, ends=between(0.0, self.face_width))

    @property
    def description(self) -> str:
        helix = f", β = {self.helix_angle:.4g}° {self.hand}" if self.helix_angle else ""
        module = self.normal_module * LENGTH_UNITS[self.length_unit]  # told in mm, whatever lengths are in
        return f"z = {self.teeth}, m = {module:.4g} mm{helix}"

    def sizes(self) -> dict[str, Size]:
        """Derived sizes by name, with the symbols of ISO 53."""
        tooth = self.tooth
        lengths = {
            "module": (tooth.module, "m_n", "module in the normal section, in the length unit"),
            "circular_pitch": (tooth.circular_pitch, "p_t", "transverse pitch"),
            "addendum": (tooth.addendum, "h_a", "addendum"),
            "dedendum": (tooth.dedendum, "h_f", "dedendum"),
            "circular_thickness": (tooth.thickness, "s_t", "transverse thickness on the pitch line, less backlash"),
            "tip_thickness": (2.0 * tooth.tip_half, "s_at", "transverse thickness at the tip"),
            "fillet_radius": (tooth.fillet_radius, "ρ_f", "radius of the fillets, normal section"),
            "rack_height": (self.back, "H", "from the back to the pitch plane"),
            "length": (self.teeth * tooth.circular_pitch, "L", "length of the rack"),
        }
        angle = {"transverse_pressure_angle": (tooth.transverse_pressure_angle, "α_t", "transverse pressure angle")}
        return {**in_unit(lengths, "length"), **in_unit(angle, "angle")}

    def views(self) -> tuple[View, ...]:
        return rack_views(self)

    def data_rows(self) -> tuple[Row, ...]:
        return cylindrical_rows(self)

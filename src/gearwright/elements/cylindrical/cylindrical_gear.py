"""What external and internal cylindrical gears have in common."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from ...curves.polynomial import Polynomial, parabola
from ...motions.extrusion import Extrusion
from ...motions.motion import Motion
from ...motions.straight import Straight
from ...parameters import LENGTH_UNITS, Problems, Size, declarations, declared
from ...sections.plane import Section
from ...sheets.content import Row
from .. import declarations as d
from .. import refusals, remarks
from ..blanks.blank import Blank
from ..data_rows import cylindrical_rows
from ..element import SMOOTH, Element, require_at_most_one
from ..standards.iso_53 import BASIC_RACKS, BasicRack
from ..standards.over_pins import USUAL as USUAL_PINS
from .external_tooth import ExternalTooth
from .flank import Relief
from .helix import Helix, require_one_module
from .internal_tooth import InternalTooth
from .sizes import inspection_sizes, tip_thickness, toothing_sizes
from .tooth_checks import check_crowning
from .toothing import Toothing

_RELIEF_HEIGHT = 0.6  # modules: relief that leaves some two thirds of a usual flank unrelieved

_BESIDE_THE_TEETH = {*(field.name for field in fields(Blank)), "pin_diameter", "span_teeth", "outer_diameter"} - {
    "length_unit"
}


@dataclass(frozen=True, kw_only=True, repr=False)
class CylindricalGear(Element):
    """A gear with involute teeth about one axis.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x at z = 0. Module and pressure angle
    are those of the normal section. Raises ParameterError with every problem found. Source: ISO 21771.
    """

    teeth: int = declared(d.TEETH)
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    face_width: float = declared(d.FACE_WIDTH)
    pressure_angle: float = declared(d.NORMAL_PRESSURE_ANGLE, default=20.0)
    profile_shift: float = declared(d.PROFILE_SHIFT, default=0.0)
    basic_rack: str = declared(d.BASIC_RACK, default="iso-53-a")
    addendum: float | None = declared(d.ADDENDUM, default=None)
    addendum_coefficient: float | None = declared(d.ADDENDUM_COEFFICIENT, default=None)
    dedendum: float | None = declared(d.DEDENDUM, default=None)
    dedendum_coefficient: float | None = declared(d.DEDENDUM_COEFFICIENT, default=None)
    tip_diameter: float | None = declared(d.TIP_DIAMETER, default=None)
    circular_thickness: float | None = declared(d.CIRCULAR_THICKNESS, default=None)
    backlash: float = declared(d.BACKLASH, default=0.0)
    tip_relief: float = declared(d.TIP_RELIEF, default=0.0)
    tip_relief_height: float | None = declared(d.TIP_RELIEF_HEIGHT, default=None)
    tip_relief_form: str = declared(d.TIP_RELIEF_FORM, default="linear")
    tip_chamfer: float = declared(d.TIP_CHAMFER, default=0.0)
    crowning: float = declared(d.CROWNING, default=0.0)
    root: str = declared(d.GEAR_ROOT, default="fillet")
    pin_diameter: float | None = declared(d.PIN_DIAMETER, default=None)
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        self._check_given(problems)
        if problems.computable(*self._of_the_teeth) and problems.sound("module"):
            self._check_teeth(problems)
            if problems.sound():
                for name, message in check_crowning(
                    self.tooth, self.crowning / self.toothing.base_radius, self.length_unit
                ):
                    problems.add(name, message)
            if problems.sound():
                self._check_measured(problems)
        problems.raise_any()

    @property
    def _of_the_teeth(self) -> tuple[str, ...]:
        """Parameters that the shape of the teeth follows from."""
        return tuple(one.name for one in declarations(type(self)) if one.name not in _BESIDE_THE_TEETH)

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
    @abstractmethod
    def tooth(self) -> ExternalTooth | InternalTooth:
        """The tooth's shape in the transverse plane."""

    @property
    @abstractmethod
    def profile(self) -> Section:
        """The transverse section at z = 0, without crowning."""

    @abstractmethod
    def _check_teeth(self, problems: Problems) -> None:
        """Adds problems of the teeth and of what they stand on."""

    def _check_given(self, problems: Problems) -> None:
        require_one_module(problems, self)
        require_at_most_one(problems, self, "tip_diameter", "addendum", "addendum_coefficient")
        require_at_most_one(problems, self, "dedendum", "dedendum_coefficient")
        if problems.sound("tip_relief") and not self.tip_relief and self.tip_relief_height is not None:
            problems.add("tip_relief_height", "goes with tip_relief; give that, too, or leave this out")

    def _check_measured(self, problems: Problems) -> None:
        """Adds problems of inspection sizes that are asked for."""
        if self.pin_diameter is not None and "over_pins" not in self._inspection_sizes():
            problems.add("pin_diameter", refusals.pins_that_do_not_touch(self._usual_pin, self.length_unit))

    def sizes(self) -> dict[str, Size]:
        """Derived sizes by name, with the symbols of ISO 21771."""
        return {**toothing_sizes(self.tooth, self.flank_width), **self._inspection_sizes()}

    def data_rows(self) -> tuple[Row, ...]:
        return cylindrical_rows(self)

    @property
    def _usual_pin(self) -> float:
        return USUAL_PINS[self.is_internal] * self.normal_module

    def _inspection_sizes(self) -> dict[str, Size]:
        return inspection_sizes(self.tooth, self._usual_pin if self.pin_diameter is None else self.pin_diameter)

    @property
    def rack(self) -> BasicRack:
        """The basic rack's proportions."""
        return BASIC_RACKS[self.basic_rack]

    @cached_property
    def toothing(self) -> Toothing:
        """The teeth in numbers."""
        module, x, r = self.normal_module, self.profile_shift, self.pitch_radius
        coefficient = self.addendum_coefficient or self.rack.addendum
        addendum = (coefficient + x) * module if self.addendum is None else self.addendum
        if self.tip_diameter is not None:
            addendum = (-1 if self.is_internal else 1) * (self.tip_diameter / 2.0 - r)
        coefficient = self.dedendum_coefficient or self.rack.dedendum
        return Toothing(
            teeth=self.teeth,
            module=module,
            pressure_angle=float(np.radians(self.pressure_angle)),
            helix_angle=self.helix.angle,
            profile_shift=x,
            addendum=addendum,
            dedendum=(coefficient - x) * module if self.dedendum is None else self.dedendum,
            thickness=self.nominal_thickness - self.backlash / 2.0,
            internal=self.is_internal,
        )

    @property
    @abstractmethod
    def is_internal(self) -> bool:
        """Whether the teeth point to the axis."""

    @property
    def pitch_radius(self) -> float:
        return float(self.teeth * self.normal_module / np.cos(self.helix.angle) / 2.0)

    @property
    def flank_width(self) -> float:
        """Length along the axis on which teeth run on without a bend."""
        return self.face_width

    @property
    def tip_radius(self) -> float:
        return self.toothing.tip_radius

    @property
    def root_radius(self) -> float:
        return self.toothing.root_radius

    @property
    def nominal_thickness(self) -> float:
        """Transverse circular thickness asked for, before backlash: s_t = m_n (π/2 + 2x tan α_n)/cos β."""
        if self.circular_thickness is not None:
            return self.circular_thickness
        widened = np.pi / 2.0 + 2.0 * self.profile_shift * np.tan(np.radians(self.pressure_angle))
        return float(self.normal_module * widened / np.cos(self.helix.angle))

    @property
    def relief(self) -> Relief | None:
        if not self.tip_relief:
            return None
        toothing = self.toothing
        height = _RELIEF_HEIGHT * self.normal_module if self.tip_relief_height is None else self.tip_relief_height
        begin = toothing.tip_radius - toothing.outward * (self.tip_chamfer + height)
        return Relief(amount=self.tip_relief, begin=begin, power=1 if self.tip_relief_form == "linear" else 2)

    @property
    def crown(self) -> Polynomial | None:
        """The angle by which crowned flanks turn into their teeth, by z: C_β (2z/b − 1)²/r_b, which is exact."""
        if not self.crowning:
            return None
        return parabola(self.crowning / self.toothing.base_radius, 0.0, self.face_width)

    @property
    def twist(self) -> float:
        """Angle by which the section at the far end is turned, radians: ±b tan β/r."""
        return float(self.helix.sense * self.face_width * np.tan(self.helix.angle) / self.pitch_radius)

    @property
    def motion(self) -> Motion:
        """How the transverse section moves from z = 0 to the face width."""
        return Extrusion(length=self.face_width, twist=self.twist) if self.twist else Straight()

    @property
    def remarks(self) -> list[str]:
        addendum = self.toothing.addendum - self.profile_shift * self.normal_module
        return [
            *remarks.unusual_depth("addendum", addendum, self.normal_module, self.length_unit, 1),
            *remarks.thin_tip(tip_thickness(self.tooth), self.normal_module, self.length_unit),
        ]

    @property
    def description(self) -> str:
        helix = f", β = {self.helix.helix_angle:.4g}° {self.helix.hand}" if self.helix.angle else ""
        shift = f", x = {self.profile_shift:g}" if self.profile_shift else ""
        module = self.normal_module * LENGTH_UNITS[self.length_unit]  # told in mm, whatever lengths are in
        return f"z = {self.teeth}, m = {module:.4g} mm{helix}{shift}"

"""Spur gears."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..motions.ends import between
from ..motions.straight import Straight
from ..parameters import Problems, Size, declared, rounded_down
from ..sections.plane import Section
from ..solids.solid import Solid
from ..solids.swept import Swept
from . import declarations as d
from . import refusals, remarks
from .element import Element, module_in, require_one_pitch
from .spur_tooth import SpurTooth

_OF_THE_BLANK = ("teeth", "module", "diametral_pitch", "dedendum", "circular_thickness", "backlash", "length_unit")
_OF_THE_TOOTH = ("addendum", "pressure_angle")


@dataclass(frozen=True, kw_only=True)
class SpurGear(Element):
    """An external spur gear with involute teeth.

    Frame: axis z, teeth from z = 0 to the face width, first tooth centred on +x. Addendum (default one
    module), dedendum (default 1.25 modules) and circular thickness (default half the pitch) are on the
    pitch circle. Raises ParameterError with every problem found.
    Source: Al-Daccak 1989, ch. 4.5.2; ISO 21771.
    """

    teeth: int = declared(d.TEETH)
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    face_width: float = declared(d.FACE_WIDTH)
    pressure_angle: float = declared(d.PRESSURE_ANGLE, default=20.0)
    addendum: float | None = declared(d.ADDENDUM, default=None)
    dedendum: float | None = declared(d.DEDENDUM, default=None)
    circular_thickness: float | None = declared(d.CIRCULAR_THICKNESS, default=None)
    backlash: float = declared(d.BACKLASH, default=0.0)
    bore: float | None = declared(d.BORE, default=None)
    root: str = declared(d.ROOT, default="radial")
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_pitch(problems, self.module, self.diametral_pitch)
        if problems.computable(*_OF_THE_BLANK) and problems.sound("module"):
            self._check_blank(problems)
        if problems.computable(*_OF_THE_BLANK, *_OF_THE_TOOTH) and problems.sound("module", "dedendum", "backlash"):
            self._check_tooth(problems)
        problems.raise_any()

    def _check_blank(self, problems: Problems) -> None:
        unit = self.length_unit
        if self.root_radius <= 0.0:
            least = f"less than the pitch radius, {rounded_down(self.pitch_radius)} {unit}"
            problems.add("dedendum", f"the root circle vanishes; {least}")
        elif self.bore is not None and problems.sound("bore") and self.bore >= 2.0 * self.root_radius:
            problems.add("bore", refusals.bore_in_roots("root diameter", 2.0 * self.root_radius, unit))
        if self.nominal_thickness <= self.backlash / 2.0:
            problems.add("backlash", refusals.no_tooth_left(2.0 * self.nominal_thickness, unit))

    def _check_tooth(self, problems: Problems) -> None:
        tooth, unit = self.tooth, self.length_unit
        if tooth.flank_start >= tooth.pitch_radius:
            problems.add("dedendum", refusals.no_involute("circle"))
            return
        if tooth.tip_radius >= tooth.pointed_radius:
            limit = tooth.pointed_radius - self.pitch_radius
            problems.add(
                "addendum",
                refusals.pointed_tooth(limit, unit),
            )
        if tooth.root_space <= 0.0:
            limit = self.nominal_thickness + tooth.root_space * self.pitch_radius
            problems.add(
                "circular_thickness",
                refusals.meeting_teeth(limit, unit),
            )

    @cached_property
    def transverse_module(self) -> float:
        """Module in the length unit."""
        return module_in(self.length_unit, self.module, self.diametral_pitch)

    @property
    def pitch_radius(self) -> float:
        return self.teeth * self.transverse_module / 2.0

    @property
    def tip_radius(self) -> float:
        return self.pitch_radius + (self.transverse_module if self.addendum is None else self.addendum)

    @property
    def root_radius(self) -> float:
        return self.pitch_radius - (1.25 * self.transverse_module if self.dedendum is None else self.dedendum)

    @property
    def nominal_thickness(self) -> float:
        """Circular thickness asked for, before backlash."""
        return np.pi * self.transverse_module / 2.0 if self.circular_thickness is None else self.circular_thickness

    @property
    def thickness(self) -> float:
        """Circular thickness on the pitch circle, half the backlash taken off."""
        return self.nominal_thickness - self.backlash / 2.0

    @cached_property
    def tooth(self) -> SpurTooth:
        return SpurTooth(
            teeth=self.teeth,
            pitch_radius=self.pitch_radius,
            pressure_angle=float(np.radians(self.pressure_angle)),
            tip_radius=self.tip_radius,
            root_radius=self.root_radius,
            thickness=self.thickness / self.pitch_radius,
        )

    @property
    def remarks(self) -> list[str]:
        addendum = self.tip_radius - self.pitch_radius
        return remarks.unusual_depth("addendum", addendum, self.transverse_module, self.length_unit, 1)

    @property
    def description(self) -> str:
        return f"z = {self.teeth}, m = {self.transverse_module:.4g} {self.length_unit}"

    @cached_property
    def profile(self) -> Section:
        """The transverse section, bored where the gear is."""
        return self.tooth.section(None if self.bore is None else self.bore / 2.0)

    @cached_property
    def solid(self) -> Solid:
        """The section extruded over the face width."""
        return Swept(section=self.profile, motion=Straight(), ends=between(0.0, self.face_width))

    def sizes(self) -> dict[str, Size]:
        """Diameters and thicknesses."""
        tooth = self.tooth
        tip = tooth.thickness_at(tooth.tip_radius) * tooth.tip_radius
        rows = {
            "module": (self.transverse_module, "m", "module in the length unit"),
            "pitch_diameter": (2.0 * tooth.pitch_radius, "d", "pitch diameter"),
            "outside_diameter": (2.0 * tooth.tip_radius, "d_a", "tip diameter"),
            "root_diameter": (2.0 * tooth.root_radius, "d_f", "root diameter"),
            "base_diameter": (2.0 * tooth.base_radius, "d_b", "base diameter"),
            "addendum": (tooth.tip_radius - tooth.pitch_radius, "h_a", "addendum"),
            "dedendum": (tooth.pitch_radius - tooth.root_radius, "h_f", "dedendum"),
            "circular_pitch": (np.pi * self.transverse_module, "p", "circular pitch"),
            "circular_thickness": (self.thickness, "s", "circular thickness, backlash taken off"),
            "tip_thickness": (tip, "s_a", "circular thickness at the tip"),
        }
        return {name: Size(float(value), "length", symbol, meaning) for name, (value, symbol, meaning) in rows.items()}

"""One bevel gear."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from ...boundary.gluing import Joint
from ...curves.arc import Arc
from ...curves.line import Line
from ...curves.trace import LogarithmicTrace, StraightTrace, Trace
from ...motions.ends import between
from ...motions.radial import Radial
from ...motions.revolution import FULL_TURN, Revolution
from ...parameters import Problems, Size, declared, rounded_down
from ...sections.loop import Loop
from ...sections.plane import Section
from ...solids.composite import Composite
from ...solids.solid import Solid
from ...solids.swept import Swept
from .. import declarations as d
from .. import refusals, remarks
from ..element import Element, module_in, require_angle_of_trace, require_one_pitch
from .pitch_cone import pitch_cone_angle, require_cone
from .tooth import BevelTooth

_OF_THE_CONE = ("teeth", "module", "diametral_pitch", "mate_teeth", "shaft_angle", "pitch_angle", "length_unit")
_LEAST_INNER = 1e-6  # of the cone distance: nearer to the apex there is only rounding
_OF_THE_BLANK = ("face_width", "addendum", "dedendum")
_OF_THE_TOOTH = ("addendum", "dedendum", "pressure_angle", "circular_thickness", "backlash")


@dataclass(frozen=True, kw_only=True)
class BevelGear(Element):
    """A bevel gear with exact spherical-involute teeth between two spheres about its apex.

    Frame: apex at the origin, body on +z, first tooth centred on +x at the mean cone distance.
    The pitch cone is given by its half-angle, or by the mate's teeth and the shaft angle.
    Sizing is explicit: addendum (default one module), dedendum (default 1.25 modules) and circular
    thickness (default half the pitch) at the outer end. Raises ParameterError with every problem found.
    Source: Al-Daccak 1989, ch. 3, with the base cone sin γ_b = sin γ cos a that makes pairs conjugate.
    """

    teeth: int = declared(d.TEETH)
    module: float | None = declared(d.MODULE, default=None)
    diametral_pitch: float | None = declared(d.DIAMETRAL_PITCH, default=None)
    mate_teeth: int | None = declared(d.MATE_TEETH, default=None)
    shaft_angle: float | None = declared(d.SHAFT_ANGLE, default=None)
    pitch_angle: float | None = declared(d.PITCH_ANGLE, default=None)
    face_width: float = declared(d.FACE_WIDTH)
    addendum: float | None = declared(d.ADDENDUM, default=None)
    dedendum: float | None = declared(d.DEDENDUM, default=None)
    pressure_angle: float = declared(d.PRESSURE_ANGLE, default=20.0)
    circular_thickness: float | None = declared(d.CIRCULAR_THICKNESS, default=None)
    backlash: float = declared(d.BACKLASH, default=0.0)
    bore: float | None = declared(d.BORE, default=None)
    trace: str = declared(d.TRACE, default="straight")
    spiral_angle: float = declared(d.SPIRAL_ANGLE, default=0.0)
    hand: str = declared(d.HAND, default="right")
    root: str = declared(d.ROOT, default="radial")
    ends: str = declared(d.BEVEL_ENDS, default="spherical")
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        require_one_pitch(problems, self.module, self.diametral_pitch)
        self._check_cone(problems)
        require_angle_of_trace(problems, self.trace, self.spiral_angle)
        if problems.computable(*_OF_THE_CONE, *_OF_THE_BLANK) and problems.sound(
            "module", "pitch_angle", "shaft_angle"
        ):
            self._check_blank(problems)
        if problems.computable(*_OF_THE_CONE, *_OF_THE_TOOTH) and problems.sound(
            "module", "pitch_angle", "shaft_angle", "dedendum"
        ):
            self._check_tooth(problems)
        problems.raise_any()

    def _check_cone(self, problems: Problems) -> None:
        if (self.pitch_angle is None) == (self.mate_teeth is None):
            problems.add(
                "pitch_angle", "give either the pitch angle, or mate_teeth (and a shaft angle if it is not 90°)"
            )
        elif self.pitch_angle is not None and self.shaft_angle is not None:
            problems.add("shaft_angle", "goes with mate_teeth; a pitch angle alone settles the cone")
        elif problems.computable(*_OF_THE_CONE) and problems.sound("module"):
            require_cone(problems, self.pitch_cone_angle)

    def _check_blank(self, problems: Problems) -> None:
        unit = self.length_unit
        if self.inner_distance <= _LEAST_INNER * self.cone_distance:
            problems.add("face_width", refusals.wide_face(self.cone_distance, unit))
        if self.root_angle <= 0.0:
            limit = self.cone_distance * np.tan(self.pitch_cone_angle)
            problems.add("dedendum", f"the root cone would pass the axis; less than {rounded_down(limit)} {unit}")
        elif self.bore is not None and problems.sound("face_width", "bore"):
            limit = 2.0 * self.inner_distance * np.sin(self.root_angle)
            if self.bore >= limit:
                problems.add(
                    "bore",
                    refusals.bore_in_roots("root diameter at the small end", limit, unit),
                )

    def _check_tooth(self, problems: Problems) -> None:
        tooth, unit = self.tooth, self.length_unit
        if tooth.thickness <= 0.0:
            problems.add("backlash", refusals.no_tooth_left(2.0 * self._nominal_thickness, unit))
            return
        if tooth.flank_start >= self.pitch_cone_angle:
            problems.add("pressure_angle", refusals.no_involute("cone"))
            return
        if tooth.face_angle >= tooth.pointed_angle:
            limit = self.cone_distance * np.tan(tooth.pointed_angle - self.pitch_cone_angle)
            problems.add(
                "addendum",
                refusals.pointed_tooth(limit, unit),
            )
        if tooth.root_space <= 0.0:
            limit = self._nominal_thickness + tooth.root_space * self.pitch_radius
            problems.add(
                "circular_thickness",
                refusals.meeting_teeth(limit, unit),
            )

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
        shaft = np.radians(90.0 if self.shaft_angle is None else self.shaft_angle)
        return pitch_cone_angle(self.teeth, self.mate_teeth or self.teeth, shaft)

    @property
    def base_cone_angle(self) -> float:
        """γ_b, radians: sin γ_b = sin γ cos a (eq. G2)."""
        return float(np.arcsin(np.sin(self.pitch_cone_angle) * np.cos(np.radians(self.pressure_angle))))

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

    @property
    def outer_addendum(self) -> float:
        return self.outer_module if self.addendum is None else self.addendum

    @property
    def outer_dedendum(self) -> float:
        return 1.25 * self.outer_module if self.dedendum is None else self.dedendum

    @property
    def face_angle(self) -> float:
        """δ_a, radians: pitch angle and addendum angle atan(h_a/R_e)."""
        return float(self.pitch_cone_angle + np.arctan(self.outer_addendum / self.cone_distance))

    @property
    def root_angle(self) -> float:
        """δ_f, radians: pitch angle less dedendum angle atan(h_f/R_e)."""
        return float(self.pitch_cone_angle - np.arctan(self.outer_dedendum / self.cone_distance))

    @property
    def _nominal_thickness(self) -> float:
        return np.pi * self.outer_module / 2.0 if self.circular_thickness is None else self.circular_thickness

    @property
    def outer_thickness(self) -> float:
        """Circular thickness on the outer pitch circle, half the backlash taken off."""
        return self._nominal_thickness - self.backlash / 2.0

    @cached_property
    def tooth(self) -> BevelTooth:
        return BevelTooth(
            teeth=self.teeth,
            base_cone_angle=self.base_cone_angle,
            pitch_angle=self.pitch_cone_angle,
            face_angle=self.face_angle,
            root_angle=self.root_angle,
            thickness=self.outer_thickness / self.pitch_radius,
        )

    @property
    def tooth_trace(self) -> Trace:
        """The turn of the section along the face; positive for a right-hand spiral."""
        if self.trace == "straight":
            return StraightTrace()
        sense = 1.0 if self.hand == "right" else -1.0
        rate = sense * np.tan(np.radians(self.spiral_angle)) / np.sin(self.pitch_cone_angle)
        return LogarithmicTrace(rate=float(rate), mean_distance=self.mean_distance)

    @property
    def upward(self) -> Literal[1, -1]:
        """Apex up: its teeth face the apex."""
        return -1

    @property
    def remarks(self) -> list[str]:
        unit = self.length_unit
        return [
            *remarks.wide_face(self.face_width, self.cone_distance, unit),
            *remarks.unusual_depth("addendum", self.outer_addendum, self.outer_module, unit, 1),
        ]

    @property
    def description(self) -> str:
        spiral = f", {self.hand}-hand spiral {self.spiral_angle:g}°" if self.spiral_angle else ""
        return f"z = {self.teeth}, δ = {np.degrees(self.pitch_cone_angle):.4g}°{spiral}"

    @cached_property
    def solid(self) -> Solid:
        """The spherical section swept radially; with a bore, the toothed ring and a revolved collar glued in it."""
        motion, ends = Radial(trace=self.tooth_trace), between(self.inner_distance, self.cone_distance)
        if self.bore is None:
            return Swept(section=self.tooth.section(), motion=motion, ends=ends)
        bore_angle = float(np.arcsin(self.bore / 2.0 / self.inner_distance))
        hub_angle = (bore_angle + self.root_angle) / 2.0
        ring = Swept(section=self.tooth.section(hub_angle), motion=motion, ends=ends)
        collar = _collar(self.bore / 2.0, hub_angle, self.inner_distance, self.cone_distance)
        joint = Joint(first=0, first_faces=("loop 2.1",), second=1, second_faces=("loop 1.2",))
        return Composite(pieces=(ring, collar), joints=(joint,))

    def sizes(self) -> dict[str, Size]:
        """Sizes of this gear alone, at its outer end unless they say otherwise."""
        length, angle = self._length_sizes(), self._angle_sizes()
        return {
            **{
                name: Size(float(value), "length", symbol, meaning) for name, (value, symbol, meaning) in length.items()
            },
            **{
                name: Size(float(np.degrees(value)), "angle", symbol, meaning)
                for name, (value, symbol, meaning) in angle.items()
            },
        }

    def _length_sizes(self) -> dict[str, tuple[float, str, str]]:
        widest = min(self.face_angle, np.pi / 2.0)
        tip = self.tooth.thickness_at(self.face_angle) * np.sin(self.face_angle) * self.cone_distance
        return {
            "pitch_diameter": (2.0 * self.pitch_radius, "d_e", "outer pitch diameter"),
            "outside_diameter": (2.0 * self.cone_distance * np.sin(widest), "d_ae", "largest diameter of the body"),
            "root_diameter": (2.0 * self.cone_distance * np.sin(self.root_angle), "d_fe", "outer root diameter"),
            "cone_distance": (self.cone_distance, "R_e", "outer cone distance"),
            "mean_cone_distance": (self.mean_distance, "R_m", "mean cone distance"),
            "inner_cone_distance": (self.inner_distance, "R_i", "inner cone distance"),
            "addendum": (self.outer_addendum, "h_ae", "outer addendum"),
            "dedendum": (self.outer_dedendum, "h_fe", "outer dedendum"),
            "circular_thickness": (self.outer_thickness, "s_e", "outer circular thickness, backlash taken off"),
            "tip_thickness": (tip, "s_ae", "outer circular thickness at the tip"),
        }

    def _angle_sizes(self) -> dict[str, tuple[float, str, str]]:
        return {
            "pitch_angle": (self.pitch_cone_angle, "δ", "half-angle of the pitch cone"),
            "face_angle": (self.face_angle, "δ_a", "half-angle of the face cone"),
            "root_angle": (self.root_angle, "δ_f", "half-angle of the root cone"),
            "base_angle": (self.base_cone_angle, "δ_b", "half-angle of the base cone"),
            "addendum_angle": (self.face_angle - self.pitch_cone_angle, "θ_a", "addendum angle"),
            "dedendum_angle": (self.pitch_cone_angle - self.root_angle, "θ_f", "dedendum angle"),
        }


def _collar(bore_radius: float, hub_angle: float, inner: float, outer: float) -> Swept:
    """The ring between a bore and a cone about +z, between two spheres about the apex: a revolved section."""
    top, bottom = np.sqrt(outer**2 - bore_radius**2), np.sqrt(inner**2 - bore_radius**2)
    cone = np.pi / 2.0 - hub_angle  # polar angle from +z, as an angle from the radius axis

    def on_cone(distance: float) -> tuple[float, float]:
        return (float(distance * np.cos(cone)), float(distance * np.sin(cone)))

    curves = (
        Arc(radius=inner, interval=(float(np.arctan2(bottom, bore_radius)), cone)),
        Line(first=on_cone(inner), last=on_cone(outer)),
        Arc(radius=outer, interval=(cone, float(np.arctan2(top, bore_radius)))),
        Line(first=(bore_radius, float(top)), last=(bore_radius, float(bottom))),
    )
    section = Section(loops=(Loop(curves=curves),))
    return Swept(section=section, motion=Revolution(), ends=between(-FULL_TURN, 0.0))

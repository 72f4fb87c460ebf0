"""Plane disk cams."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from ...arrays import Array
from ...curves.arc import Arc
from ...errors import GeometryError
from ...motions.ends import between
from ...motions.straight import Straight
from ...parameters import Problems, Size, declared
from ...sections.loop import Loop
from ...sections.outlines import polygon_loop
from ...sections.plane import Section
from ...sheets.content import Row, Table
from ...sheets.views import View
from ...solids.properties import MassProperties
from ...solids.solid import Solid
from ...solids.swept import Swept
from .. import declarations as common
from ..element import Element
from . import declarations as d
from . import refusals
from .cam_views import cam_rows, cam_views, lift_table
from .findings import findings_of, remarks_of
from .freedom import freedom
from .kinds import KINDS, Kind
from .laws import FIXED_LAWS, SPLINE
from .led import Movement
from .limits import Limits
from .optimum import Optimum, Task
from .parameter_checks import check_law, check_parameters
from .placement_checks import placement_problems
from .profile import Profile
from .profile_checks import profile_of, profile_problems
from .programme import Displacement, Step, moves_of, read_programme
from .sizes import sizes_of
from .synthesis import least_area, least_area_spline

_FREE_VALUES = 8
_ECCENTRICITY = 0.5  # × base radius: Al-Daccak 1989, ch. 4.5.1
_PRESSURE_ANGLES = {"translating-roller": 30.0, "oscillating-roller": 45.0}  # degrees, the textbooks' limits


@dataclass(frozen=True, kw_only=True, repr=False)
class Cam(Element):
    """A plane disk cam for a follower with a flat face or a roller, translating or oscillating.

    Frame: the cam's axis is z, the disk from z = 0 to the thickness. It turns clockwise seen from +z, so that the
    follower goes about it counter-clockwise by the cam angle ψ: the stem or the pivot is at azimuth ψ, the programme
    starts with the follower on +x. With minimise="area" the dimensions that are not given, and the values of the
    spline, are chosen. Raises ParameterError with every problem found.
    Source: Al-Daccak 1989, ch. 4.5.1; Angeles & López-Cajún 1988.
    """

    programme: str = declared(d.PROGRAMME)
    follower: str = declared(d.FOLLOWER, default="oscillating-flat-face")
    law: str | None = declared(d.LAW, default=None)
    swing: float | None = declared(d.SWING, default=None)
    lift: float | None = declared(d.LIFT, default=None)
    sense: str | None = declared(d.SENSE, default=None)
    pivot_distance: float | None = declared(d.PIVOT_DISTANCE, default=None)
    face_offset: float | None = declared(d.FACE_OFFSET, default=None)
    initial_angle: float | None = declared(d.INITIAL_ANGLE, default=None)
    arm_length: float | None = declared(d.ARM_LENGTH, default=None)
    roller_radius: float | None = declared(d.ROLLER_RADIUS, default=None)
    base_radius: float | None = declared(d.BASE_RADIUS, default=None)
    offset: float | None = declared(d.OFFSET, default=None)
    thickness: float = declared(d.THICKNESS)
    bore: float | None = declared(common.BORE, default=None)
    vertices: int = declared(d.VERTICES, default=100)
    minimise: str | None = declared(d.MINIMISE, default=None)
    free_values: int | None = declared(d.FREE_VALUES, default=None)
    eccentricity_limit: float | None = declared(d.ECCENTRICITY_LIMIT, default=None)
    curvature_limit: float | None = declared(d.CURVATURE_LIMIT, default=None)
    pressure_angle_limit: float | None = declared(d.PRESSURE_ANGLE_LIMIT, default=None)
    spline_values: tuple[float, ...] | None = declared(d.SPLINE_VALUES, default=None)
    length_unit: str = declared(common.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        if problems.sound("follower", "minimise"):
            check_parameters(self, problems)
        movement = "swing" if problems.sound("follower") and self.kind.swings else "lift"
        if problems.sound("follower", "programme", movement):
            for problem in read_programme(self.programme, self.amount, self._amount_unit)[1]:
                problems.add("programme", problem)
        if problems.sound("law", "spline_values", "minimise", "free_values"):
            check_law(self, problems)
        if problems.sound():
            self._check_shape(problems)
        problems.raise_any()

    def _check_shape(self, problems: Problems) -> None:
        unit = self.length_unit
        if self.minimise and self.task.freedom.variables:
            self._check_synthesis(problems)
        if problems.sound():
            for name, problem in placement_problems(self.follower, self._placed, self.amount, unit):
                problems.add(name, problem)
        if problems.sound() and self.minimise:
            self._check_synthesis(problems)
        if problems.sound():
            arguments = (self.follower, self.dimensions, self.sense or "opposite", self.displacement)
            for name, problem in profile_problems(*arguments, self.amount, unit):
                problems.add(name, problem)
        if problems.sound() and self.bore is not None and self.bore >= 2.0 * self.traced.follower.base_radius:
            problems.add("bore", refusals.bore_too_wide(2.0 * self.traced.follower.base_radius, unit))

    def _check_synthesis(self, problems: Problems) -> None:
        if self.law not in (None, SPLINE) and not self.task.freedom.variables:
            problems.add("minimise", refusals.NOTHING_FREE)
            return
        found = self.optimum
        if found is not None and not found.keeps_limits:
            in_angle = found.missed == "pressure angle"
            shortfall = found.shortfall * (1.0 if in_angle else self.task.freedom.size)
            problems.add("minimise", refusals.no_cam(found.missed, shortfall, self.length_unit, found.law))

    @property
    def kind(self) -> Kind:
        return KINDS[self.follower]

    @property
    def amount(self) -> float:
        """The swing in degrees, or the lift."""
        return (self.swing if self.kind.swings else self.lift) or 0.0

    @property
    def _amount_unit(self) -> str:
        return "degrees" if self.kind.swings else self.length_unit

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The parts of the programme."""
        return read_programme(self.programme, self.amount, self._amount_unit)[0]

    @property
    def given(self) -> dict[str, float]:
        """The dimensions of the follower that are given, with the defaults that a synthesis leaves."""
        kind = self.kind
        names = (*kind.dimensions, *kind.instead)
        found = {name: value for name in names if (value := getattr(self, name)) is not None}
        return found if self.minimise else {**kind.defaults, **found}

    @cached_property
    def task(self) -> Task:
        """What a synthesis is asked for."""
        limit = self.pressure_angle_limit or _PRESSURE_ANGLES.get(self.follower)
        return Task(
            steps=self.steps,
            unit=radians(1.0) if self.kind.swings else 1.0,
            sense=self.sense or "opposite",
            freedom=freedom(self.follower, self.given, self.amount),
            limits=Limits(
                eccentricity=self.eccentricity_limit or _ECCENTRICITY,
                curvature_radius=self.curvature_limit,
                pressure_angle=None if limit is None else radians(limit),
                base_radius=0.0 if self.bore is None else self.bore * (0.5 + 1e-6),
            ),
        )

    @cached_property
    def compared(self) -> Mapping[str, Optimum]:
        """The optima with every fixed law, which a spline must better; none without a spline that is free."""
        if not self.minimise or self.law not in (None, SPLINE):
            return {}
        return {name: least_area(self.task, name, 0) for name in FIXED_LAWS}

    @cached_property
    def optimum(self) -> Optimum | None:
        """The cam of least area; None where none is asked for."""
        if not self.minimise:
            return None
        if self.law is not None and self.law != SPLINE:
            return least_area(self.task, self.law, 0)
        return least_area_spline(self.task, self.compared, self.free_values or _FREE_VALUES)

    @property
    def _placed(self) -> Mapping[str, float]:
        """The dimensions, without a synthesis where there is none to choose."""
        return self.dimensions if self.task.freedom.variables else self.given

    @property
    def dimensions(self) -> Mapping[str, float]:
        """All dimensions of the follower, given or found; angles in degrees."""
        return self.given if self.optimum is None else self.optimum.dimensions

    @cached_property
    def displacement(self) -> Displacement:
        """The follower's position over the turn: radians, or lengths."""
        if self.optimum is not None:
            return self.optimum.displacement
        values = np.array(self.spline_values or ())
        law = FIXED_LAWS.get(self.law or "cycloidal")
        count = 0 if law else len(values) // moves_of(self.steps)
        return Movement(steps=self.steps, unit=self.task.unit, law=law, count=count).displacement(values)

    @cached_property
    def traced(self) -> Profile:
        """The disk's outline as the follower makes it."""
        return profile_of(self.follower, self.dimensions, self.sense or "opposite", self.displacement)

    @cached_property
    def solid(self) -> Solid:
        """The section extruded over the thickness."""
        return self._disk(self.profile)

    @cached_property
    def profile(self) -> Section:
        """The disk's section, with its bore."""
        return self._section(self.traced.loop)

    def _disk(self, section: Section) -> Swept:
        return Swept(section=section, motion=Straight(), ends=between(0.0, self.thickness))

    def _section(self, outline: Loop) -> Section:
        bore = () if self.bore is None else (Loop(curves=(Arc(radius=self.bore / 2.0, interval=(0.0, -2.0 * np.pi)),)),)
        return Section(loops=(outline, *bore))

    def polygon(self) -> Array:
        """Vertices (n, 2) on the profile at equal steps of the cam angle, the first at 0."""
        return self.traced.points(2.0 * np.pi * np.arange(self.vertices) / self.vertices)

    def polygon_properties(self, density: float = 1.0) -> MassProperties | None:
        """Those of the disk with the polygon for its outline; None where that is none, or the bore cuts it."""
        try:
            section = self._section(polygon_loop(self.polygon(), "the polygon", 1))
            section.require_simple()
        except GeometryError:
            return None
        return self._disk(section).properties(density)

    def beside(self, density: float = 1.0) -> dict[str, MassProperties]:
        polygon = self.polygon_properties(density)
        return {} if polygon is None else {"polygon": polygon}

    def diagram(self, path: str | Path) -> None:
        """Draws the disk and the follower's motion into a PNG or SVG file. Raises FileError, MachineError."""
        from .diagram import draw

        draw(self, Path(path))

    @property
    def description(self) -> str:
        law = (self.optimum.law if self.optimum else None) or self.law or "cycloidal"
        movement = f"{self.amount:g}°" if self.kind.swings else f"{self.amount:g} {self.length_unit}"
        return f"{self.follower.replace('-', ' ')} follower, {movement}, {law}"

    @property
    def remarks(self) -> list[str]:
        return remarks_of(self)

    @property
    def findings(self) -> dict[str, Any]:
        return findings_of(self)

    def sizes(self) -> dict[str, Size]:
        """Radii, curvature, contact, area, motion."""
        return sizes_of(self)

    def views(self) -> tuple[View, ...]:
        return cam_views(self)

    def data_rows(self) -> tuple[Row, ...]:
        return cam_rows(self)

    def tables(self) -> tuple[Table, ...]:
        return (lift_table(self),)

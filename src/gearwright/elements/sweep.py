"""Sweeps of plane sections: extruded, along a path in space, or revolved."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from ..arrays import Array
from ..curves.frames import FRAMES
from ..curves.path import Path
from ..errors import FileError, ProblemsError
from ..motions.along import Along
from ..motions.ends import between
from ..motions.transform import polynomial_transform
from ..motions.transforming import Transforming
from ..parameters import Problems, Size, declared
from ..sections.drawings import Drawing, read
from ..sections.plane import Section
from ..solids.solid import Solid
from ..solids.sweeps import extrude, revolve, sweep_along
from ..solids.swept import Swept
from . import declarations as d
from . import refusals
from .element import Element
from .path_forms import PATH, path_given
from .remarks import other_unit, passed_over
from .section_forms import AROUND, LAYER, SECTION, section_in
from .transform_forms import TRANSFORM, too_large

_WAYS: dict[str, tuple[str, ...]] = {
    "length": ("twist", "scale", "skew", "transform"),
    "path": ("frame", "twist", "scale", "transform"),
    "angle": (),
}
"""The parameters of which one says how the section moves, and those that apply to each."""

_MOST_TWIST_ALONG = 18_000.0  # degrees, whose sines a smooth function of the path's length still gives to rounding

_UNCHANGED: dict[str, object] = {
    "frame": None,
    "twist": 0.0,
    "scale": (1.0, 1.0),
    "skew": (0.0, 0.0),
    "transform": None,
}


@dataclass(frozen=True, kw_only=True, repr=False)
class Sweep(Element):
    """A plane section swept: straight over a length, along a path in space, or about its y axis by an angle.

    Frame: a straight sweep stands on z = 0 along +z; a path is where its coordinates say, the section's origin on
    it; of a revolution the section's y axis becomes z and its x the radius, from azimuth 0 on. Twist and scale (and
    skew, of a straight sweep) grow evenly with the height or the fraction of the path's length.
    Raises ParameterError with every problem found; MachineError where a file cannot be read.
    """

    section: str | Mapping[str, Any] = declared(SECTION)
    layer: str | None = declared(LAYER, default=None)
    around: tuple[float, float] | None = declared(AROUND, default=None)
    length: float | None = declared(d.SWEEP_LENGTH, default=None)
    path: str | tuple[Any, ...] | Mapping[str, Any] | None = declared(PATH, default=None)
    angle: float | None = declared(d.SWEEP_ANGLE, default=None)
    frame: str | None = declared(d.FRAME, default=_UNCHANGED["frame"])
    twist: float = declared(d.TWIST, default=_UNCHANGED["twist"])
    scale: tuple[float, float] = declared(d.SCALE, default=_UNCHANGED["scale"])
    skew: tuple[float, float] = declared(d.SKEW, default=_UNCHANGED["skew"])
    transform: Mapping[str, Any] | None = declared(TRANSFORM, default=None)
    length_unit: str = declared(d.LENGTH_UNIT, default="mm")

    def __post_init__(self) -> None:
        problems = Problems(self)
        ways = [name for name in _WAYS if getattr(self, name) is not None]
        if len(ways) == 1:
            self._check_changes(problems, ways[0])
        else:
            problems.add(ways[0] if ways else "length", refusals.one_way(ways))
        for name in ("layer", "around"):
            if not isinstance(self.section, str) and getattr(self, name) is not None:
                problems.add(name, refusals.NO_DRAWING)
        if problems.sound("layer", "around"):
            self._check_thing(problems, "section", lambda: self.outline)
        if self.path is not None:
            self._check_thing(problems, "path", lambda: self.way)
        if problems.sound():
            self._check_thing(problems, ways[0] if self.transform is None else "transform", lambda: self.solid)
        problems.raise_any()

    def _check_changes(self, problems: Problems, way: str) -> None:
        given = [name for name, unchanged in _UNCHANGED.items() if getattr(self, name) != unchanged]
        for name in given:
            if name not in _WAYS[way] and problems.sound(name):
                owners = [owner for owner, names in _WAYS.items() if name in names]
                problems.add(name, refusals.not_of_this_way(way, owners))
        if self.transform is not None and any(name in given for name in ("twist", "scale", "skew")):
            problems.add("transform", refusals.TRANSFORM_WITH_TWIST)
        if way == "path" and problems.sound("twist") and abs(self.twist) > _MOST_TWIST_ALONG:
            problems.add("twist", refusals.TWIST_ALONG)
        if self.transform is not None and problems.sound("transform", "length"):
            for problem in too_large(self.transform, 1.0 if self.length is None else self.length):
                problems.add("transform", problem)

    def _check_thing(self, problems: Problems, name: str, build: Callable[[], object]) -> None:
        """Adds what keeps the thing that the named parameter gives from being built."""
        if not problems.sound(name):
            return
        try:
            build()
        except ProblemsError as error:
            problems.add_of(name, error)
        except FileError as error:
            said = str(error).removeprefix(f"{getattr(self, name)}: ")
            problems.add(name, said.replace("\n", "\n  "))

    @property
    def kind(self) -> Literal["length", "path", "angle"]:
        """Which of the parameters says how the section moves."""
        return "length" if self.length is not None else "path" if self.path is not None else "angle"

    @cached_property
    def outline(self) -> Section:
        """The section, read from its drawing or made from its table."""
        if self.drawing is None:
            return section_in(self.section)  # type: ignore[arg-type]
        section = Section(loops=self.drawing.region(self.around))
        section.require_simple()
        return section

    @property
    def profile(self) -> Section:
        """The section before it is moved."""
        return self.outline

    @cached_property
    def drawing(self) -> Drawing | None:
        """What the section's file shows; None for a table."""
        return read(self.section, layer=self.layer) if isinstance(self.section, str) else None

    @cached_property
    def way(self) -> Path | None:
        """The path in space, read from its file or made from its points or table."""
        return None if self.path is None else path_given(self.path)

    @cached_property
    def solid(self) -> Solid:
        """The section swept so."""
        if self.length is not None:
            if self.transform is None:
                return extrude(self.outline, self.length, self.twist, self.scale, self.skew)
            mapping = polynomial_transform(self.transform, self.length)
            return Swept(section=self.outline, motion=Transforming(transform=mapping), ends=between(0.0, self.length))
        if self.way is None:
            return revolve(self.outline, 360.0 if self.angle is None else self.angle)
        frame = self.frame or next(iter(FRAMES))
        if self.transform is None:
            return sweep_along(self.outline, self.way, frame, self._growing if self._changes else None)
        motion = Along(frame=FRAMES[frame](self.way), transform=polynomial_transform(self.transform, 1.0))
        return Swept(section=self.outline, motion=motion, ends=between(0.0, 1.0))

    @property
    def _changes(self) -> bool:
        return self.twist != 0.0 or self.scale != (1.0, 1.0)

    def _growing(self, fraction: float) -> Array:
        """R(twist·fraction) diag(1 + (scale − 1) fraction) (2, 2): as `extrude` has it in the height."""
        angle = np.radians(self.twist * fraction)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        return turn * (1.0 + (np.array(self.scale) - 1.0) * fraction)

    @property
    def remarks(self) -> list[str]:
        if self.drawing is None:
            return []
        stated = self.drawing.length_unit
        return [*other_unit(str(self.section), stated, self.length_unit), *passed_over(self.drawing.passed_over)]

    @property
    def description(self) -> str:
        unit = self.length_unit
        if self.length is not None:
            moved = f"extruded over {self.length:.6g} {unit}"
        elif self.way is not None:
            moved = f"along a path of {self.way.length:.6g} {unit}"
        else:
            moved = f"revolved by {self.angle:g}°"
        changes = [
            *([f"twisted by {self.twist:g}°"] if self.twist else []),
            *(["scaled"] if self.scale != (1.0, 1.0) else []),
            *(["skewed"] if self.skew != (0.0, 0.0) else []),
            *(["transformed"] if self.transform is not None else []),
        ]
        return ", ".join([moved, *changes])

    def sizes(self) -> dict[str, Size]:
        """Those of the section, and how far it is swept."""
        section = self.outline.properties()
        found = {
            "section_area": Size(section.area, "area", "A", "area of the section at the start"),
            "section_perimeter": Size(section.perimeter, "length", "U", "length of its outlines, holes included"),
        }
        if self.length is not None:
            found["length"] = Size(self.length, "length", "L", "length along z")
        elif self.way is not None:
            found["path_length"] = Size(self.way.length, "length", "L", "length of the path")
        else:
            arc = float(np.radians(self.angle or 0.0) * section.centroid[0])
            found["centroid_path"] = Size(
                arc, "length", "L_c", "length of the arc that the section's centroid describes"
            )
        return found

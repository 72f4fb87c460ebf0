"""Solids to files: with the smooth faces they have where the format holds such, else as polyhedra."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Protocol

import numpy as np

from ..arrays import Array
from ..boundary.boundary import Boundary
from ..boundary.extent import rough_diagonal
from ..colours import Colour
from ..errors import FileError, GeometryError, Problem
from ..files.assembly import Assembly, Part, Smooth
from ..files.formats import format_of
from ..files.step.writer import write as write_step
from ..files.writing import save_polygons
from .clearance import with_clearance
from .polyhedron import Polyhedron
from .properties import MassProperties

SMOOTH_TOLERANCE = 1e-7
"""How far smooth faces in a file may lie from the solid's, in diagonals of its bounding box, where nothing is said."""

_ROUNDING = 2e-11
"""Of the largest coordinate: what sixteen digits leave far from the origin, with room."""


class Shape(Protocol):
    """What has a boundary, properties, and polyhedra within tolerances of it: solids, elements."""

    @property
    def boundary(self) -> Boundary: ...
    def properties(self, density: float = 1.0) -> MassProperties: ...
    def polyhedron(self, tolerance: float | None = None) -> Polyhedron: ...


@dataclass(frozen=True, kw_only=True, eq=False)
class PlacedSolid:
    """A solid, where it stands and how it is to be written.

    name              as a person reads it
    placement         (4, 4) rigid motion that puts it in its place
    tolerance         how far (length) written faces may lie from its own; None: SMOOTH_TOLERANCE or smooth_tolerance
                      for smooth faces, 1e-4 × bounding diagonal for chords
    smooth_tolerance  what suits this solid
    clearance         gap (length) that its polyhedron leaves to others that would touch it
    """

    name: str
    solid: Shape
    placement: Array = field(default_factory=lambda: np.eye(4))
    colour: Colour | None = None
    tolerance: float | None = None
    smooth_tolerance: float | None = None
    clearance: float = 0.0

    @cached_property
    def polyhedron(self) -> Polyhedron:
        """In the solid's own frame."""
        return with_clearance(self.solid.polyhedron(self.tolerance), self.clearance)

    @property
    def smooth(self) -> Smooth:
        """In the solid's own frame."""
        return smooth(self.solid.boundary, self.smooth_tolerance if self.tolerance is None else self.tolerance)


def smooth(boundary: Boundary, tolerance: float | None = None) -> Smooth:
    """Smooth faces within a tolerance (length), by default SMOOTH_TOLERANCE. Raises GeometryError if it is none."""
    size = rough_diagonal(boundary)
    if tolerance is None:
        farthest = max(float(np.abs(edge.curve.start).max()) for edge in boundary.edges)
        tolerance = max(SMOOTH_TOLERANCE * size, _ROUNDING * farthest)
    if not 0.0 < tolerance < np.inf:
        wanted = "a finite length greater than 0 is needed"
        raise GeometryError("No smooth faces have this tolerance", [Problem(f"tolerance = {tolerance:g}", wanted)])
    if tolerance > size:
        wanted = f"more than the whole body, whose diagonal is {size:.6g}; is it in the right unit?"
        raise GeometryError("No smooth faces have this tolerance", [Problem(f"tolerance = {tolerance:g}", wanted)])
    return Smooth(boundary=boundary, tolerance=tolerance)


def save_solids(
    path: str | Path,
    solids: Sequence[PlacedSolid],
    *,
    name: str,
    length_unit: str | None,
    density: str | float | None = None,
    step_schema: str | None = None,
) -> None:
    """Writes solids where they stand to one file in the format of its suffix, whole or not at all.

    density       the name of a material, or kg/m³, for a format that holds masses and for no other
    step_schema   "AP214", which None stands for, or "AP242", for STEP and no other format

    Raises FileError, MachineError; GeometryError where a tolerance cannot be met.
    """
    from .robots import density_for, mechanism_of, save_mechanism

    clearance = max(solid.clearance for solid in solids)
    needed = density_for(path, density, clearance=clearance, step_schema=step_schema)
    if needed is not None:
        save_mechanism(path, mechanism_of(name, solids, needed, length_unit or ""))
    elif format_of(path, "written").holds == "smooth faces":
        refuse_clearance(path, clearance)
        write_step(path, smooth_of(solids, name=name, length_unit=length_unit), schema=(step_schema or "AP214").upper())
    else:
        refuse_schema(path, step_schema)
        save_polygons(path, polyhedra_of(solids, name=name, length_unit=length_unit))


def polyhedra_of(solids: Sequence[PlacedSolid], *, name: str, length_unit: str | None) -> Assembly[Polyhedron]:
    """Solids where they stand, as polyhedra. Raises GeometryError where a tolerance cannot be met."""
    parts = tuple(Part(name=s.name, shape=s.polyhedron, placement=s.placement, colour=s.colour) for s in solids)
    return Assembly(name=name, parts=parts, length_unit=length_unit)


def refuse_clearance(path: str | Path, clearance: float) -> None:
    """Raises FileError for a clearance in a file of anything but polygons."""
    if clearance:
        raise FileError(
            f"{path}: clearance = {clearance:g} moves faces of polyhedra for printing, and this format holds others;"
            " leave it out and give the parts their play themselves: backlash, tip clearance, smaller bores; or write"
            " polygons, as .3mf or .stl"
        )


def refuse_schema(path: str | Path, step_schema: str | None) -> None:
    """Raises FileError for a schema in a file that is no STEP file."""
    if step_schema is not None:
        raise FileError(f"{path}: {step_schema} is a schema of STEP files; leave it out, or write .step")


def smooth_of(solids: Sequence[PlacedSolid], *, name: str, length_unit: str | None) -> Assembly[Smooth]:
    """Solids where they stand, with their smooth faces. Raises GeometryError for a tolerance that is none."""
    parts = tuple(Part(name=s.name, shape=s.smooth, placement=s.placement, colour=s.colour) for s in solids)
    return Assembly(name=name, parts=parts, length_unit=length_unit)

"""Parts where they stand: written together or apart, and drawn."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np

from ..arrays import Array
from ..colours import BRASS, STEEL
from ..disk import folder
from ..files.assembly import Assembly
from ..solids.polyhedron import Polyhedron
from ..solids.saving import PlacedSolid, Shape, polyhedra_of, save_solids

if TYPE_CHECKING:
    from ..pictures import View


class Drawn(Shape, Protocol):
    """A part that is written and drawn."""

    @property
    def smooth_tolerance(self) -> float | None: ...


class Described(Drawn, Protocol):
    """A part that says what it is."""

    @property
    def upward(self) -> Literal[1, -1]: ...
    @property
    def description(self) -> str: ...


@dataclass(frozen=True, kw_only=True, eq=False)
class PlacedPart:
    """A part in its own frame, and the rigid motion (4, 4) that puts it in place.

    name       what its file is called
    label      what stands beside it in a picture
    upward     which way the axis, z, points when the part is drawn alone, so that its teeth are seen
    tolerance  how far (length) what is written or drawn may lie from its surface; None for the defaults
    clearance  gap (length) that what is written leaves to parts that would touch it
    """

    name: str
    label: str
    element: Drawn
    placement: Array
    upward: Literal[1, -1] = 1
    tolerance: float | None = None
    clearance: float = 0.0

    @cached_property
    def solid(self) -> PlacedSolid:
        """What is written of it."""
        return PlacedSolid(
            name=self.name,
            solid=self.element,
            placement=self.placement,
            tolerance=self.tolerance,
            smooth_tolerance=self.element.smooth_tolerance,
            clearance=self.clearance,
        )

    @property
    def polyhedron(self) -> Polyhedron:
        """In the part's own frame."""
        return self.solid.polyhedron

    @property
    def placed(self) -> Polyhedron:
        return self.polyhedron.transformed(self.placement)


def placed_parts(
    parts: Mapping[str, Described], where: Iterable[Array], tolerance: float | None, clearance: float = 0.0
) -> list[PlacedPart]:
    """Parts by name where they stand, to be written or drawn within a tolerance and with a clearance (lengths)."""
    return [
        PlacedPart(
            name=name,
            label=f"{name}\n{part.description}" if len(parts) > 1 else "",
            element=part,
            placement=placement,
            upward=part.upward,
            tolerance=tolerance,
            clearance=clearance,
        )
        for (name, part), placement in zip(parts.items(), where, strict=True)
    ]


def in_colours(parts: Sequence[PlacedPart]) -> list[PlacedSolid]:
    """What is written of the parts, brass and steel by turns."""
    return [replace(part.solid, colour=(BRASS, STEEL)[i % 2]) for i, part in enumerate(parts)]


def save_parts(
    parts: Sequence[PlacedPart],
    path: Path,
    length_unit: str,
    *,
    suffix: str = ".stl",
    placed: bool = False,
    step_schema: str | None = None,
) -> list[Path]:
    """Writes all parts in place to one file, if the path has a suffix, else each to a file in a folder.

    suffix        of the files in a folder
    placed        in a folder, too, each part is written where it stands, and not in its own frame
    step_schema   of STEP files, as of `save_solids`

    Gives the files written. Raises FileError, MachineError; GeometryError where a tolerance cannot be met.
    """
    solids = in_colours(parts)
    if path.suffix:
        folder(path.parent)
        save_solids(path, solids, name=path.stem, length_unit=length_unit, step_schema=step_schema)
        return [path]
    files = [folder(path) / f"{part.name.replace(' ', '-')}{suffix}" for part in parts]
    for solid, file in zip(solids, files, strict=True):
        where = solid.placement if placed else np.eye(4)
        one = [replace(solid, placement=where)]
        save_solids(file, one, name=solid.name, length_unit=length_unit, step_schema=step_schema)
    return files


def polyhedra(parts: Sequence[PlacedPart], name: str, length_unit: str) -> Assembly[Polyhedron]:
    """Parts where they stand, in their colours. Raises GeometryError where a tolerance cannot be met."""
    return polyhedra_of(in_colours(parts), name=name, length_unit=length_unit)


def alone(upward: Literal[1, -1]) -> View:
    """From where a part is seen alone, so that its teeth are seen."""
    from ..pictures import View

    return View(direction=(0.35, 0.8, 0.75 * upward), up=(0.0, 0.0, float(upward)))


def draw_parts(parts: Sequence[PlacedPart], path: Path, title: str, length_unit: str) -> None:
    """Draws all parts in place into a PNG file. Raises FileError, MachineError."""
    from ..pictures import Body, picture  # matplotlib and numba load only to draw

    bodies = [
        Body(vertices=body.vertices, triangles=body.triangles(), colour=(BRASS, STEEL)[i % 2], label=part.label)
        for i, part in enumerate(parts)
        for body in [part.placed]
    ]
    folder(path.parent)
    view = alone(parts[0].upward) if len(parts) == 1 else None
    picture(bodies, path, title=title, view=view, length_unit=length_unit)

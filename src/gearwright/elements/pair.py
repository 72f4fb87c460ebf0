"""The concept of a pair: two parts in mesh."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, ParameterError, Problem
from ..files.assembly import Assembly
from ..files.robots.mechanism import Mechanism
from ..parameters import Size, spelled
from ..sections.drawings import Profile
from ..sections.drawings import write as write_profiles
from ..sheets.writing import require_suffix, write
from ..solids.polyhedron import Polyhedron
from ..solids.robots import density_for, refuse_density, save_mechanism
from . import refusals
from .assembly import PlacedPart, draw_parts, placed_parts, polyhedra, save_parts
from .data_rows import mate_rows
from .element import Element
from .following import Following, part_mechanism
from .sheets import SheetLabels, element_sheet, spoken

if TYPE_CHECKING:
    import pyvista
    import trimesh

    from ..viewer.turning_view import TurningView


class Pair(ABC):
    """Two parts that run together: the pinion, and the gear that it drives."""

    length_unit: str

    @property
    @abstractmethod
    def pinion(self) -> Element:
        """The first member, in its own frame."""

    @property
    @abstractmethod
    def gear(self) -> Element:
        """The second member, in its own frame."""

    @property
    def members(self) -> dict[str, Element]:
        """Both by name, the pinion first."""
        return {"pinion": self.pinion, "gear": self.gear}

    @property
    @abstractmethod
    def description(self) -> str:
        """A few words that tell this pair from others."""

    @abstractmethod
    def placements(self, turn: float = 0.0) -> tuple[Array, Array]:
        """Rigid motions (4, 4) of pinion and gear into mesh, with the pinion turned by so many degrees."""

    @property
    @abstractmethod
    def following(self) -> Following:
        """How the gear follows the pinion, which turns about its own +z: what `placements` does with the turn."""

    @abstractmethod
    def sizes(self) -> dict[str, Size]:
        """Sizes of the pair; each member has its own."""

    @property
    def remarks(self) -> list[str]:
        """What is unusual about the pair, though it can be built."""
        return []

    def parts(self, tolerance: float | None = None, turn: float = 0.0) -> list[PlacedPart]:
        """Both members where they mesh, to be written or drawn within a tolerance (length).

        turn   of the pinion (degrees). Raises ParameterError where that is no angle.
        """
        if not np.isfinite(turn):
            raise ParameterError("This pair", [Problem(f"turn = {turn}", "a finite angle in degrees is needed")])
        return placed_parts(self.members, self.placements(turn), tolerance)

    def mechanism(
        self, name: str, density: str | float, tolerance: float | None = None, turn: float = 0.0
    ) -> Mechanism:
        """Both members on joints, for simulators: the pinion turns about its axis, the gear follows.

        name        what the model and the folder of its meshes are called after
        density     the name of a material, or kg/m³
        tolerance   of the meshes (length); mass and inertia are exact
        turn        of the pinion (degrees) where the joints are at 0

        Raises ParameterError for a density that is none; GeometryError where the tolerance cannot be met.
        """
        return part_mechanism(name, self.parts(tolerance, turn), density, self.length_unit, self.following, turn)

    def save(
        self,
        path: str | Path,
        tolerance: float | None = None,
        *,
        clearance: float = 0.0,
        density: str | float | None = None,
        step_schema: str | None = None,
        suffix: str = ".stl",
        turn: float = 0.0,
    ) -> None:
        """Writes both members in mesh to one file, or, if the path has no suffix, each in its own frame to a folder.

        clearance     gap (length) between the printed members where they would touch, as of `Solid.save`
        density       the name of a material, or kg/m³: needed where the format holds masses, refused elsewhere
        step_schema   "AP214", which None stands for, or "AP242", of a STEP file
        suffix        of the files in a folder, which is their format
        turn          of the pinion in the file of both (degrees); the gear follows

        Raises FileError, MachineError; GeometryError where tolerance or clearance cannot be met.
        """
        parts = [replace(part, clearance=clearance) for part in self.parts(tolerance, turn)]
        if not Path(path).suffix:
            refuse_density(path, density)
        elif (needed := density_for(path, density, clearance=clearance, step_schema=step_schema)) is not None:
            save_mechanism(path, self.mechanism(Path(path).stem, needed, tolerance, turn))
            return
        save_parts(parts, Path(path), self.length_unit, suffix=suffix, step_schema=step_schema)

    def to_ocp(self, tolerance: float | None = None, turn: float = 0.0) -> Any:
        """Both members in mesh as a compound of Open CASCADE (OCP.TopoDS), pinion first; see `Solid.to_ocp`."""
        from ..files.step.brep.shape import together

        members = self.members.values()
        return together((m.to_ocp(tolerance), p) for m, p in zip(members, self.placements(turn), strict=True))

    def save_drawing(self, path: str | Path) -> None:
        """Writes the profiles of both members in mesh, each on its own layer, as a DXF or SVG drawing.

        Raises GeometryError where the members have no plane section; FileError, MachineError.
        """
        profiles = []
        for (layer, member), placement in zip(self.members.items(), self.placements(), strict=True):
            if member.profile is None:
                raise GeometryError("This pair cannot be drawn", [Problem(self.description, refusals.NO_PROFILE)])
            turn, shift = float(np.arctan2(placement[1, 0], placement[0, 0])), (placement[0, 3], placement[1, 3])
            profiles.append(Profile(section=member.profile, layer=layer, turn=turn, shift=shift))
        write_profiles(path, profiles, length_unit=self.length_unit)

    def save_sheet(self, path: str | Path, labels: SheetLabels | None = None) -> None:
        """Writes a drawing sheet for each member, the pinion's first, to one file: pages of a PDF, one below another
        in DXF and SVG. The data of each say what its mate is and how they are mounted.

        Raises FileError; MachineError; ParameterError for labels that are none.
        """
        require_suffix(path)
        sheets = []
        for k, (name, member) in enumerate(self.members.items()):
            own = labels or SheetLabels()
            named = own if own.name is None else replace(own, name=f"{own.name}, {name}")
            more = mate_rows(self, k, member.data_rows())
            title = f"{spoken(type(member).__name__)} ({name})"
            sheets.append(element_sheet(member, named, title=title, more=more, number=(k + 1, 2)))
        write(path, sheets, self.description)

    def picture(self, path: str | Path, tolerance: float | None = None, turn: float = 0.0) -> None:
        """Draws both members in mesh into a PNG file, the pinion turned by so many degrees.

        Raises FileError, MachineError.
        """
        draw_parts(self.parts(tolerance, turn), Path(path), self.description, self.length_unit)

    def assembly(self, tolerance: float | None = None, turn: float = 0.0) -> Assembly[Polyhedron]:
        """Polyhedra of both members where they mesh. Raises GeometryError where the tolerance cannot be met."""
        return polyhedra(self.parts(tolerance, turn), self.description, self.length_unit)

    def to_trimesh(self, tolerance: float | None = None, turn: float = 0.0) -> trimesh.Scene:
        """Polyhedra of both members in mesh as a scene of trimesh. Raises MachineError, GeometryError."""
        from ..bridges.as_trimesh import trimesh_scene

        return trimesh_scene(self.assembly(tolerance, turn))

    def to_pyvista(self, tolerance: float | None = None, turn: float = 0.0) -> pyvista.MultiBlock:
        """Polyhedra of both members in mesh as blocks of PyVista. Raises MachineError, GeometryError."""
        from ..bridges.as_pyvista import pyvista_blocks

        return pyvista_blocks(self.assembly(tolerance, turn))

    def show(self, tolerance: float | None = None) -> TurningView:
        """A view of both members in mesh that a notebook shows, turns and runs. Raises GeometryError."""
        from ..viewer.turning import STEP, Turning
        from ..viewer.turning_view import TurningView
        from .summaries import title_of

        turnings = tuple(map(Turning.between, self.placements(), self.placements(STEP)))
        return TurningView(title=title_of(self), assembly=self.assembly(tolerance), turnings=turnings)

    def __repr__(self) -> str:
        return spelled(self)

    def _repr_html_(self) -> str:
        from .summaries import pair_summary

        return pair_summary(self)

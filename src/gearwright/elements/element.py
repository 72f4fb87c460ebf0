"""The concept of an element: frozen parameters that yield a solid."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..boundary.boundary import Boundary
from ..errors import GeometryError, Problem
from ..files.assembly import Assembly
from ..files.robots.mechanism import Mechanism
from ..parameters import MILLIMETRES, Problems, Size, spelled
from ..sections.plane import Section
from ..sheets.content import Row, Table
from ..sheets.views import View
from ..sheets.writing import require_suffix, write
from ..solids.polyhedron import Polyhedron
from ..solids.properties import MassProperties
from ..solids.robots import density_for, save_mechanism
from ..solids.saving import save_solids
from ..solids.solid import Solid
from . import refusals
from .assembly import PlacedPart, alone, draw_parts, polyhedra
from .data_rows import all_rows
from .following import part_mechanism
from .sheets import SheetLabels, element_sheet, spoken

if TYPE_CHECKING:
    import pyvista
    import trimesh

    from ..viewer.turning_view import TurningView


class Element(ABC):
    """One part: its parameters are its fields, its shape is `solid`, in its own frame and length unit."""

    length_unit: str

    @property
    @abstractmethod
    def description(self) -> str:
        """A few words that tell this part from others of its kind, for labels and titles."""

    @property
    @abstractmethod
    def solid(self) -> Solid:
        """The part as section + motion + ends."""

    @abstractmethod
    def sizes(self) -> dict[str, Size]:
        """Derived sizes by name."""

    @property
    def profile(self) -> Section | None:
        """The plane section that the part is made from, as a drawing shows it; None where it has no plane one."""
        return None

    @property
    def upward(self) -> Literal[1, -1]:
        """Which way z points in a picture of the part alone."""
        return 1

    @property
    def remarks(self) -> list[str]:
        """What is unusual about the part, though it can be built."""
        return []

    @property
    def findings(self) -> dict[str, Any]:
        """What was found out about the part besides its sizes, as plain values for programs."""
        return {}

    @property
    def boundary(self) -> Boundary:
        return self.solid.boundary

    def properties(self, density: float = 1.0) -> MassProperties:
        """Volume, centroid and inertia; density in mass per cubed length unit."""
        return self.solid.properties(density)

    def beside(self, density: float = 1.0) -> dict[str, MassProperties]:
        """Properties of named approximations, to be shown beside the part's own."""
        del density
        return {}

    def polyhedron(self, tolerance: float | None = None) -> Polyhedron:
        """A watertight polyhedron within a chord tolerance (length); default 1e-4 × bounding diagonal."""
        return self.solid.polyhedron(tolerance)

    @property
    def smooth_tolerance(self) -> float | None:
        """How far (length) smooth faces in a file may lie from the part's; None where it has no size of its own."""
        return None

    def save(
        self,
        path: str | Path,
        tolerance: float | None = None,
        *,
        clearance: float = 0.0,
        density: str | float | None = None,
        step_schema: str | None = None,
    ) -> None:
        """Writes a file in the format of its suffix: smooth faces or a polyhedron, within a tolerance (length).

        clearance     gap (length) between printed parts that would touch, as of `Solid.save`
        density       the name of a material, or kg/m³: needed where the format holds masses, refused elsewhere
        step_schema   "AP214", which None stands for, or "AP242", of a STEP file

        Raises FileError, MachineError; GeometryError where tolerance or clearance cannot be met.
        """
        name = Path(path).stem
        if (needed := density_for(path, density, clearance=clearance, step_schema=step_schema)) is not None:
            save_mechanism(path, self.mechanism(name, needed, tolerance))
            return
        solid = replace(self._part(tolerance).solid, name=name, clearance=clearance)
        save_solids(path, [solid], name=name, length_unit=self.length_unit, step_schema=step_schema)

    def to_ocp(self, tolerance: float | None = None) -> Any:
        """The part as a shape of Open CASCADE (OCP.TopoDS), in its length unit; see `Solid.to_ocp`."""
        return self.solid.to_ocp(self.smooth_tolerance if tolerance is None else tolerance)

    def mechanism(self, name: str, density: str | float, tolerance: float | None = None) -> Mechanism:
        """The part as a free body for simulators. Arguments and errors as those of `Pair.mechanism`."""
        return part_mechanism(name, [self._part(tolerance)], density, self.length_unit)

    def save_drawing(self, path: str | Path) -> None:
        """Writes the profile as a DXF or SVG drawing, arcs and splines as they are.

        Raises GeometryError where the part has no plane section; FileError, MachineError.
        """
        if self.profile is None:
            raise GeometryError("This part cannot be drawn", [Problem(self.description, refusals.NO_PROFILE)])
        self.profile.save(path, length_unit=self.length_unit)

    def views(self) -> tuple[View, ...]:
        """What a sheet shows of the part: views in the part's own lengths."""
        from .prismatic_views import any_views

        return any_views(self)

    def data_rows(self) -> tuple[Row, ...]:
        """The rows of a sheet's data table."""
        return tuple(all_rows(self.sizes(), self.length_unit))

    def tables(self) -> tuple[Table, ...]:
        """Further tables of a sheet."""
        return ()

    def save_sheet(self, path: str | Path, labels: SheetLabels | None = None) -> None:
        """Writes a drawing sheet with views, dimensions, data and a title block, as DXF, SVG or PDF.

        Raises FileError; MachineError; ParameterError for labels that are none.
        """
        require_suffix(path)
        title = spoken(type(self).__name__)
        write(path, [element_sheet(self, labels or SheetLabels(), title=title)], f"{title}, {self.description}")

    def picture(self, path: str | Path, tolerance: float | None = None) -> None:
        """Draws the part into a PNG file. Raises FileError, MachineError."""
        draw_parts([self._part(tolerance)], Path(path), self.description, self.length_unit)

    def assembly(self, tolerance: float | None = None) -> Assembly[Polyhedron]:
        """The part's polyhedron with its name and colour. Raises GeometryError where the tolerance cannot be met."""
        return polyhedra([replace(self._part(tolerance), name=self.description)], self.description, self.length_unit)

    def to_trimesh(self, tolerance: float | None = None) -> trimesh.Trimesh:
        """Its polyhedron as a mesh of trimesh. Raises MachineError without it; GeometryError as `assembly`."""
        from ..bridges.as_trimesh import trimesh_mesh

        return trimesh_mesh(self.assembly(tolerance).parts[0], self.length_unit)

    def to_pyvista(self, tolerance: float | None = None) -> pyvista.PolyData:
        """Its polyhedron as a mesh of PyVista. Raises MachineError without it; GeometryError as `assembly`."""
        from ..bridges.as_pyvista import pyvista_mesh

        return pyvista_mesh(self.assembly(tolerance).parts[0], self.length_unit)

    def show(self, tolerance: float | None = None) -> TurningView:
        """A view that a notebook shows and turns. Raises GeometryError as `assembly`."""
        from ..viewer.turning_view import TurningView
        from .summaries import title_of

        return TurningView(title=title_of(self), assembly=self.assembly(tolerance), view=alone(self.upward))

    def __repr__(self) -> str:
        return spelled(self)

    def _repr_html_(self) -> str:
        from .summaries import element_summary

        return element_summary(self)

    def _part(self, tolerance: float | None) -> PlacedPart:
        return PlacedPart(
            name="part", label="", element=self, placement=np.eye(4), upward=self.upward, tolerance=tolerance
        )


SMOOTH = 5e-6
"""How far smooth faces in a file may lie from a gear's, in modules, where nothing is said."""


def module_in(length_unit: str, module: float | None, diametral_pitch: float | None) -> float:
    """Module in the length unit, from the module in mm or the diametral pitch per inch."""
    millimetres = module if module is not None else 25.4 / (diametral_pitch or float("nan"))
    return millimetres / MILLIMETRES[length_unit]


def require_one_pitch(problems: Problems, module: float | None, diametral_pitch: float | None) -> None:
    """Adds a problem unless exactly one of module and diametral pitch is given."""
    if (module is None) == (diametral_pitch is None):
        problems.add("module", refusals.ONE_PITCH)


def require_at_most_one(problems: Problems, element: object, *names: str) -> None:
    """Adds a problem where more than one of several parameters that say the same is given."""
    given = [name for name in names if getattr(element, name) is not None]
    if len(given) > 1:
        problems.add(given[0], refusals.said_twice(given[1:]))

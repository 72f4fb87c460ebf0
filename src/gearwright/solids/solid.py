"""The concept of a solid: a boundary and the moments of what it bounds."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import ArrayLike, numbers_in
from ..boundary.boundary import Boundary
from ..boundary.extent import bounding_box, rough_diagonal, surface_area
from ..boundary.flux import boundary_flux
from ..boundary.sampling import sampling
from ..boundary.tessellation import tessellate
from ..errors import GeometryError, Problem
from ..moments.body import BodyMoments, about_centroid
from ..moments.quadrature import converged
from ..placement import ORTHONORMAL, Placement, require_rotation
from .extent import Extent
from .polyhedron import Polyhedron
from .properties import MassProperties
from .self_intersections import SelfIntersections

if TYPE_CHECKING:
    import pyvista
    import trimesh

    from ..viewer.turning_view import TurningView

DEFAULT_TOLERANCE = 1e-4
"""Chord tolerance of a polyhedron, relative to the diagonal of the bounding box."""


class Solid(ABC):
    """A body with an exact boundary. Lengths are in whatever unit it was built in."""

    @property
    @abstractmethod
    def boundary(self) -> Boundary:
        """Edges, patches and caps."""

    @property
    @abstractmethod
    def moments(self) -> BodyMoments:
        """Moments by the best route the solid has."""

    def properties(self, density: float = 1.0) -> MassProperties:
        """Volume, centroid and inertia; density in mass per cubed length unit."""
        return MassProperties.from_moments(self.moments, density=density, find_extent=partial(_extent, self))

    def polyhedron(self, tolerance: float | None = None) -> Polyhedron:
        """A watertight polyhedron with every chord within the tolerance (length) of the solid's surface.

        Default tolerance: 1e-4 × bounding diagonal. Raises GeometryError where it cannot be met.
        """
        if tolerance is None:
            tolerance = DEFAULT_TOLERANCE * rough_diagonal(self.boundary)
        return Polyhedron(*tessellate(self.boundary, sampling(self.boundary, tolerance)))

    def self_intersections(self, tolerance: float | None = None) -> SelfIntersections:
        """Where its polyhedron of that tolerance passes through itself. Raises GeometryError like `polyhedron`."""
        return self.polyhedron(tolerance).self_intersections()

    def save(
        self,
        path: str | Path,
        tolerance: float | None = None,
        length_unit: str = "mm",
        *,
        clearance: float = 0.0,
        density: str | float | None = None,
        step_schema: str | None = None,
    ) -> None:
        """Writes a file in the format of its suffix: smooth faces or a polyhedron, within a tolerance (length).

        clearance     gap (length) between printed parts that would touch: faces of polyhedra lie half of it deeper
        density       the name of a material, or kg/m³: needed where the format holds masses, refused elsewhere
        step_schema   "AP214", which None stands for, or "AP242", of a STEP file

        Default tolerances: 1e-7 × bounding diagonal for smooth faces, 1e-4 × for chords. Raises FileError, also for
        a clearance of smooth faces; MachineError; GeometryError where tolerance or clearance cannot be met.
        """
        from .saving import PlacedSolid, save_solids

        name = Path(path).stem
        placed = PlacedSolid(name=name, solid=self, tolerance=tolerance, clearance=clearance)
        save_solids(path, [placed], name=name, length_unit=length_unit, density=density, step_schema=step_schema)

    def to_ocp(self, tolerance: float | None = None) -> Any:
        """The solid as a shape of Open CASCADE (OCP.TopoDS), in its own length unit, for CadQuery and build123d.

        Its faces are planes, cylinders, cones, spheres and tori where the solid's are such, else splines within a
        tolerance (length), by default 1e-7 × bounding diagonal. Raises GeometryError where the tolerance cannot be met;
        MachineError without the extra `step`.
        """
        from ..files.step.brep.shape import shape
        from .saving import smooth

        found = smooth(self.boundary, tolerance)
        return shape(found.boundary, found.tolerance)

    def to_trimesh(self, tolerance: float | None = None, *, length_unit: str = "mm") -> trimesh.Trimesh:
        """Its polyhedron as a mesh of trimesh. Raises MachineError without it; GeometryError like `polyhedron`."""
        return self.polyhedron(tolerance).to_trimesh(name="solid", length_unit=length_unit)

    def to_pyvista(self, tolerance: float | None = None, *, length_unit: str = "mm") -> pyvista.PolyData:
        """Its polyhedron as a mesh of PyVista. Raises MachineError without it; GeometryError like `polyhedron`."""
        return self.polyhedron(tolerance).to_pyvista(name="solid", length_unit=length_unit)

    def show(self, tolerance: float | None = None, *, title: str = "solid", length_unit: str = "mm") -> TurningView:
        """A view that a notebook shows and turns. Raises GeometryError like `polyhedron`."""
        return self.polyhedron(tolerance).show(title=title, length_unit=length_unit)

    def _repr_html_(self) -> str:
        from .summaries import solid_summary

        return solid_summary(self)

    def moved(self, rotation: ArrayLike, translation: ArrayLike = (0.0, 0.0, 0.0)) -> Solid:
        """The solid moved by r → R r + t, R (3, 3) a rotation, t (3,).

        Raises GeometryError if R is not a rotation or t not three finite lengths.
        """
        from .moved import Moved

        matrix = require_rotation(rotation, ORTHONORMAL)
        shift = numbers_in(translation, 3)
        if shift is None:
            wanted = "three finite lengths are needed"
            raise GeometryError("A body cannot be moved so", [Problem(f"translation = {translation!r}", wanted)])
        return Moved(solid=self, placement=Placement.of(matrix, shift))

    def __add__(self, other: Solid) -> Solid:
        """Both solids as one, glued wherever plane faces of theirs lie on one another.

        The faces' borders must be the same there, or one strictly inside the other. Raises GeometryError saying
        where if they are not, or if the solids overlap or touch in another way.
        """
        if not isinstance(other, Solid):
            return NotImplemented
        from .composite import Composite

        return Composite(pieces=(self, other))


def _extent(solid: Solid) -> Extent:
    return Extent(surface_area(solid.boundary), bounding_box(solid.boundary))


def flux_moments(boundary: Boundary) -> BodyMoments:
    """Moments by flux through the boundary, with nodes increased until they settle."""
    size = rough_diagonal(boundary)
    unit = np.outer([1.0, size, size, size], [1.0, size, size, size]) * size**3
    scaled, error = converged(lambda nodes: boundary_flux(boundary.patches, boundary.caps, nodes).matrix / unit)
    return about_centroid(scaled * unit, "quadrature", error)

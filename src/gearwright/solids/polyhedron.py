"""Polyhedra: bodies bounded by any planar polygons."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, ArrayLike, Indices
from ..errors import GeometryError, Problem
from ..files import reading
from ..files.assembly import Assembly, Part
from ..files.writing import save_polygons
from ..moments.faces import Corners, Faces, face_vectors, fan_triangles, triangle_vectors
from ..moments.indexed import bounding_box
from ..moments.polyhedron import PolyhedronMoments, polyhedron_moments
from .extent import Extent
from .given_faces import affine_map, corners_of, points_of
from .properties import MassProperties
from .self_intersections import SelfIntersections, find_self_intersections, overlapping
from .shell import shell_properties
from .validity.allowed import allowed_moments
from .validity.kinds import PROBLEMS, ProblemKind, require_kinds
from .validity.report import PolyhedronValidity

if TYPE_CHECKING:
    import pyvista
    import trimesh

    from ..viewer.turning_view import TurningView

_MOST = 1e60
"""Largest coordinate of a body with properties: fifth powers of lengths must be numbers."""


@dataclass(frozen=True, eq=False, init=False)
class Polyhedron:
    """A body bounded by polygon faces that share vertices by number.

    vertices  (n, 3), read-only
    indices   (c,) vertex of every corner, face after face, read-only
    offsets   (f + 1,) face f owns corners offsets[f] to offsets[f + 1] − 1, read-only
    rounding  largest error of a coordinate, as of one in a file that holds few digits: so far are faces allowed to
              be off their planes

    Faces may be any planar polygons, convex or not, of mixed sizes; counter-clockwise seen from outside.
    """

    vertices: Array
    indices: Indices
    offsets: Indices
    rounding: float

    def __init__(self, vertices: ArrayLike, faces: Faces, *, rounding: float = 0.0):
        """From vertices (n, 3) and faces: integers (m, k), lists of vertex numbers of any lengths, or Corners.

        Raises GeometryError, all problems together, if coordinates are not finite, a vertex number is out
        of range, a face has fewer than 3 corners, an array is not of that shape, or the rounding is no length.
        Whether the faces close is the question of `validity` and `properties`.
        """
        problems: list[Problem] = []
        points = points_of(vertices, problems)
        indices, offsets = corners_of(faces, len(points), problems)
        if not 0.0 <= rounding < np.inf:
            problems.append(Problem(f"rounding = {rounding!r}", "a length is needed: how far coordinates may be off"))
        if problems:
            raise GeometryError("This is not a polyhedron", problems)
        object.__setattr__(self, "rounding", float(rounding))
        for name, array in (("vertices", points), ("indices", indices), ("offsets", offsets)):
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @classmethod
    def load(cls, path: str | Path) -> Polyhedron:
        """From a file in the format of its suffix, all its bodies as one; `Model.load` keeps them apart.

        Raises FileError, MachineError.
        """
        bodies = reading.read(path).bodies
        return cls.united(cls(b.vertices, Corners(b.indices, b.offsets), rounding=b.rounding) for b in bodies)

    @classmethod
    def united(cls, parts: Iterable[Polyhedron]) -> Polyhedron:
        """Bodies that do not overlap as one, each keeping its vertices. Raises ValueError if there is none."""
        parts = list(parts)
        if len(parts) == 1:
            return parts[0]
        first_vertices = np.cumsum([0, *(len(part.vertices) for part in parts[:-1])])
        first_corners = np.cumsum([0, *(len(part.indices) for part in parts[:-1])])
        corners = Corners(
            np.concatenate([part.indices + first for part, first in zip(parts, first_vertices, strict=True)]),
            np.concatenate(
                [[0], *(part.offsets[1:] + first for part, first in zip(parts, first_corners, strict=True))]
            ),
        )
        rounding = max(part.rounding for part in parts)
        return cls(np.concatenate([part.vertices for part in parts]), corners, rounding=rounding)

    def bodies(self) -> tuple[Polyhedron, ...]:
        """The separate bodies, in the order of first faces; each with its voids, and only the vertices it uses."""
        validity = self.validity()
        if validity.bodies <= 1:
            return (self,)
        sizes = np.diff(self.offsets)
        order = np.argsort(validity.body_labels, kind="stable")
        corners = np.repeat(self.offsets[order] - np.cumsum(sizes[order]) + sizes[order], sizes[order])
        indices = self.indices[corners + np.arange(len(self.indices))]
        offsets = np.concatenate([[0], np.cumsum(sizes[order])])
        first_faces = np.searchsorted(validity.body_labels[order], np.arange(validity.bodies + 1))
        return tuple(
            self._part(indices[offsets[start] : offsets[stop]], offsets[start : stop + 1] - offsets[start])
            for start, stop in pairwise(first_faces)
        )

    def _part(self, indices: Indices, offsets: Indices) -> Polyhedron:
        used, numbers = np.unique(indices, return_inverse=True)
        return Polyhedron(self.vertices[used], Corners(numbers.reshape(-1), offsets), rounding=self.rounding)

    def save(self, path: str | Path, *, length_unit: str | None = "mm") -> None:
        """Writes a file in the format of its suffix, whole or not at all.

        Raises FileError, MachineError; GeometryError if a face cannot be cut into triangles where the format needs it.
        """
        save_polygons(path, self._alone(Path(path).stem or "body", length_unit))

    def to_trimesh(self, *, name: str = "body", length_unit: str | None = "mm") -> trimesh.Trimesh:
        """As a mesh of trimesh. Raises MachineError without it; GeometryError if a face cannot be cut."""
        from ..bridges.as_trimesh import trimesh_mesh

        return trimesh_mesh(self._alone(name, length_unit).parts[0], length_unit)

    def to_pyvista(self, *, name: str = "body", length_unit: str | None = "mm") -> pyvista.PolyData:
        """As a mesh of PyVista, its polygons kept. Raises MachineError without PyVista."""
        from ..bridges.as_pyvista import pyvista_mesh

        return pyvista_mesh(self._alone(name, length_unit).parts[0], length_unit)

    def show(self, *, title: str = "body", length_unit: str | None = "mm") -> TurningView:
        """A view that a notebook shows and turns. Raises GeometryError if a face cannot be cut into triangles."""
        from ..viewer.turning_view import TurningView

        return TurningView(title=title, assembly=self._alone(title, length_unit))

    def _alone(self, name: str, length_unit: str | None) -> Assembly[Polyhedron]:
        return Assembly(name=name, parts=(Part(name=name, shape=self),), length_unit=length_unit)

    @property
    def faces(self) -> Indices | tuple[Indices, ...]:
        """Vertex numbers of the faces: (m, k) where all have k corners, else one array a face."""
        sizes = np.diff(self.offsets)
        if len(sizes) and np.all(sizes == sizes[0]):
            return self.indices.reshape(len(sizes), sizes[0])
        return tuple(np.split(self.indices, self.offsets[1:-1])) if len(sizes) else ()

    def triangles(self) -> Indices:
        """Signed fans of the faces (t, 3): for integrals; they overlap where a face is not convex."""
        return fan_triangles(self.indices, self.offsets)

    def __repr__(self) -> str:
        return f"<Polyhedron of {len(self.offsets) - 1} faces and {len(self.vertices)} vertices>"

    def _repr_html_(self) -> str:
        from .summaries import polyhedron_summary

        return polyhedron_summary(self)

    def validity(self) -> PolyhedronValidity:
        """Report on holes, flipped faces, inward bodies and the like."""
        return self._validity

    @cached_property
    def _validity(self) -> PolyhedronValidity:
        from .validity.examination import examine

        return examine(self.vertices, self.indices, self.offsets, self.rounding)

    def self_intersections(self) -> SelfIntersections:
        """Which faces pass through each other, and which touch. Takes about a second for 100,000 triangles.

        Raises GeometryError if a face cannot be cut into triangles here.
        """
        owners = np.repeat(np.arange(len(self.offsets) - 1), np.diff(self.offsets) - 2)
        found = find_self_intersections(self.vertices, self.simple_triangles(), owners)
        return replace(found, bodies=overlapping(found.pairs, self.validity().body_labels))

    @cached_property
    def _box(self) -> Array:
        return bounding_box(self.vertices, self.indices)

    @cached_property
    def _moments(self) -> PolyhedronMoments:
        return polyhedron_moments(self.vertices, self.indices, self.offsets)

    def properties(self, density: float = 1.0, *, allow: Collection[ProblemKind] = ()) -> MassProperties:
        """Volume, centroid and inertia; density in mass per cubed length unit.

        allow   kinds of problems in spite of which an answer is wanted: "open", "flipped", "one-sided", "repeated",
                "inward", "nested", "nonplanar". They stand in the answer's `warnings`; docs/validity.md defines what
                it means then.

        Raises GeometryError, saying what and where, if the faces do not bound a solid, or what is allowed leaves no
        body that can have such properties; ParameterError for a name that is no kind.
        """
        allowed = require_kinds(allow)
        self._require_moderate()
        validity = self.validity()
        validity.raise_any(allowed)
        warnings = validity.warnings(allowed)
        if warnings:
            moments, area = allowed_moments(validity)
        else:
            moments, area = self._moments, self._moments.area
        body = moments.body
        if body.volume < 0.0 and "inward" in allowed and len(validity.inward):
            body = replace(body, matrix=-body.matrix)  # the whole the other way round
        if not body.volume > 0.0:
            given = f"volume {body.volume:.6g}"
            said = PROBLEMS["inward" if body.volume < 0.0 else "flat"].message
            raise GeometryError("This polyhedron does not bound a solid", [Problem(given, said)])
        found = MassProperties.from_moments(
            body, density=density, find_extent=partial(Extent, area, self._box), warnings=warnings
        )
        impossible = found.validity()
        if impossible:
            raise GeometryError("This polyhedron does not bound a solid", impossible)
        # what is allowed has no one answer that it could be off from
        return replace(found, error_bound=math.inf) if warnings else found

    def _require_moderate(self) -> None:
        largest = float(np.abs(self._box).max())
        if largest > _MOST:
            message = f"up to {_MOST:g} their fifth powers are numbers; take another length unit"
            raise GeometryError(
                "This polyhedron has no properties", [Problem(f"coordinates up to {largest:.3g}", message)]
            )

    def shell_properties(self, thickness: float, density: float = 1.0) -> MassProperties:
        """Of a thin sheet along the faces, to first order in its thickness; they need not close.

        Raises ParameterError if the thickness is not positive; GeometryError if no face has an area or one is bent.
        """
        self._require_moderate()
        if bent := self.validity().found.get("nonplanar"):
            raise GeometryError("This surface is no shell", [bent])
        return shell_properties(self.vertices, self.indices, self.offsets, thickness, density)

    def transformed(self, matrix: ArrayLike) -> Polyhedron:
        """The body mapped by a homogeneous matrix (4, 4), r → A r + t; mirrored faces are turned again.

        Raises GeometryError if the matrix is not of that form or flattens the body.
        """
        map_ = affine_map(matrix)
        points = self.vertices @ map_[:3, :3].T + map_[:3, 3]
        rounding = self.rounding * float(np.linalg.norm(map_[:3, :3], 2))
        corners = Corners(self.indices, self.offsets)
        if np.linalg.det(map_[:3, :3]) < 0.0:
            # the corners of every face backwards
            sizes = np.diff(self.offsets)
            ends = np.repeat(self.offsets[1:] + self.offsets[:-1] - 1, sizes)
            corners = Corners(self.indices[ends - np.arange(len(self.indices))], self.offsets)
        return Polyhedron(points, corners, rounding=rounding)

    def simple_triangles(self) -> Indices:
        """Triangles (t, 3) that do not overlap: fans, each from a corner that sees its whole face."""
        sizes = np.diff(self.offsets)
        triangles = self.triangles()
        if np.all(sizes == 3):
            return triangles
        normals = face_vectors(self.vertices, self.indices, self.offsets)
        owners = np.repeat(np.arange(len(sizes)), sizes - 2)
        inverted = np.einsum("ij,ij->i", triangle_vectors(self.vertices, triangles), normals[owners]) < 0.0
        for f in np.unique(owners[inverted]):
            triangles[owners == f] = self._fan_seeing_all(f, normals[f])
        return triangles

    def _fan_seeing_all(self, face: int, normal: Array) -> Indices:
        corners = self.indices[self.offsets[face] : self.offsets[face + 1]]
        whole = np.array([0, len(corners)])
        for turn in range(1, len(corners)):
            fan = fan_triangles(np.roll(corners, -turn), whole)
            if np.all(triangle_vectors(self.vertices, fan) @ normal >= 0.0):
                return fan
        raise GeometryError(
            "This polyhedron cannot be cut into triangles",
            [Problem(f"face {face} of {len(corners)} corners", "no corner sees all of it; split it into convex faces")],
        )

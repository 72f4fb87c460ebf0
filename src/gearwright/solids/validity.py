"""What is wrong with a polyhedron's boundary: one report, for exceptions, the command line and the page."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem
from ..moments import components as bodies
from ..moments.compensated import compensated_sum
from ..moments.faces import face_vectors, fan_triangles, planarity
from .edges import EdgeDefects, edge_defects

PLANARITY = 1e-6
"""How far corners may be off their face's plane, in diagonals of the bounding box: what a file with seven
digits leaves. Beyond it the face has no single answer."""

_SLIVER = 1e-12
"""A face counts as degenerate where its area is less than this × its extent squared."""


@dataclass(frozen=True, kw_only=True, eq=False)
class PolyhedronValidity:
    """What an examination of a polyhedron found.

    vertices           (n, 3) the polyhedron's, to say where things are
    edges              open, flipped and non-manifold edges
    degenerate_faces   (k,) faces without area or with fewer than three different corners
    nonplanar_faces    (k,) faces further off their mean plane than PLANARITY
    deviation          largest distance of a corner from its face's mean plane / bounding diagonal
    inward             (k, 2) components that turn their inside out: number of their first face, of faces
    duplicates         (k,) faces that repeat an earlier one, corner for corner
    buried             (k, 2) outward components inside another one: voids not reversed, or overlapping bodies
    components         number of connected components
    closure            |Σ n A| / Σ A
    """

    vertices: Array
    edges: EdgeDefects
    degenerate_faces: Indices
    nonplanar_faces: Indices
    deviation: float
    duplicates: Indices
    inward: Indices
    buried: Indices
    components: int
    closure: float

    @property
    def closed(self) -> bool:
        """Whether the boundary closes with one orientation throughout."""
        return not (len(self.edges.open) or len(self.edges.flipped))

    @property
    def valid(self) -> bool:
        """Whether the boundary bounds a solid, so that it has properties."""
        return not self.problems

    @property
    def problems(self) -> tuple[Problem, ...]:
        """What keeps the boundary from bounding a solid, in words."""
        found = [
            self._edge_problem(
                "open",
                self.edges.open,
                "every edge needs a face on both sides; usual causes are missing faces and corners that should"
                " share a vertex but are written with different coordinates; add the faces, or write again from"
                " the program that made it",
            ),
            self._edge_problem(
                "flipped",
                self.edges.flipped,
                "neighbouring faces must run along their common edge in opposite senses; the usual cause is single"
                " faces turned inward; reverse the order of their corners",
            ),
            self._face_problem(
                "repeated",
                self.duplicates,
                "an earlier face has the same corners in the same order, and their volume counts twice; the usual cause"
                " is a body exported twice; leave one of them out",
            ),
            self._component_problem(
                "turned inward",
                self.inward,
                "corners must run counter-clockwise seen from outside; the usual cause is a mirrored body; reverse the"
                " order of the corners in all its faces (faces[:, ::-1])",
            ),
            self._component_problem(
                "outward but inside another",
                self.buried,
                "their volume would count twice; a void must be turned inward (faces[:, ::-1]), overlapping bodies"
                " must be united first",
            ),
            self._face_problem(
                f"not planar, up to {self.deviation:.2g} × the bounding diagonal",
                self.nonplanar_faces,
                f"up to {PLANARITY:g} is accepted; such a face has no single volume; split it into triangles",
            ),
        ]
        return tuple(problem for problem in found if problem is not None)

    @property
    def remarks(self) -> tuple[Problem, ...]:
        """What is unusual but leaves the properties right."""
        found = [
            self._edge_problem("non-manifold", self.edges.non_manifold, "more than two faces meet there"),
            self._face_problem("degenerate", self.degenerate_faces, "they have no area"),
        ]
        return tuple(problem for problem in found if problem is not None)

    def raise_any(self) -> None:
        """Raises GeometryError with all problems, if there are any."""
        if self.problems:
            raise GeometryError("This polyhedron does not bound a solid", self.problems)

    def to_dict(self) -> dict[str, Any]:
        """Counts and texts by name, for JSON."""
        return {
            "valid": self.valid,
            "open_edges": len(self.edges.open),
            "flipped_edges": len(self.edges.flipped),
            "non_manifold_edges": len(self.edges.non_manifold),
            "degenerate_faces": len(self.degenerate_faces),
            "nonplanar_faces": len(self.nonplanar_faces),
            "duplicate_faces": len(self.duplicates),
            "inward_components": len(self.inward),
            "buried_components": len(self.buried),
            "components": self.components,
            "closure": self.closure,
            "problems": [str(problem) for problem in self.problems],
            "remarks": [str(problem) for problem in self.remarks],
        }

    def __str__(self) -> str:
        lines = [f"problem: {p}" for p in self.problems] + [f"remark: {p}" for p in self.remarks]
        return "\n".join(lines) or "valid: closed, outward, of one orientation"

    def _edge_problem(self, kind: str, edges: Indices, message: str) -> Problem | None:
        if not len(edges):
            return None
        a, b = (int(v) for v in edges[0])
        x, y, z = (self.vertices[a] + self.vertices[b]) / 2.0
        where = f"between vertices {a} and {b}, near ({x:.6g}, {y:.6g}, {z:.6g})"
        return Problem(f"{_counted(len(edges), f'{kind} edge')} {where}", message)

    @staticmethod
    def _face_problem(kind: str, faces: Indices, message: str) -> Problem | None:
        return Problem(f"{_counted(len(faces), 'face')} {faces[0]}, {kind}", message) if len(faces) else None

    @staticmethod
    def _component_problem(kind: str, found: Indices, message: str) -> Problem | None:
        if not len(found):
            return None
        face, faces = found[0]
        return Problem(f"{_counted(len(found), 'component')} the one of face {face} ({faces} faces), {kind}", message)


def _counted(count: int, noun: str) -> str:
    return f"1 {noun}," if count == 1 else f"{count} {noun}s, the first"


def examine(vertices: Array, indices: Indices, offsets: Indices) -> PolyhedronValidity:
    """Examines faces in the form of `moments.faces`; corners in range, at least three a face."""
    edges = edge_defects(len(vertices), indices, offsets)
    vectors = face_vectors(vertices, indices, offsets)
    areas = np.linalg.norm(vectors, axis=-1)
    deviation = planarity(vertices, indices, offsets)
    labels = bodies.component_labels(len(vertices), indices, offsets)
    nothing = np.empty((0, 2), dtype=np.int64)
    closed = not (len(edges.open) or len(edges.flipped))
    inward, buried = _misplaced(vertices, indices, offsets, labels) if closed and len(labels) else (nothing, nothing)
    total = float(areas.sum())
    return PolyhedronValidity(
        vertices=vertices,
        edges=edges,
        degenerate_faces=np.flatnonzero(areas <= _SLIVER * _extents(vertices, indices, offsets) ** 2),
        nonplanar_faces=np.flatnonzero(deviation > PLANARITY),
        deviation=float(deviation.max(initial=0.0)),
        # a face that is there twice brings edges with more than two faces
        duplicates=_duplicates(indices, offsets) if len(edges.non_manifold) else nothing[:, 0],
        inward=inward,
        buried=buried,
        components=int(labels.max(initial=-1)) + 1,
        closure=float(np.linalg.norm(compensated_sum(vectors.T))) / total if total else 0.0,
    )


def _extents(vertices: Array, indices: Indices, offsets: Indices) -> Array:
    """Largest distance of each face's corners from its first one (f,)."""
    if len(offsets) == 1:
        return np.zeros(0)
    first = np.repeat(indices[offsets[:-1]], np.diff(offsets))
    return np.asarray(np.maximum.reduceat(np.linalg.norm(vertices[indices] - vertices[first], axis=-1), offsets[:-1]))


def _duplicates(indices: Indices, offsets: Indices) -> Indices:
    """Faces (k,) that have the corners of an earlier one in the same cyclic order."""
    sizes = np.diff(offsets)
    found = []
    for size in np.unique(sizes):
        faces = np.flatnonzero(sizes == size)
        corners = indices[offsets[faces][:, None] + np.arange(size)]
        from_least = (np.argmin(corners, axis=1)[:, None] + np.arange(size)) % size
        _, first = np.unique(np.take_along_axis(corners, from_least, axis=1), axis=0, return_index=True)
        found.append(np.delete(faces, first))
    return np.sort(np.concatenate(found))


def _misplaced(vertices: Array, indices: Indices, offsets: Indices, labels: Indices) -> tuple[Indices, Indices]:
    """Inward components that lie in no other, and outward ones that do: (k, 2) first face and number of faces.

    Bounding boxes single out what may lie in what; the winding number of the others around one of a
    component's vertices decides. A vertex on another's surface decides nothing.
    """
    boxes = bodies.component_boxes(vertices, indices, offsets, labels)
    volumes = bodies.component_volumes(vertices, indices, offsets, labels, boxes.mean(axis=1))
    triangles = fan_triangles(indices, offsets)
    owners = np.repeat(labels, np.diff(offsets) - 2)
    _, first_faces, counts = np.unique(labels, return_index=True, return_counts=True)
    found: tuple[list[int], list[int]] = ([], [])
    for k, around in enumerate(bodies.containers(boxes)):
        winding = 0.0
        if len(around):
            witness = vertices[indices[offsets[first_faces[k]]]]
            winding = bodies.winding_number(witness, vertices, triangles[np.isin(owners, around)])
        if volumes[k] < 0.0 and winding < 0.25:
            found[0].append(k)
        if volumes[k] > 0.0 and winding > 0.75:
            found[1].append(k)
    inward, buried = (np.stack([first_faces[ks], counts[ks]], axis=-1).astype(np.int64) for ks in found)
    return inward, buried

"""What is wrong with a polyhedron's boundary: one report, for exceptions, the command line and the page."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ...arrays import Array, Indices
from ...errors import GeometryError, Problem
from .edge_defects import EdgeDefects, chains
from .kinds import PROBLEM_KINDS, PROBLEMS, REMARKS, Text
from .places import counted, edge_place, face_place, vertex_place


@dataclass(frozen=True, kw_only=True, eq=False)
class PolyhedronValidity:
    """What an examination of a polyhedron found.

    vertices, indices, offsets   the polyhedron's, to say where things are
    edges                open, flipped and non-manifold edges
    flipped_faces        (k,) faces turned another way than most of those connected with them
    one_sided            (k, 2) connected faces that cannot be turned one way: number of the first face, of faces
    unexplained_flips    whether edges are flipped beside those faces: whole groups of faces are turned the other way
    degenerate_faces     (k,) faces without area or with one corner twice in a row
    nonplanar_faces      (k,) faces with a corner further off their mean plane than `planarity`
    deviations           (k,) how far these are off, in lengths
    deviation            largest distance of a corner from its face's mean plane
    planarity            what of that is accepted
    duplicates           (k,) faces that repeat an earlier one, corner for corner
    back_to_back         (k,) faces with the corners of an earlier one in the opposite order
    pinched_vertices     (k,) vertices round which the faces form more than one fan
    unused_vertices      (k,) vertices of no face
    labels               (f,) every face's component, from 0 in the order of first faces: faces connected over edges
    inward               (k, 2) components that turn inward and bound no void: number of their first face, of faces
    buried               (k, 2) components that turn outward in another: voids not reversed, or overlapping bodies
    body_labels          (f,) every face's body, from 0 in the order of first faces: voids are of the body around them
    closure              |Σ n A| / Σ A
    flat                 whether it closes, but no component has a volume: nothing but rounding error
    """

    vertices: Array
    indices: Indices
    offsets: Indices
    edges: EdgeDefects
    flipped_faces: Indices
    one_sided: Indices
    unexplained_flips: bool
    degenerate_faces: Indices
    nonplanar_faces: Indices
    deviations: Array
    deviation: float
    planarity: float
    duplicates: Indices
    back_to_back: Indices
    pinched_vertices: Indices
    unused_vertices: Indices
    labels: Indices
    inward: Indices
    buried: Indices
    body_labels: Indices
    closure: float
    flat: bool

    @property
    def components(self) -> int:
        """Number of connected components: faces connected over edges."""
        return int(self.labels.max(initial=-1)) + 1

    @property
    def bodies(self) -> int:
        """Number of separate bodies, voids not counted."""
        return int(self.body_labels.max(initial=-1)) + 1

    @property
    def closed(self) -> bool:
        """Whether the boundary closes with one orientation throughout."""
        return not (len(self.edges.open) or len(self.edges.flipped))

    @property
    def valid(self) -> bool:
        """Whether the boundary bounds a solid, so that it has properties."""
        return not self.found

    @cached_property
    def holes(self) -> int:
        """Number of connected chains of open edges."""
        return chains(self.edges.open) if len(self.edges.open) else 0

    @cached_property
    def found(self) -> dict[str, Problem]:
        """What keeps the boundary from bounding a solid, by kind, in words."""
        subjects = {
            "open": self._open(),
            "flipped": self._flipped(),
            "one-sided": self._component(self.one_sided, "group", "one-sided"),
            "repeated": self._face(self.duplicates, "repeated"),
            "inward": self._component(self.inward, "component", "turned inward"),
            "nested": self._component(self.buried, "component", "outward but inside another"),
            "nonplanar": self._nonplanar(),
            "flat": "volume 0" if self.flat else "",
            "empty": "0 faces" if len(self.offsets) == 1 else "",
        }
        return _said(subjects, PROBLEMS)

    @cached_property
    def noted(self) -> dict[str, Problem]:
        """What is unusual but leaves the properties right, by kind, in words."""
        edges = self.edges.non_manifold
        subjects = {
            "non-manifold": counted(len(edges), "non-manifold edge", edge_place(self.vertices, edges)),
            "pinched": self._vertex(self.pinched_vertices, "pinched"),
            "back-to-back": self._face(self.back_to_back, "back to back with another"),
            "degenerate": self._face(self.degenerate_faces, "degenerate"),
            "unused": self._vertex(self.unused_vertices, "unused"),
        }
        return _said(subjects, REMARKS)

    @property
    def problems(self) -> tuple[Problem, ...]:
        """What keeps the boundary from bounding a solid, in words."""
        return tuple(self.found.values())

    @property
    def remarks(self) -> tuple[Problem, ...]:
        """What is unusual but leaves the properties right."""
        return tuple(self.noted.values())

    def raise_any(self, allow: Collection[str] = ()) -> None:
        """Raises GeometryError with all problems but those of the kinds allowed, if there are any."""
        refused = {kind: problem for kind, problem in self.found.items() if kind not in allow}
        if not refused:
            return
        problems = list(refused.values())
        if all(kind in PROBLEM_KINDS for kind in refused):
            kinds = [kind for kind in PROBLEM_KINDS if kind in {*refused, *allow}]
            names, options = ", ".join(f'"{kind}"' for kind in kinds), " ".join(f"--allow {kind}" for kind in kinds)
            way = (
                f"properties(allow=({names},)), or {options} with the command, answers all the same;"
                " docs/validity.md says what it means then"
            )
            problems.append(Problem("once that is known", way))
        raise GeometryError("This polyhedron does not bound a solid", problems)

    def warnings(self, allow: Collection[str]) -> tuple[str, ...]:
        """Problems of the kinds allowed, with what the answer means then."""
        return tuple(f"{p.subject}: {PROBLEMS[kind].allowed}" for kind, p in self.found.items() if kind in allow)

    def to_dict(self) -> dict[str, Any]:
        """Counts, numbers and texts by name, for JSON."""
        return {
            "valid": self.valid,
            "kinds": list(self.found),
            "open_edges": len(self.edges.open),
            "holes": self.holes,
            "flipped_edges": len(self.edges.flipped),
            "flipped_faces": len(self.flipped_faces),
            "one_sided_components": len(self.one_sided),
            "non_manifold_edges": len(self.edges.non_manifold),
            "non_manifold_vertices": len(self.pinched_vertices),
            "degenerate_faces": len(self.degenerate_faces),
            "nonplanar_faces": len(self.nonplanar_faces),
            "deviation": self.deviation,
            "planarity": self.planarity,
            "duplicate_faces": len(self.duplicates),
            "back_to_back_faces": len(self.back_to_back),
            "unused_vertices": len(self.unused_vertices),
            "inward_components": len(self.inward),
            "buried_components": len(self.buried),
            "components": self.components,
            "bodies": self.bodies,
            "closure": self.closure,
            "problems": [str(problem) for problem in self.problems],
            "remarks": [str(problem) for problem in self.remarks],
        }

    def __str__(self) -> str:
        lines = [f"problem: {p}" for p in self.problems] + [f"remark: {p}" for p in self.remarks]
        return "\n".join(lines) or "valid: closed, outward, of one orientation"

    def _open(self) -> str:
        edges = self.edges.open
        holes = "" if not len(edges) else f" in {self.holes} chains" if self.holes > 1 else " in one chain"
        return counted(len(edges), "open edge", edge_place(self.vertices, edges) + holes)

    def _flipped(self) -> str:
        edges = edge_place(self.vertices, self.edges.flipped)
        if len(self.flipped_faces):
            return self._face(self.flipped_faces, "flipped")
        return counted(len(self.edges.flipped), "flipped edge", edges) if self.unexplained_flips else ""

    def _nonplanar(self) -> str:
        kind = f"not planar, up to {self.deviation:.3g} off; {self.planarity:.2g} is accepted"
        return self._face(self.nonplanar_faces, kind)

    def _face(self, faces: Indices, kind: str) -> str:
        place = face_place(self.vertices, self.indices, self.offsets, faces)
        return counted(len(faces), "face", f"{place}, {kind}")

    def _vertex(self, vertices: Indices, kind: str) -> str:
        return counted(len(vertices), f"{kind} vertex", vertex_place(self.vertices, vertices))

    def _component(self, found: Indices, noun: str, kind: str) -> str:
        if not len(found):
            return ""
        face, faces = found[0]
        place = face_place(self.vertices, self.indices, self.offsets, found[:, 0])
        return counted(len(found), noun, f"the one of face {face} ({faces} faces){place[len(str(face)) :]}, {kind}")


def _said(subjects: dict[str, str], texts: dict[str, Text]) -> dict[str, Problem]:
    return {kind: Problem(subject, texts[kind].message) for kind, subject in subjects.items() if subject}

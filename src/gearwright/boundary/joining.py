"""One boundary of two bodies that lie against each other with plane faces, or apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

from .boundary import Boundary
from .contact import COINCIDENT, Contact, contacts, facing
from .edge import Edge, EdgeUse, Vertex
from .extent import rough_diagonal
from .faces import Cap, CapLoop, Patch
from .flat import FlatFace, flat_faces
from .matching import EdgeMatch
from .placed import written_out
from .refinement import cuts_at_corners
from .splitting import split

Face = TypeVar("Face", Cap, Patch)


@dataclass(frozen=True, kw_only=True, eq=False)
class Meeting:
    """Two bodies cut to fit each other, and the planes in which faces of theirs lie on one another."""

    first: Boundary
    second: Boundary
    contacts: tuple[Contact, ...]

    @cached_property
    def boundary(self) -> Boundary:
        """The boundary of both: glued faces vanish and leave what is not covered; loops that coincide become one."""
        removed = {face for contact in self.contacts for face in contact.removed}
        renamed = _Renamed([match for contact in self.contacts for match in contact.shared])
        left = [renamed.cap(cap) for contact in self.contacts for cap in contact.caps]
        return Boundary(
            patches=(
                *_without(self.first.patches, removed),
                *map(renamed.patch, _without(self.second.patches, removed)),
            ),
            caps=(*_without(self.first.caps, removed), *map(renamed.cap, _without(self.second.caps, removed)), *left),
        )


def meeting(first: Boundary, second: Boundary) -> Meeting:
    """Where plane faces of two bodies lie on one another.

    Patterns are written out where they do not go with the gluing, and borders that run along each other get the
    same corners. Raises GeometryError where the faces cannot be glued.
    """
    size = max(rough_diagonal(first), rough_diagonal(second))
    ours, theirs = flat_faces(first), flat_faces(second)
    pairs = facing(ours, theirs, size)
    ours_out = any(not ours[i].loops for i, _ in pairs)
    theirs_out = any(not theirs[j].loops for _, j in pairs)
    if ours_out or theirs_out:
        return meeting(written_out(first) if ours_out else first, written_out(second) if theirs_out else second)
    refined = _refined(first, second, [ours[i] for i, _ in pairs], [theirs[j] for _, j in pairs], COINCIDENT * size)
    if refined is not None:
        return meeting(*refined)
    found = contacts(ours, theirs, pairs, size)
    if not all(match.plain for contact in found for match in contact.shared) and _patterned(first, second):
        return meeting(written_out(first), written_out(second))
    return Meeting(first=first, second=second, contacts=tuple(found))


def _refined(
    first: Boundary, second: Boundary, ours: Sequence[FlatFace], theirs: Sequence[FlatFace], near: float
) -> tuple[Boundary, Boundary] | None:
    """Both boundaries with corners wherever one has corners on a border of the other; None where they have them."""
    loops, others = ([loop for face in dict.fromkeys(faces) for loop in face.loops] for faces in (ours, theirs))
    cuts, other_cuts = cuts_at_corners(loops, others, near), cuts_at_corners(others, loops, near)
    if not cuts and not other_cuts:
        return None
    if _patterned(first, second):
        return written_out(first), written_out(second)
    return split(_capped(first, ours), cuts), split(_capped(second, theirs), other_cuts)


def _capped(boundary: Boundary, faces: Sequence[FlatFace]) -> Boundary:
    """The boundary with plane patches as caps, which stay whole when their edges are cut."""
    caps = {face.face: Cap(name=face.name, surface=face.surface, loops=face.loops) for face in faces}
    return Boundary(
        patches=tuple(patch for patch in boundary.patches if patch not in caps),
        caps=(*boundary.caps, *(cap for face, cap in caps.items() if isinstance(face, Patch))),
    )


def _patterned(*boundaries: Boundary) -> bool:
    return any(edge.pattern.order > 1 for boundary in boundaries for edge in boundary.edges)


def _without(faces: Sequence[Face], removed: set[Cap | Patch]) -> list[Face]:
    return [face for face in faces if face not in removed]


class _Renamed:
    """The second body's faces with the first one's edges and vertices where they coincide."""

    def __init__(self, shared: Sequence[EdgeMatch]):
        self._shared = {match.second: match for match in shared}
        self._vertices: dict[Vertex, Vertex] = {}
        for match in shared:
            ends = (match.first.end, match.first.start) if match.reverse else (match.first.start, match.first.end)
            self._vertices[match.second.start], self._vertices[match.second.end] = ends
        self._edges: dict[Edge, Edge] = {}

    def _edge(self, edge: Edge) -> Edge:
        if edge.start not in self._vertices and edge.end not in self._vertices:
            return edge
        if edge not in self._edges:
            start, end = (self._vertices.get(vertex, vertex) for vertex in (edge.start, edge.end))
            self._edges[edge] = replace(edge, start=start, end=end)
        return self._edges[edge]

    def _use(self, use: EdgeUse) -> EdgeUse:
        match = self._shared.get(use.edge)
        if match is None:
            return replace(use, edge=self._edge(use.edge))
        return EdgeUse(edge=match.first, reverse=use.reverse != match.reverse, turn=use.turn)

    def patch(self, patch: Patch) -> Patch:
        first, right, second, left = map(self._use, patch.sides)
        return replace(patch, sides=(first, right, second, left))

    def cap(self, cap: Cap) -> Cap:
        return replace(cap, loops=tuple(self._loop(loop) for loop in cap.loops))

    def _loop(self, loop: CapLoop) -> CapLoop:
        return replace(loop, uses=tuple(map(self._use, loop.uses)))

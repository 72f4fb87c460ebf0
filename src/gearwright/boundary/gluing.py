"""Gluing boundaries along faces they share."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from ..errors import GeometryError, Problem
from .boundary import Boundary
from .edge import Edge
from .faces import Cap, CapLoop, Patch


@dataclass(frozen=True, kw_only=True)
class Joint:
    """Two pieces, by number, and the names of the faces along which they meet; "loop 2" is all faces of that loop."""

    first: int
    first_faces: tuple[str, ...]
    second: int
    second_faces: tuple[str, ...]


def glued(boundaries: Sequence[Boundary], joints: Sequence[Joint]) -> Boundary:
    """The boundary of pieces glued along joints: glued faces vanish, neighbours on one surface merge into one cap.

    Around a joint, each face on one side must have a neighbour on the same surface on the other side,
    bounded there by whole loops; they meet in one cap without those loops, so that the two sides of a joint need
    not be cut alike. Pieces are given from the outside in: the first loop of a cap is then the outer one.
    Raises GeometryError where that is not so, or the merged faces do not close.
    """
    inside = [_named(boundaries[j.first], j.first_faces) + _named(boundaries[j.second], j.second_faces) for j in joints]
    removed = {patch for patches in inside for patch in patches}
    seams = [_border(patches) for patches in inside]
    patches = [p for b in boundaries for p in b.patches if p not in removed]
    touching = [p for p in patches if any(use.edge in seam for seam in seams for use in p.sides)]
    caps = [
        cap
        for boundary in boundaries
        for cap in (*boundary.caps, *(_as_cap(patch) for patch in touching if patch in boundary.patches))
    ]
    return Boundary(
        patches=tuple(p for p in patches if p not in touching),
        caps=tuple(_merged(caps, seams)),
    )


def _named(boundary: Boundary, names: tuple[str, ...]) -> list[Patch]:
    return [patch for patch in boundary.patches if patch.name in names or patch.name.rpartition(".")[0] in names]


def _border(patches: Sequence[Patch]) -> set[Edge]:
    """Edges that bound a group of patches: used once by it."""
    uses = Counter(use.edge for patch in patches for use in patch.sides)
    return {edge for edge, count in uses.items() if count == 1}


def _as_cap(patch: Patch) -> Cap:
    """A patch once around a surface of revolution, as a cap between its two rails."""
    first, right, second, left = patch.sides
    if patch.surface is None or first.edge is not second.edge:
        raise GeometryError(
            "The pieces cannot be glued",
            [Problem(f"face {patch.name}", "next to the joint lies on no surface that another face could continue")],
        )
    loops = tuple(CapLoop(uses=(use,)) for use in (right, left) if not use.edge.degenerate)
    return Cap(name=patch.name, surface=patch.surface, loops=loops)


def _merged(caps: Sequence[Cap], seams: Sequence[set[Edge]]) -> list[Cap]:
    """Caps with those on one surface on both sides of a seam made one, seam after seam, and the seams' loops gone."""
    groups: list[tuple[list[Cap], set[int]]] = []
    for cap in caps:
        own = {k for k, seam in enumerate(seams) if any(_runs_on(loop, seam) for loop in cap.loops)}
        mates = [(group, at) for group, at in groups if at & own and group[0].surface.coincides(cap.surface)]
        together = [one for group, _ in mates for one in group]
        groups = [found for found in groups if found not in mates]
        groups.append(([*together, cap], own.union(*(at for _, at in mates))))
    return [
        Cap(
            name=" + ".join(cap.name for cap in group),
            surface=group[0].surface,
            loops=tuple(loop for cap in group for loop in cap.loops if not any(_runs_on(loop, seam) for seam in seams)),
        )
        if len(group) > 1
        else group[0]
        for group, _ in groups
    ]


def _runs_on(loop: CapLoop, seam: set[Edge]) -> bool:
    return all(use.edge in seam for use in loop.uses)

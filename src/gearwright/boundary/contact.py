"""Where the plane faces of two bodies lie on one another, and what is left of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NoReturn

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, Problem
from ..surfaces.plane import Plane
from .edge import Edge
from .faces import Cap, CapLoop, Patch
from .flat import FlatFace, segments_for
from .matching import EdgeMatch, matches
from .outlines import nearest_approach, winding
from .triangulation import signed_area

COINCIDENT = 1e-9
"""Distance, relative to the larger body, within which places are one: as for the closure of a loop, far above
rounding and far below any drawing's accuracy."""
APART = 1e-6
"""Distance, relative to the larger body, beyond which places are certainly two. In between nobody can have meant it."""
_SAGS = (1e-3, 1e-5, 2e-7)  # of the larger body: chords of the outlines compared, finer while they decide nothing
_OPPOSED = 1e-8  # |n + n′| of the normals of two faces that lie on one another
_ROUGH = 0.1  # of the larger body: by how much the few points of an outline may fall short of it
HEADLINE = "The solids cannot be added"


@dataclass(frozen=True, kw_only=True, eq=False)
class Contact:
    """One plane in which faces of two bodies lie on one another.

    plane     that plane
    removed   faces, caps or patches, that vanish as they are
    caps      what is left of them
    shared    edges of the second body that are edges of the first
    """

    plane: Plane
    removed: tuple[Cap | Patch, ...]
    caps: tuple[Cap, ...]
    shared: tuple[EdgeMatch, ...]


def facing(first: Sequence[FlatFace], second: Sequence[FlatFace], size: float) -> list[tuple[int, int]]:
    """Pairs, by number, of faces in one plane that look at each other and whose boxes meet."""
    if not first or not second:
        return []
    near = COINCIDENT * size
    normals, others = (np.array([face.normal for face in faces]) for faces in (first, second))
    points, marks = (np.array([face.outline[0] for face in faces]) for faces in (first, second))
    opposed = np.linalg.norm(normals[:, None] + others, axis=2) < _OPPOSED
    level = np.abs(np.einsum("ijk,ik->ij", marks - points[:, None], normals)) <= near
    pairs = [(int(i), int(j)) for i, j in np.argwhere(opposed & level)]
    return [(i, j) for i, j in pairs if _boxes_meet(first[i].outline, second[j].outline, _ROUGH * size)]


def contacts(
    first: Sequence[FlatFace], second: Sequence[FlatFace], pairs: Sequence[tuple[int, int]], size: float
) -> list[Contact]:
    """What becomes of faces that look at each other in common planes. Raises GeometryError where they cannot be glued.

    Loops that meet are one and the same or lie strictly inside one another; faces that only stand beside each
    other in a plane stay as they are.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    if not pairs:
        return []
    i, j = np.array(pairs).T
    count = len(first) + len(second)
    links = coo_matrix((np.ones(len(i)), (i, j + len(first))), shape=(count, count))
    labels = connected_components(links, directed=False)[1]
    found = []
    for label in dict.fromkeys(labels[i].tolist()):
        sides = (
            [face for k, face in enumerate(first) if labels[k] == label],
            [face for k, face in enumerate(second) if labels[k + len(first)] == label],
        )
        contact = _Plane(sides, size).contact()
        if contact is not None:
            found.append(contact)
    return found


@dataclass(frozen=True, eq=False)
class _Outline:
    """A loop of a face: `side` 0 or 1 says whose body it is, `plane` charts it with all others of the plane."""

    side: int
    face: FlatFace
    loop: CapLoop
    plane: Plane

    def polygon(self, sag: float) -> Array:
        """The loop in the chart of the common plane."""
        return self.plane.chart(self.loop.around(segments_for(sag)))

    @cached_property
    def edges(self) -> frozenset[Edge]:
        return frozenset(use.edge for use in self.loop.uses)


class _Plane:
    """The faces of two bodies in one plane, seen from outside the first one."""

    def __init__(self, sides: tuple[list[FlatFace], list[FlatFace]], size: float):
        self._sides = sides
        self._size = size
        face = sides[0][0]
        along = np.cross(face.surface.x_axis, face.surface.y_axis)
        flipped = Plane(origin=face.surface.origin, x_axis=face.surface.y_axis, y_axis=face.surface.x_axis)
        self._plane = face.surface if along @ face.normal > 0.0 else flipped
        self._outlines = [
            _Outline(side, face, loop, self._plane) for side in (0, 1) for face in sides[side] for loop in face.loops
        ]

    def contact(self) -> Contact | None:
        shared, same = self._shared()
        polygons = self._polygons(same)
        inside = {a: self._inside(a, polygons) for a in self._outlines if a not in same}
        touched = {a.face for a in self._outlines if a in same or inside[a]} | {
            face for a in inside for face in inside[a]
        }
        if not touched:
            return None
        left = [a for a in self._outlines if a.face in touched and a not in same]
        caps = []
        for side in (0, 1):
            names = " + ".join(face.name for face in self._sides[side] if face in touched)
            chosen = [a for a in left if (a.side == side) != bool(inside[a])]
            caps += _caps(names, chosen, polygons, 1.0 if side == 0 else -1.0)
        return Contact(
            plane=self._plane,
            removed=tuple(dict.fromkeys(face.face for side in self._sides for face in side if face in touched)),
            caps=tuple(caps),
            shared=tuple(shared),
        )

    def _shared(self) -> tuple[list[EdgeMatch], set[_Outline]]:
        """Edges that coincide, and the loops made of them. Raises GeometryError where only parts of loops do."""
        firsts, seconds = ([a for a in self._outlines if a.side == side] for side in (0, 1))
        found = matches([a.loop for a in firsts], [a.loop for a in seconds], COINCIDENT * self._size)
        of_second = {match.second: match for match in found}
        same: set[_Outline] = set()
        for b in seconds:
            edges = [of_second.get(use.edge) for use in b.loop.uses]
            if not any(edges):
                continue
            partners = [a for a in firsts if any(match and match.first in a.edges for match in edges)]
            whole = len(partners) == 1 and {m.first if m else None for m in edges} == partners[0].edges
            if not whole:
                self._refuse(partners[0], b, "are the same only in part", b.face.outline[0])
            self._require_same_side(partners[0], b, of_second)
            same |= {b, partners[0]}
        return found, same

    def _require_same_side(self, a: _Outline, b: _Outline, matched: dict[Edge, EdgeMatch]) -> None:
        """Raises GeometryError where the bodies lie on either side of a common loop and have only that in common."""
        use = b.loop.uses[0]
        match = matched[use.edge]
        mate = next(use for use in a.loop.uses if use.edge is match.first)
        opposite = (mate.reverse != a.loop.reverse) != ((use.reverse != b.loop.reverse) != match.reverse)
        if not opposite:
            self._refuse(a, b, "touch along an edge and have no face in common there", b.face.outline[0])

    def _polygons(self, same: set[_Outline]) -> dict[_Outline, Array]:
        """The loops as polygons fine enough to tell them apart. Raises GeometryError where they cross or touch."""
        sags = dict.fromkeys(self._outlines, _SAGS[0])
        for a in (a for a in self._outlines if a.side == 0):
            for b in (b for b in self._outlines if b.side == 1):
                if not (a in same and b in same):
                    sag = self._telling_sag(a, b)
                    sags[a], sags[b] = min(sags[a], sag), min(sags[b], sag)
        return {a: a.polygon(sag * self._size) for a, sag in sags.items()}

    def _telling_sag(self, a: _Outline, b: _Outline) -> float:
        """The coarsest sag at which two loops are seen to be apart. Raises GeometryError where there is none."""
        distance, where = 0.0, np.zeros(2)
        for sag in _SAGS:
            one, other = a.polygon(sag * self._size), b.polygon(sag * self._size)
            margin = (3.0 * sag + APART) * self._size
            if not _boxes_meet(one, other, margin):
                return sag
            distance, where = nearest_approach(one, other)
            if distance > margin:
                return sag
        self._refuse(a, b, f"cross or touch (they come as near as {distance:.3g})", self._plane.point(where))

    def _inside(self, a: _Outline, polygons: dict[_Outline, Array]) -> list[FlatFace]:
        """The faces of the other body that a loop lies in."""
        point = polygons[a][0]
        return [
            face
            for face in self._sides[1 - a.side]
            if sum(winding(point, polygons[b]) for b in self._outlines if b.face is face) != 0
        ]

    def _refuse(self, a: _Outline, b: _Outline, why: str, point: Array) -> NoReturn:
        place = ", ".join(f"{x:.6g}" for x in point)
        raise GeometryError(
            HEADLINE,
            [
                Problem(
                    f"face {a.face.name} of the first and face {b.face.name} of the second, near ({place})",
                    f"their borders {why}; faces that meet must have the same border, built from the same curves, or"
                    " one must lie strictly inside the other; move or resize a piece, or build both from one section",
                )
            ],
        )


def _caps(name: str, outlines: Sequence[_Outline], polygons: dict[_Outline, Array], sense: float) -> list[Cap]:
    """Caps of loops that do not cross: every loop that runs counter-clockwise, times the sense, and its holes."""
    areas = {a: sense * signed_area(polygons[a]) for a in outlines}
    outer = sorted((a for a in outlines if areas[a] > 0.0), key=lambda a: areas[a])
    holes: dict[_Outline, list[_Outline]] = {a: [] for a in outer}
    for hole in (a for a in outlines if areas[a] <= 0.0):
        # the smallest loop around it, which is larger than the hole: an island inside the hole is not
        around = [a for a in outer if areas[a] > -areas[hole] and winding(polygons[hole][0], polygons[a])]
        holes[around[0]].append(hole)
    return [Cap(name=name, surface=a.face.surface, loops=(a.loop, *(hole.loop for hole in holes[a]))) for a in outer]


def _boxes_meet(one: Array, other: Array, margin: float) -> bool:
    """Whether the bounding boxes of points (n, d) and (m, d) come within a margin."""
    return bool(
        np.all(one.min(axis=0) <= other.max(axis=0) + margin) and np.all(other.min(axis=0) <= one.max(axis=0) + margin)
    )

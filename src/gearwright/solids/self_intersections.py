"""Faces of one polyhedron that pass through each other."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem


@dataclass(frozen=True, kw_only=True, eq=False)
class SelfIntersections:
    """Which faces of a polyhedron pass through each other, and where. True if any do.

    pairs     (k, 2) faces, the lower number first, that pass through each other: their insides meet across; or in one
              plane, where both look the same way or are folded onto each other along an edge that no other face has;
              or an edge of one lies inside the other, and faces at that edge are on both sides of it
    points    (k, 3) a point of each pair's meeting
    depths    (k,) how far the shallower face of each reaches past the other's plane: 0 for meetings in a plane or
              along an edge, and next to nothing where faces should only touch but their coordinates are rounded
    bodies    (b, 2) separate bodies, by their numbers in `Polyhedron.bodies()`, whose faces pass through each other
    touching  (m, 2) faces that touch without that: by side or corner, or face to face as bodies in contact do

    What faces share by vertex number is no meeting, and faces without area meet nothing. All signs are exact: rounding
    neither hides nor makes up anything. Sheets that pass each other exactly along edges of both only touch.
    """

    pairs: Indices
    points: Array
    depths: Array
    touching: Indices
    bodies: Indices = field(default_factory=lambda: np.empty((0, 2), np.int64))

    def __bool__(self) -> bool:
        return self.count > 0

    @property
    def count(self) -> int:
        """Number of pairs that pass through each other."""
        return len(self.pairs)

    @property
    def problem(self) -> Problem | None:
        """That faces pass through each other, in words: how many, and the first place."""
        if not self:
            return None
        x, y, z = self.points[0]
        deepest = self.depths.max()
        deep = f", up to {deepest:.2g} deep" if deepest > 0.0 else ""
        how = f"passing through each other{deep}{self._overlaps()}"
        return Problem(
            f"{_counted(self.pairs)} near ({x:.6g}, {y:.6g}, {z:.6g}), {how}",
            "what lies on the wrong side of both counts twice, or negative; usual causes are bodies that overlap, which"
            " must be united first, and a sweep that bends more tightly than its section allows",
        )

    def _overlaps(self) -> str:
        if not len(self.bodies):
            return ""
        a, b = self.bodies[0]
        more = f", and {len(self.bodies) - 1} more pairs of bodies" if len(self.bodies) > 1 else ""
        return f"; bodies {a} and {b} overlap{more}"

    @property
    def remark(self) -> Problem | None:
        """That faces touch, in words."""
        if not len(self.touching):
            return None
        return Problem(
            f"{_counted(self.touching)}, touching", "bodies in contact, or edges that end on other faces unshared"
        )

    def raise_any(self) -> None:
        """Raises GeometryError if faces pass through each other."""
        if self.problem is not None:
            raise GeometryError("This polyhedron passes through itself", [self.problem])

    def to_dict(self) -> dict[str, Any]:
        """Counts, places and text by name, for JSON."""
        return {
            "count": self.count,
            "pairs": self.pairs.tolist(),
            "points": self.points.tolist(),
            "depths": self.depths.tolist(),
            "touching": self.touching.tolist(),
            "bodies": self.bodies.tolist(),
            "problem": None if self.problem is None else str(self.problem),
            "remark": None if self.remark is None else str(self.remark),
        }

    def __str__(self) -> str:
        lines = [f"problem: {self.problem}"] if self.problem else []
        lines += [f"remark: {self.remark}"] if self.remark else []
        return "\n".join(lines) or "no face passes through another"


def _counted(pairs: Indices) -> str:
    first = f"{pairs[0, 0]} and {pairs[0, 1]}"
    return f"1 pair of faces, {first}" if len(pairs) == 1 else f"{len(pairs)} pairs of faces, the first {first}"


def overlapping(pairs: Indices, bodies: Indices) -> Indices:
    """Pairs (b, 2) of different bodies, by every face's body (f,), to which pairs (k, 2) of faces belong."""
    found = np.unique(np.sort(bodies[pairs], axis=1), axis=0)
    return found[found[:, 0] != found[:, 1]]


def find_self_intersections(vertices: Array, triangles: Indices, owners: Indices) -> SelfIntersections:
    """Of the triangles (t, 3) of faces; `owners` (t,) are the faces' numbers. Triangles of one face do not count."""
    from .triangle_meeting import depths, meeting_points
    from .triangle_pairs import CROSSING, DOUBLED, EDGE_WITHIN, FACING

    _, exponent = np.frexp(np.max(np.abs(vertices), initial=0.0))
    points = np.ascontiguousarray(np.ldexp(vertices, -exponent))  # exact, and no product overflows
    triangles = np.ascontiguousarray(triangles)
    pairs, kinds = _related(points, triangles, owners)
    passing = (kinds == CROSSING) | (kinds == DOUBLED)
    passing[kinds == FACING] = _folded(triangles, pairs[kinds == FACING])
    passing[kinds == EDGE_WITHIN] = _passing_along_edges(points, triangles, pairs[kinds == EDGE_WITHIN])
    through, touching = _by_faces(owners, pairs[passing]), _by_faces(owners, pairs[~passing])
    return SelfIntersections(
        pairs=owners[through],
        points=np.ldexp(meeting_points(points, triangles, through), exponent),
        depths=np.ldexp(depths(points, triangles, through), exponent),
        touching=_without(owners[touching], owners[through]),
    )


def _related(points: Array, triangles: Indices, owners: Indices) -> tuple[Indices, Indices]:
    """Pairs (k, 2) of triangles of different faces that meet, and how (k,)."""
    from .box_tree import overlapping_pairs
    from .triangle_pairs import APART, projections, relations

    corners = points[triangles]
    axes = projections(points, triangles)
    found = [(np.empty((0, 2), np.int64), np.empty(0, np.int64))]
    for near in overlapping_pairs(np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1)):
        pairs = near[owners[near[:, 0]] != owners[near[:, 1]]]
        kinds = relations(points, triangles, axes, pairs)
        found.append((pairs[kinds != APART], kinds[kinds != APART]))
    return np.concatenate([pairs for pairs, _ in found]), np.concatenate([kinds for _, kinds in found])


def _folded(triangles: Indices, pairs: Indices) -> Array:
    """Which pairs (k,) of triangles share an edge that no other triangle has: a fold, and no contact of bodies."""
    if not len(pairs):
        return np.zeros(0, bool)
    ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1), axis=-1)
    keys = ends[..., 0] * (int(triangles.max()) + 1) + ends[..., 1]
    edges, uses = np.unique(keys, return_counts=True)
    first, second = keys[pairs[:, 0]][:, :, None], keys[pairs[:, 1]][:, None, :]
    only = uses[np.searchsorted(edges, keys[pairs[:, 0]])] == 2
    return np.asarray(np.any((first == second).any(axis=2) & only, axis=1))


def _passing_along_edges(points: Array, triangles: Indices, pairs: Indices) -> Array:
    """Which pairs (k,), one with an edge inside the other, have a third triangle at that edge beyond the other."""
    from .triangle_pairs import edges_within

    places = edges_within(points, triangles, pairs)
    _, groups = np.unique(places[:, :3], axis=0, return_inverse=True)
    groups = groups.reshape(-1)
    above, below = np.bincount(groups, places[:, 3] > 0), np.bincount(groups, places[:, 3] < 0)
    return np.asarray((above[groups] > 0) & (below[groups] > 0))


def _by_faces(owners: Indices, pairs: Indices) -> Indices:
    """Pairs (k, 2) of triangles in the order of their faces, one for every two faces."""
    pairs = np.where((owners[pairs[:, 0]] < owners[pairs[:, 1]])[:, None], pairs, pairs[:, ::-1])
    _, first = np.unique(owners[pairs], axis=0, return_index=True)
    return pairs[first]


def _without(pairs: Indices, others: Indices) -> Indices:
    """Pairs (k, 2) that are not among others."""
    known = set(map(tuple, others.tolist()))
    return pairs[np.array([tuple(pair) not in known for pair in pairs.tolist()], bool)]

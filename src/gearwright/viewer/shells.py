"""The boundary of a solid as shells that a page draws: one sector of a pattern stands for all of its images.

Points of faces are those that `tessellate` would put on them, with the exact normals of the surfaces, and edges are cut
alike for both faces; but each face has its own vertices, nothing is numbered through, and end faces have hardly any
points inside. That is a fraction of the work, and of the bytes, of a watertight polyhedron.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..arrays import Array, Indices
from ..boundary.boundary import Boundary
from ..boundary.edge import Edge, EdgeUse
from ..boundary.faces import Patch
from ..boundary.pattern import Pattern
from ..boundary.sampling import Sampling
from ..boundary.tessellation import grid_triangles
from .end_faces import Piece, end_face_pieces, unit
from .surface import SHARP

_FLAT = 1e-9  # within which normals are one
_VANISHING = 1e-9  # of the largest ∂r/∂u × ∂r/∂v of a patch: up to which one has no direction


@dataclass(frozen=True, kw_only=True)
class Shell:
    """Faces, or pieces of sharp edges, that repeat alike.

    pattern    of which they are the first sector
    positions  (n, 3)
    normals    (n, 3) outward unit normals; (3,) where they are all one
    triangles  (t, 3) counter-clockwise seen from outside
    edges      (e, 2) the ends of pieces of sharp edges
    """

    pattern: Pattern
    positions: Array
    normals: Array
    triangles: Indices
    edges: Indices


class _Side(NamedTuple):
    """An edge of a face, and the face's normals (segments + 1, 3) along its first image, in its sense."""

    edge: Edge
    normals: Array


def shells(boundary: Boundary, sampling: Sampling) -> list[Shell]:
    """Shells that together draw a boundary sampled so: faces by pattern, end faces, sharp edges."""
    edges = _Edges(sampling)
    pieces: dict[Pattern, list[Piece]] = defaultdict(list)
    found, sides = [], []
    for patch in boundary.patches:
        piece, own = _patch(patch, edges)
        pieces[patch.pattern].append(piece)
        sides += own
    for cap in boundary.caps:
        parts, at_border = end_face_pieces(cap, edges.used, sampling.tolerance)
        found += [_shell(pattern, [piece]) for pattern, piece in parts]
        sides += [_side(use, normals) for use, normals in at_border]
    drawn = [_shell(pattern, own) for pattern, own in pieces.items()]
    return [*drawn, *found, *_lines(sides, edges)]


class _Edges:
    """Points along edges, each found once."""

    def __init__(self, sampling: Sampling):
        self._segments = sampling.segments
        self._points: dict[Edge, Array] = {}

    def first(self, edge: Edge) -> Array:
        """Points (segments + 1, 3) along the first image of an edge, its ends those of its vertices."""
        if edge not in self._points:
            n = self._segments[edge]
            points = edge.curve.point(edge.curve.parameter(np.arange(n + 1) / n))
            points[0] = edge.start.position
            points[-1] = _turned(edge.end.pattern, edge.end.position[None], edge.end_turn)[0]
            self._points[edge] = points
        return self._points[edge]

    def used(self, use: EdgeUse) -> Array:
        """Points (segments + 1, 3) in the sense of the use."""
        points = _turned(use.edge.pattern, self.first(use.edge), use.turn)
        return points[::-1] if use.reverse else points


def _turned(pattern: Pattern, points: Array, turn: int) -> Array:
    """Points (n, 3) of the first sector in the image so many turns on."""
    return points if turn % pattern.order == 0 else pattern.image(turn).points(points)


def _side(use: EdgeUse, normals: Array) -> _Side:
    """From normals in the sense of a use, where it is."""
    own = normals[::-1] if use.reverse else normals
    back = -use.turn % use.edge.pattern.order
    return _Side(use.edge, use.edge.pattern.turned(own)[back] if back else own)


def _patch(patch: Patch, edges: _Edges) -> tuple[Piece, list[_Side]]:
    first, right, second, left = (edges.used(use) for use in patch.sides)
    columns, layers = len(first) - 1, len(right) - 1
    u, v = np.meshgrid(np.arange(columns + 1) / columns, np.arange(layers + 1) / layers, indexing="ij")
    points, areas = patch.point(u, v), patch.area_vector(u, v)
    points[:, 0], points[:, -1], points[0], points[-1] = first, second[::-1], left[::-1], right
    grid = np.arange(u.size).reshape(u.shape)
    points, areas = points.reshape(-1, 3), areas.reshape(-1, 3)
    around = (grid[:, 0], grid[-1], grid[::-1, -1], grid[0, ::-1])
    inside = (grid[:, 1], grid[-2], grid[::-1, -2], grid[1, ::-1])
    sizes = np.linalg.norm(areas, axis=1)
    for run, beside in zip(around, inside, strict=True):
        none = sizes[run] <= _VANISHING * sizes.max()  # at a pole, and where an involute leaves its base circle
        areas[run[none]] = areas[beside[none]]
    normals = unit(areas)
    sides = [_side(use, normals[run]) for use, run in zip(patch.sides, around, strict=True) if not use.edge.degenerate]
    triangles = grid_triangles(grid[None])
    corners = points[triangles]
    distinct = (corners != np.roll(corners, 1, axis=1)).any(axis=2).all(axis=1)
    return Piece(points, normals, triangles[distinct]), sides


def _lines(sides: Sequence[_Side], edges: _Edges) -> list[Shell]:
    """The edges at which two faces meet at more than SHARP somewhere, by their patterns."""
    normals: dict[Edge, list[Array]] = defaultdict(list)
    for edge, own in sides:
        normals[edge].append(own)
    lines: dict[Pattern, list[Array]] = defaultdict(list)
    for edge, (one, *others) in normals.items():
        if any(np.min(np.sum(one * other, axis=-1)) < np.cos(SHARP) for other in others):
            lines[edge.pattern].append(edges.first(edge))
    return [_line_shell(pattern, own) for pattern, own in lines.items()]


def _line_shell(pattern: Pattern, lines: Sequence[Array]) -> Shell:
    starts = np.cumsum([0, *map(len, lines)])
    numbers = [np.arange(start, end) for start, end in pairwise(starts)]
    return Shell(
        pattern=pattern,
        positions=np.concatenate(lines),
        normals=np.zeros(3),
        triangles=np.empty((0, 3), np.int64),
        edges=np.concatenate([np.stack([run[:-1], run[1:]], axis=-1) for run in numbers]),
    )


def _shell(pattern: Pattern, pieces: Sequence[Piece]) -> Shell:
    """Pieces of one pattern as one."""
    starts = np.cumsum([0, *(len(piece.positions) for piece in pieces)])
    normals = np.concatenate([piece.normals for piece in pieces])
    flat = bool(np.max(np.abs(normals - normals[0])) < _FLAT)
    return Shell(
        pattern=pattern,
        positions=np.concatenate([piece.positions for piece in pieces]),
        normals=normals[0] if flat else normals,
        triangles=np.concatenate([piece.triangles + start for piece, start in zip(pieces, starts, strict=False)]),
        edges=np.empty((0, 2), np.int64),
    )

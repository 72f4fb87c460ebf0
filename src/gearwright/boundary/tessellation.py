"""From a boundary to a watertight polyhedron: vertices are shared by number, never by coordinates."""

from __future__ import annotations

from typing import Literal

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem
from .boundary import Boundary
from .edge import Edge, EdgeUse, Vertex
from .faces import Cap, CapLoop, Patch
from .pattern import Pattern
from .rim import triangulate_pattern
from .sampling import Sampling

Diagonals = Literal["alternating", "fixed"]
"""Which diagonal cuts a quad of a patch: in turn, like a chequerboard, or the same one in all."""


def tessellate(boundary: Boundary, sampling: Sampling, diagonals: Diagonals = "alternating") -> tuple[Array, Indices]:
    """Vertices (n, 3) and outward triangles (m, 3) of a boundary sampled so.

    Quads of a patch take their diagonals in turn: with one fixed diagonal, which is there for studies
    only, the volume of a twisted strip converges only with the first order of the number of layers.
    """
    return _Tessellation(boundary, sampling, diagonals).result()


def tessellate_caps(boundary: Boundary, sampling: Sampling) -> tuple[Array, Indices]:
    """Vertices (n, 3) and outward triangles (m, 3) of the caps alone, the same as `tessellate` gives them."""
    return _Tessellation(boundary, sampling, "alternating").caps()


class _Tessellation:
    """Numbers vertices, then edges, then faces, as each is met."""

    def __init__(self, boundary: Boundary, sampling: Sampling, diagonals: Diagonals):
        self._boundary = boundary
        self._sampling = sampling
        self._diagonals = diagonals
        self._points: list[Array] = []
        self._count = 0
        self._vertices: dict[Vertex, Indices] = {}
        self._edges: dict[Edge, Indices] = {}

    def result(self) -> tuple[Array, Indices]:
        triangles = [self._patch(patch) for patch in self._boundary.patches]
        for edge in self._boundary.edges:
            self._edge(edge)  # some lie between caps alone
        positions = np.concatenate(self._points)  # all that caps can refer to
        triangles += [self._cap(cap, positions) for cap in self._boundary.caps]
        if not any(map(len, triangles)):
            raise GeometryError(
                "Nothing is left of the solid at this tolerance",
                [
                    Problem(
                        f"tolerance = {self._sampling.tolerance:.3g}", "it is larger than the solid; take a smaller one"
                    )
                ],
            )
        return np.concatenate(self._points), np.concatenate(triangles)

    def caps(self) -> tuple[Array, Indices]:
        for edge in self._boundary.edges:
            self._edge(edge)
        positions = np.concatenate(self._points)
        triangles = [self._cap(cap, positions) for cap in self._boundary.caps]
        return np.concatenate(self._points), np.concatenate([np.empty((0, 3), np.int64), *triangles])

    def _number(self, points: Array, pattern: Pattern) -> Indices:
        """Numbers (order, n) of new points (n, 3) and all their images."""
        images = pattern.images(points)
        self._points.append(images.reshape(-1, 3))
        numbers = self._count + np.arange(images.shape[0] * images.shape[1]).reshape(images.shape[:2])
        self._count += numbers.size
        return numbers

    def _vertex(self, vertex: Vertex) -> Indices:
        if vertex not in self._vertices:
            self._vertices[vertex] = self._number(vertex.position[None], vertex.pattern)[:, 0]
        return self._vertices[vertex]

    def _edge(self, edge: Edge) -> Indices:
        """Numbers (order, segments + 1) along every image of an edge."""
        if edge not in self._edges:
            order, n = edge.pattern.order, self._sampling.segments[edge]
            start, end = (np.resize(self._vertex(v), order) for v in (edge.start, edge.end))
            if edge.degenerate:
                inner = np.repeat(start[:, None], n - 1, axis=1)
            else:
                fractions = np.arange(1, n) / n
                inner = self._number(edge.curve.point(edge.curve.parameter(fractions)), edge.pattern)
            self._edges[edge] = np.concatenate([start[:, None], inner, np.roll(end, -edge.end_turn)[:, None]], axis=1)
        return self._edges[edge]

    def _use(self, use: EdgeUse) -> Indices:
        """Numbers (order, segments + 1) in the sense of the use."""
        numbers = np.roll(self._edge(use.edge), -use.turn, axis=0)
        return numbers[:, ::-1] if use.reverse else numbers

    def _patch(self, patch: Patch) -> Indices:
        order = patch.pattern.order
        first, right, second, left = (np.resize(n, (order, n.shape[1])) for n in map(self._use, patch.sides))
        columns, layers = first.shape[1] - 1, right.shape[1] - 1
        grid = np.empty((order, columns + 1, layers + 1), np.int64)
        grid[:, :, 0], grid[:, :, -1] = first, second[:, ::-1]
        grid[:, 0, :], grid[:, -1, :] = left[:, ::-1], right
        if columns > 1 and layers > 1:
            u, v = np.meshgrid(np.arange(1, columns) / columns, np.arange(1, layers) / layers, indexing="ij")
            points = patch.point(u, v).reshape(-1, 3)
            grid[:, 1:-1, 1:-1] = self._number(points, patch.pattern).reshape(order, columns - 1, layers - 1)
        triangles = grid_triangles(grid, self._diagonals)
        distinct = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
        return triangles[distinct]

    def _cap(self, cap: Cap, positions: Array) -> Indices:
        loops = [self._loop(loop) for loop in cap.loops]
        borders = [positions[loop] for loop in loops]
        order = cap.loops[0].pattern.order
        inner, triangles = triangulate_pattern(cap.surface, borders, self._sampling.tolerance, order)
        numbers = np.concatenate([*loops, self._number(inner, Pattern())[0]])
        return numbers[triangles]

    def _loop(self, loop: CapLoop) -> Indices:
        """Numbers (n,) once around a cap's loop, in its sense."""
        around = np.concatenate([self._use(use)[:, :-1] for use in loop.uses], axis=1)
        if loop.uses[-1].edge.end_turn < 0:
            around = np.roll(around[::-1], 1, axis=0)  # the images follow one another clockwise
        numbers = around.ravel()
        return numbers[::-1] if loop.reverse else numbers


def grid_triangles(grid: Indices, diagonals: Diagonals = "alternating") -> Indices:
    """Triangles (m, 3) of grids of numbers (k, columns + 1, layers + 1); diagonals alternate both ways, or never."""
    a, b = grid[:, :-1, :-1], grid[:, 1:, :-1]
    d, c = grid[:, :-1, 1:], grid[:, 1:, 1:]
    falling = np.add.outer(np.arange(a.shape[1]), np.arange(a.shape[2])) % 2 == 1
    rising = ~falling[None] | (diagonals == "fixed")
    first = np.stack([a, b, np.where(rising, c, d)], axis=-1)
    second = np.stack([np.where(rising, a, b), c, d], axis=-1)
    return np.concatenate([first.reshape(-1, 3), second.reshape(-1, 3)])

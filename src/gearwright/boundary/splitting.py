"""Cutting the edges of a boundary into shorter ones, and with them the patches they border."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from ..motions.ends import Ends
from .boundary import Boundary
from .edge import Edge, EdgeUse, Profile, Rail, Vertex
from .faces import Cap, Patch

_SAME = 1e-11  # of an edge's parameter: cuts nearer than that are one, as corners further apart are not

Cuts = Mapping[Edge, Sequence[float]]
"""Fractions of an edge's parameter, between 0 and 1, at which it is cut."""


def split(boundary: Boundary, cuts: Cuts) -> Boundary:
    """The same boundary with edges cut; a patch is cut from side to side, and so on along its neighbours.

    For boundaries without patterns (see `written_out`).
    """
    pieces = _Pieces(_spread(boundary, cuts))
    return Boundary(
        patches=tuple(part for patch in boundary.patches for part in pieces.patches(patch)),
        caps=tuple(pieces.cap(cap) for cap in boundary.caps),
    )


def _spread(boundary: Boundary, cuts: Cuts) -> dict[Edge, list[float]]:
    """The cuts of every edge: opposite sides of a patch are cut at the same fractions."""
    found: dict[Edge, list[float]] = {}
    waiting = [(edge, fraction) for edge, fractions in cuts.items() for fraction in fractions]
    ties: dict[Edge, list[tuple[Edge, bool]]] = {}
    for patch in boundary.patches:
        first, right, second, left = patch.sides
        for one, other in ((first, second), (right, left)):
            turned = one.reverse == other.reverse  # opposite sides are used in opposite senses where they run alike
            ties.setdefault(one.edge, []).append((other.edge, turned))
            ties.setdefault(other.edge, []).append((one.edge, turned))
    while waiting:
        edge, fraction = waiting.pop()
        own = found.setdefault(edge, [])
        if any(abs(fraction - other) < _SAME for other in own):
            continue
        own.append(fraction)
        waiting += [(mate, 1.0 - fraction if turned else fraction) for mate, turned in ties.get(edge, [])]
    return {edge: sorted(fractions) for edge, fractions in found.items()}


@dataclass(frozen=True)
class _Pieces:
    """The pieces of edges, each made once."""

    cuts: dict[Edge, list[float]]

    @cached_property
    def _edges(self) -> dict[Edge, list[Edge]]:
        return {edge: self._cut(edge, fractions) for edge, fractions in self.cuts.items()}

    @staticmethod
    def _cut(edge: Edge, fractions: Sequence[float]) -> list[Edge]:
        inner = [
            edge.start if edge.degenerate else Vertex(name=f"{edge.name} at {f:.6g}", position=position)
            for f, position in zip(fractions, edge.curve.point(edge.curve.parameter(fractions)), strict=True)
        ]
        vertices, stations = [edge.start, *inner, edge.end], edge.curve.parameter([0.0, *fractions, 1.0]).tolist()
        return [
            Edge(
                name=f"{edge.name} part {i + 1}",
                curve=replace(edge.curve, interval=(stations[i], stations[i + 1])),
                start=vertices[i],
                end=vertices[i + 1],
            )
            for i in range(len(stations) - 1)
        ]

    def uses(self, use: EdgeUse) -> list[EdgeUse]:
        """A use of an edge as the uses of its pieces, in the sense of the use."""
        if use.edge not in self.cuts:
            return [use]
        parts = [EdgeUse(edge=edge, reverse=use.reverse) for edge in self._edges[use.edge]]
        return parts[::-1] if use.reverse else parts

    def cap(self, cap: Cap) -> Cap:
        loops = tuple(replace(loop, uses=tuple(p for use in loop.uses for p in self.uses(use))) for loop in cap.loops)
        return replace(cap, loops=loops)

    def patches(self, patch: Patch) -> list[Patch]:
        first, right, second, left = (self.uses(use) for use in patch.sides)
        second, left = second[::-1], left[::-1]  # all along the patch now
        u, v = self._fractions(patch.sides[0]), self._fractions(patch.sides[1])
        if len(u) == len(v) == 2:
            return [patch]
        return _Grid(patch, u, v, first, right, second, left).parts()

    def _fractions(self, use: EdgeUse) -> list[float]:
        inner = self.cuts.get(use.edge, [])
        return [0.0, *([1.0 - f for f in reversed(inner)] if use.reverse else inner), 1.0]


@dataclass(frozen=True)
class _Grid:
    """A patch cut at fractions u across and v along the motion, and the pieces of its four sides."""

    patch: Patch
    u: list[float]
    v: list[float]
    first: list[EdgeUse]
    right: list[EdgeUse]
    second: list[EdgeUse]
    left: list[EdgeUse]

    @cached_property
    def _spans(self) -> list[Ends]:
        if len(self.v) == 2:
            return [self.patch.ends]
        stations = self.patch.ends.at(self.v).tolist()
        return [Ends(start=a, finish=b) for a, b in pairwise(stations)]

    @cached_property
    def _corners(self) -> list[list[Vertex]]:
        """Vertices at all crossings of the cuts; those on the sides are the sides' own."""
        columns, rows = len(self.u) - 1, len(self.v) - 1
        grid = []
        for i in range(columns + 1):
            column = []
            for j in range(rows + 1):
                if i in (0, columns):
                    side = self.left if i == 0 else self.right
                    column.append(_end(side[min(j, rows - 1)], at_end=j == rows, against=i == 0))
                elif j in (0, rows):
                    side = self.first if j == 0 else self.second
                    column.append(_end(side[i], at_end=False, against=j == rows))
                else:
                    position = self.patch.point(np.array(self.u[i]), np.array(self.v[j]))
                    column.append(Vertex(name=f"{self.patch.name} at {i}, {j}", position=position))
            grid.append(column)
        return grid

    @cached_property
    def _rails(self) -> list[list[Edge]]:
        """Edges along the motion at every inner cut across."""
        curve = self.patch.curve
        return [
            [
                Edge(
                    name=f"{self.patch.name} cut {i} part {j + 1}",
                    curve=Rail(
                        motion=self.patch.motion,
                        section_point=tuple(curve.point(curve.parameter(self.u[i])).tolist()),
                        ends=span,
                    ),
                    start=self._corners[i][j],
                    end=self._corners[i][j + 1],
                )
                for j, span in enumerate(self._spans)
            ]
            for i in range(1, len(self.u) - 1)
        ]

    @cached_property
    def _profiles(self) -> list[list[Edge]]:
        """Edges across the motion at every inner cut along it."""
        return [
            [
                Edge(
                    name=f"{self.patch.name} station {j} part {i + 1}",
                    curve=Profile(
                        motion=self.patch.motion,
                        curve=self.patch.curve,
                        v=self._spans[j].start,
                        interval=self._interval(i),
                    ),
                    start=self._corners[i][j],
                    end=self._corners[i + 1][j],
                )
                for i in range(len(self.u) - 1)
            ]
            for j in range(1, len(self.v) - 1)
        ]

    def _interval(self, i: int) -> tuple[float, float]:
        a, b = self.patch.curve.parameter([self.u[i], self.u[i + 1]]).tolist()
        return a, b

    def parts(self) -> list[Patch]:
        columns, rows = len(self.u) - 1, len(self.v) - 1
        return [
            replace(
                self.patch,
                name=f"{self.patch.name} part {i * rows + j + 1}",
                curve=replace(self.patch.curve, interval=self._interval(i)),
                ends=self._spans[j],
                sides=(
                    self.first[i] if j == 0 else EdgeUse(edge=self._profiles[j - 1][i]),
                    self.right[j] if i == columns - 1 else EdgeUse(edge=self._rails[i][j]),
                    self.second[i] if j == rows - 1 else EdgeUse(edge=self._profiles[j][i], reverse=True),
                    self.left[j] if i == 0 else EdgeUse(edge=self._rails[i - 1][j], reverse=True),
                ),
            )
            for i in range(columns)
            for j in range(rows)
        ]


def _end(use: EdgeUse, *, at_end: bool, against: bool) -> Vertex:
    """The vertex where a side's piece starts or ends, as the patch runs along it; `against` sides are used backward."""
    backward = use.reverse != against
    return use.edge.end if at_end != backward else use.edge.start

"""Vertices and edges in Open CASCADE, each made once and shared by the faces that meet there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple, final

import numpy as np

from ....arrays import Array
from ....boundary.edge import Edge, Vertex
from ....placement import Placement
from .approximation import Approximation
from .elementary import Circular, Straight
from .splines import spline_curve

LEAST_TOLERANCE = 1e-7
"""Open CASCADE's own tolerance of points that are one, a length whatever the unit."""

Image = tuple[Edge, int]
"""An edge in one image of its pattern."""

Cuts = Mapping[Image, Sequence[float]]
"""Fractions at which an image of an edge is cut in pieces."""


class Piece(NamedTuple):
    """An edge in Open CASCADE, and the fractions of ours between which it runs."""

    made: Any
    first: float
    last: float


@dataclass(frozen=True, kw_only=True)
class Course:
    """A curve in Open CASCADE whose parameter is first + fraction × span, span > 0."""

    made: Any
    first: float
    span: float

    def at(self, fraction: float) -> float:
        return self.first + fraction * self.span


def transform(placement: Placement) -> Any:
    """A rigid map in Open CASCADE."""
    from OCP.gp import gp_Trsf

    found = gp_Trsf()
    rows = np.column_stack([placement.matrix, placement.shift])
    found.SetValues(*rows.ravel().tolist())
    return found


@final
class Edges:
    """The edges of a boundary, image by image."""

    def __init__(self, approximation: Approximation, cuts: Cuts):
        from OCP.BRep import BRep_Builder

        self._builder = BRep_Builder()
        self._approximation = approximation
        self._cuts = cuts
        self._vertices: dict[tuple[Vertex, int], Any] = {}
        self._courses: dict[Edge, Course] = {}
        self._pieces: dict[Image, tuple[Piece, ...]] = {}

    def course(self, edge: Edge) -> Course:
        """The curve of the first image."""
        if edge not in self._courses:
            self._courses[edge] = self._course(edge)
        return self._courses[edge]

    def is_elementary(self, edge: Edge) -> bool:
        return edge in self._approximation.edges

    def points(self, edge: Edge, k: int, fractions: Array) -> Array:
        """Points (n, 3) on image k as it is written."""
        found = self._approximation.points(edge, fractions)
        return edge.pattern.image(k).points(found) if k % edge.pattern.order else found

    def vertex(self, vertex: Vertex, k: int) -> Any:
        """A corner in image k."""
        key = (vertex, k % vertex.pattern.order)
        if key not in self._vertices:
            position = vertex.pattern.images(vertex.position[None])[key[1], 0]
            self._vertices[key] = self.corner(position)
        return self._vertices[key]

    def pieces(self, edge: Edge, k: int) -> tuple[Piece, ...]:
        """Image k of an edge, in the edge's own sense, as the pieces that cuts leave."""
        key = (edge, k % edge.pattern.order)
        if key not in self._pieces:
            self._pieces[key] = tuple(self._made_pieces(*key))
        return self._pieces[key]

    def beside(self, start: Any, end: Any, line: Straight | Circular) -> tuple[Any, Course]:
        """An edge between vertices that is no edge of ours, and its course."""
        course = _elementary(line)
        return self._edge(course.made, start, end, course.first, course.at(1.0)), course

    def corner(self, position: Array) -> Any:
        """A vertex that is no corner of ours."""
        from OCP.gp import gp_Pnt
        from OCP.TopoDS import TopoDS_Vertex

        vertex = TopoDS_Vertex()
        self._builder.MakeVertex(vertex, gp_Pnt(*position.tolist()), LEAST_TOLERANCE)
        return vertex

    def at_a_point(self, vertex: Any) -> Any:
        """A degenerate edge: a pole or an apex, its parameter from 0 to 1."""
        from OCP.TopoDS import TopoDS_Edge

        edge = TopoDS_Edge()
        self._builder.MakeEdge(edge)
        self._builder.Degenerated(edge, True)
        self._joined(edge, vertex, vertex)
        self._builder.Range(edge, 0.0, 1.0)
        return edge

    def _made_pieces(self, edge: Edge, k: int) -> Iterable[Piece]:
        course = self.course(edge)
        image = edge.pattern.image(k) if k else None
        curve = course.made if image is None else course.made.Transformed(transform(image))
        fractions = [0.0, *sorted(self._cuts.get((edge, k), ())), 1.0]
        vertices = [self.vertex(edge.start, k)]
        for fraction in fractions[1:-1]:
            point = edge.curve.point(edge.curve.parameter(fraction))
            vertices.append(self.corner(point if image is None else image.points(point)))
        vertices.append(self.vertex(edge.end, k + edge.end_turn))
        for (first, last), (start, end) in zip(pairwise(fractions), pairwise(vertices), strict=True):
            made = self._edge(curve, start, end, course.at(first), course.at(last))
            yield Piece(made, first, last)

    def _edge(self, curve: Any, start: Any, end: Any, first: float, last: float) -> Any:
        from OCP.TopoDS import TopoDS_Edge

        edge = TopoDS_Edge()
        self._builder.MakeEdge(edge, curve, LEAST_TOLERANCE)
        self._joined(edge, start, end)
        self._builder.Range(edge, first, last)
        return edge

    def _joined(self, edge: Any, start: Any, end: Any) -> None:
        from OCP.TopAbs import TopAbs_FORWARD, TopAbs_REVERSED

        self._builder.Add(edge, start.Oriented(TopAbs_FORWARD))
        self._builder.Add(edge, end.Oriented(TopAbs_REVERSED))

    def _course(self, edge: Edge) -> Course:
        line = self._approximation.edges.get(edge)
        if line is not None:
            return _elementary(line)
        curve = spline_curve(self._approximation.bases[edge], self._approximation.poles(edge))
        return Course(made=curve, first=0.0, span=1.0)


def _elementary(line: Straight | Circular) -> Course:
    return _segment(line) if isinstance(line, Straight) else _circle(line)


def _segment(line: Straight) -> Course:
    from OCP.Geom import Geom_Line
    from OCP.gp import gp_Dir, gp_Pnt

    direction = (line.last - line.first) / line.length
    return Course(
        made=Geom_Line(gp_Pnt(*line.first.tolist()), gp_Dir(*direction.tolist())), first=0.0, span=line.length
    )


def _circle(circle: Circular) -> Course:
    from OCP.Geom import Geom_Circle
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    frame = gp_Ax2(gp_Pnt(*circle.centre.tolist()), *(gp_Dir(*axis.tolist()) for axis in (circle.axis, circle.x)))
    return Course(made=Geom_Circle(frame, circle.radius), first=circle.start, span=circle.sweep)

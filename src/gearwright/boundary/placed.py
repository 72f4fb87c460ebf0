"""Boundaries put elsewhere, and boundaries whose patterns are written out image by image."""

from __future__ import annotations

from dataclasses import replace

from ..curves.curve import Curve, mapped
from ..curves.line import Line
from ..motions.placed import placed
from ..placement import Placement
from ..surfaces.placed import placed_surface
from .boundary import Boundary
from .edge import Edge, EdgeUse, Vertex
from .faces import Cap, CapLoop, Patch
from .pattern import ALONE


def placed_boundary(boundary: Boundary, placement: Placement) -> Boundary:
    """The boundary of the body put elsewhere: the same faces by the same names, patterns about their moved axis."""
    moved = _Moved(placement)
    return Boundary(
        patches=tuple(moved.patch(patch) for patch in boundary.patches),
        caps=tuple(moved.cap(cap) for cap in boundary.caps),
    )


def written_out(boundary: Boundary) -> Boundary:
    """The same boundary without patterns: every image of an edge or patch is one of its own, named "… image k"."""
    if all(edge.pattern.order == 1 for edge in boundary.edges):
        return boundary
    images = _Images()
    return Boundary(
        patches=tuple(images.patch(patch, k) for patch in boundary.patches for k in range(patch.pattern.order)),
        caps=tuple(replace(cap, loops=tuple(images.loop(loop) for loop in cap.loops)) for cap in boundary.caps),
    )


class _Moved:
    """Vertices and edges put elsewhere, each once, so that faces go on sharing them."""

    def __init__(self, placement: Placement):
        self._placement = placement
        self._vertices: dict[Vertex, Vertex] = {}
        self._edges: dict[Edge, Edge] = {}

    def _vertex(self, vertex: Vertex) -> Vertex:
        if vertex not in self._vertices:
            self._vertices[vertex] = Vertex(
                name=vertex.name,
                position=self._placement.points(vertex.position),
                pattern=vertex.pattern.moved(self._placement),
            )
        return self._vertices[vertex]

    def edge(self, edge: Edge) -> Edge:
        if edge not in self._edges:
            start = self._vertex(edge.start)
            self._edges[edge] = replace(
                edge,
                curve=placed_curve(edge, self._placement),
                start=start,
                end=self._vertex(edge.end),
                pattern=edge.pattern.moved(self._placement),
            )
        return self._edges[edge]

    def _use(self, use: EdgeUse) -> EdgeUse:
        return replace(use, edge=self.edge(use.edge))

    def patch(self, patch: Patch) -> Patch:
        first, right, second, left = map(self._use, patch.sides)
        return replace(
            patch,
            motion=placed(patch.motion, self._placement),
            sides=(first, right, second, left),
            pattern=patch.pattern.moved(self._placement),
            surface=None if patch.surface is None else placed_surface(patch.surface, self._placement),
        )

    def cap(self, cap: Cap) -> Cap:
        loops = tuple(replace(loop, uses=tuple(map(self._use, loop.uses))) for loop in cap.loops)
        return replace(cap, surface=placed_surface(cap.surface, self._placement), loops=loops)


class _Images:
    """Images of vertices and edges, each made once."""

    def __init__(self) -> None:
        self._vertices: dict[tuple[Vertex, int], Vertex] = {}
        self._edges: dict[tuple[Edge, int], Edge] = {}

    def _vertex(self, vertex: Vertex, k: int) -> Vertex:
        key = (vertex, k % vertex.pattern.order)
        if key not in self._vertices:
            position = vertex.pattern.images(vertex.position[None])[key[1], 0]
            self._vertices[key] = Vertex(name=_image_name(vertex.name, key[1]), position=position)
        return self._vertices[key]

    def edge(self, edge: Edge, k: int) -> Edge:
        key = (edge, k % edge.pattern.order)
        if key not in self._edges:
            start, end = self._vertex(edge.start, key[1]), self._vertex(edge.end, key[1] + edge.end_turn)
            self._edges[key] = Edge(
                name=_image_name(edge.name, key[1]),
                curve=placed_curve(edge, edge.pattern.image(key[1])) if key[1] else edge.curve,
                start=start,
                end=end,
            )
        return self._edges[key]

    def _use(self, use: EdgeUse, k: int) -> EdgeUse:
        return EdgeUse(edge=self.edge(use.edge, k + use.turn), reverse=use.reverse)

    def patch(self, patch: Patch, k: int) -> Patch:
        first, right, second, left = (self._use(use, k) for use in patch.sides)
        image = patch.pattern.image(k)
        return replace(
            patch,
            name=_image_name(patch.name, k),
            motion=placed(patch.motion, image) if k else patch.motion,
            sides=(first, right, second, left),
            pattern=ALONE,
            surface=None if patch.surface is None else placed_surface(patch.surface, image),
        )

    def loop(self, loop: CapLoop) -> CapLoop:
        order = loop.pattern.order
        onward = -1 if loop.uses[-1].edge.end_turn < 0 else 1
        uses = tuple(self._use(use, onward * k) for k in range(order) for use in loop.uses)
        return CapLoop(uses=uses, reverse=loop.reverse)


def placed_curve(edge: Edge, placement: Placement) -> Curve:
    """An edge's curve put elsewhere; a degenerate edge stays one point, exactly."""
    if edge.degenerate:
        position = tuple(placement.points(edge.start.position).tolist())
        return Line(first=position, last=position)
    return mapped(edge.curve, placement.matrix, placement.shift)


def _image_name(name: str, k: int) -> str:
    return f"{name} image {k + 1}" if k else name

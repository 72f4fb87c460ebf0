"""Edges that are opposite sides of patches, one after another: they are cut alike, and share a parametrisation."""

from __future__ import annotations

from .boundary import Boundary
from .edge import Edge


class Groups:
    """The groups of such edges, as a union–find forest; each is known by one edge of it."""

    def __init__(self, boundary: Boundary):
        self._parent: dict[Edge, Edge] = {edge: edge for edge in boundary.edges}
        for patch in boundary.patches:
            first, right, second, left = (use.edge for use in patch.sides)
            self._parent[self.of(second)] = self.of(first)
            self._parent[self.of(left)] = self.of(right)

    def of(self, edge: Edge) -> Edge:
        while self._parent[edge] is not edge:
            edge = self._parent[edge]
        return edge

"""The boundary of a solid: faces that share edges, checked when it is made."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import GeometryError, Problem
from .edge import Edge, EdgeUse
from .faces import Cap, Patch
from .flux import boundary_flux

CLOSED = 1e-9
"""Largest |∮ n dA| / ∮ dA of a closed boundary: what a coarse quadrature of its patches leaves, with room."""
_CHECK_NODES = (12, 24, 48)  # a curve; more where fewer do not show it closed


@dataclass(frozen=True, kw_only=True, eq=False)
class Boundary:
    """Faces that close up: each edge is used twice, in opposite senses (a degenerate one once), outward.

    Raises GeometryError naming every edge that is not used so, or the closure that fails.
    """

    patches: tuple[Patch, ...]
    caps: tuple[Cap, ...]

    def __post_init__(self) -> None:
        problems = self._edge_problems() or self._closure_problems()
        if problems:
            raise GeometryError("The faces do not bound a solid", problems)

    def uses(self) -> Iterator[EdgeUse]:
        """Every use of an edge by a face."""
        for patch in self.patches:
            yield from patch.sides
        for cap in self.caps:
            for loop in cap.loops:
                for use in loop.uses:
                    yield EdgeUse(edge=use.edge, reverse=use.reverse != loop.reverse, turn=use.turn)

    @property
    def edges(self) -> tuple[Edge, ...]:
        return tuple(dict.fromkeys(use.edge for use in self.uses()))

    def _edge_problems(self) -> list[Problem]:
        forward = Counter(use.edge for use in self.uses() if not use.reverse)
        backward = Counter(use.edge for use in self.uses() if use.reverse)
        return [
            Problem(
                f"edge {edge.name}", f"used {forward[edge]} times forward and {backward[edge]} backward, not once each"
            )
            for edge in self.edges
            if (forward[edge] + backward[edge] != 1 if edge.degenerate else (forward[edge], backward[edge]) != (1, 1))
        ]

    def _closure_problems(self) -> list[Problem]:
        for nodes in _CHECK_NODES:
            flux = boundary_flux(self.patches, self.caps, nodes)
            residual = float(np.linalg.norm(flux.area_vector)) / flux.area
            if residual <= CLOSED:
                break
        else:
            return [
                Problem(f"∮ n dA / ∮ dA = {residual:.3g}", "must vanish; a face lies apart from its edges or is turned")
            ]
        if not flux.matrix[0, 0] > 0.0:
            return [Problem(f"volume = {flux.matrix[0, 0]:.6g}", "must be positive; the faces are turned inward")]
        return []

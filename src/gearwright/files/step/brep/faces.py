"""Faces in Open CASCADE: a surface, and loops of edges with their curves in its parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ....arrays import Array
from .bases import COARSEST
from .edges import LEAST_TOLERANCE
from .splines import spline_curve_2d


@dataclass(frozen=True, kw_only=True)
class Use:
    """An edge as a loop runs along it.

    made       the edge in Open CASCADE
    reverse    whether the loop runs against it
    on_surface its curve in the surface's parameters, by the edge's parameter; None on planes, which need none
    deviation  how far (length) it is from the edge there, in space
    """

    made: Any
    reverse: bool
    on_surface: Any | None = None
    deviation: float = 0.0

    @property
    def turned(self) -> Use:
        return replace(self, reverse=not self.reverse)


Wire = Sequence[Use]
"""Uses one after another around a loop, counter-clockwise seen from outside the body."""


def face(surface: Any, wires: Sequence[Wire], *, outward: bool) -> Any:
    """A face of the body. outward   whether the surface's own normal, ∂U × ∂V, points out of the body"""
    from OCP.BRep import BRep_Builder
    from OCP.TopAbs import TopAbs_FORWARD, TopAbs_REVERSED
    from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

    builder = BRep_Builder()
    made = TopoDS_Face()
    builder.MakeFace(made, surface, LEAST_TOLERANCE)
    # a face is kept as seen along its surface's normal, then turned as a whole
    own = [wire if outward else [use.turned for use in reversed(wire)] for wire in wires]
    for wire in own:
        loop = TopoDS_Wire()
        builder.MakeWire(loop)
        for use in wire:
            builder.Add(loop, use.made.Oriented(TopAbs_REVERSED if use.reverse else TopAbs_FORWARD))
        loop.Closed(True)
        builder.Add(made, loop)
    _put_curves(builder, made, [use for wire in own for use in wire])
    return made if outward else made.Reversed()


def _put_curves(builder: Any, made: Any, uses: Sequence[Use]) -> None:
    """Gives edges their curves on the face: one, or two where the face meets itself there."""
    left = [use for use in uses if use.on_surface is not None]
    while left:
        use, left = left[0], left[1:]
        mates = [other for other in left if other.made.IsSame(use.made)]
        if mates:
            left.remove(mates[0])
            forward, backward = (mates[0], use) if use.reverse else (use, mates[0])
            off = max(use.deviation, mates[0].deviation, LEAST_TOLERANCE)
            builder.UpdateEdge(use.made, forward.on_surface, backward.on_surface, made, off)
        else:
            builder.UpdateEdge(use.made, use.on_surface, made, max(use.deviation, LEAST_TOLERANCE))


_UNIT_SPEED = 1e-12


def line_on_surface(first: float, last: float, start: Array, end: Array) -> Any:
    """A straight line in parameters, from those (2,) at an edge's parameter `first` to those at `last`."""
    from OCP.Geom2d import Geom2d_Line
    from OCP.gp import gp_Dir2d, gp_Pnt2d

    rate = (end - start) / (last - first)
    if abs(float(np.linalg.norm(rate)) - 1.0) > _UNIT_SPEED:
        return spline_curve_2d(COARSEST, np.stack([start, end]), first, last)
    origin = start - first * rate
    return Geom2d_Line(gp_Pnt2d(*origin.tolist()), gp_Dir2d(*rate.tolist()))

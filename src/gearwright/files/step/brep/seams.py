"""The one loop of a face once around an axis: along an edge, over the seam, back along the other edge, and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ....arrays import Array
from .edges import Edges
from .elementary import Circular, Straight
from .faces import Use, Wire, line_on_surface
from .rounds import Layout, Seam
from .surfaces import Sphere

_TURN = 2.0 * np.pi


def joined(layout: Layout, seam: Seam, around: Sequence[Wire], edges: Edges) -> Wire:
    """The loop of a face with a seam, from the loops around the axis, each begun where the seam ends."""
    heights = layout.surface.chart(np.array([seam.first, seam.last]))[:, 1]
    out, back = (_TURN, 0.0) if layout.loops[0].winding > 0 else (0.0, _TURN)
    start = _entry(around[0])
    end = edges.corner(seam.last) if seam.to_pole else _entry(around[1])
    made, course = edges.beside(start, end, _line(layout, seam.first, seam.last))

    def at(azimuth: float) -> Any:
        ends = (np.array([azimuth, height]) for height in heights)
        return line_on_surface(course.first, course.at(1.0), *ends)

    if seam.to_pole:
        corners = (np.array([azimuth, heights[1]]) for azimuth in (out, back))
        over: Wire = [Use(made=edges.at_a_point(end), reverse=False, on_surface=line_on_surface(0.0, 1.0, *corners))]
    else:
        over = around[1]
    there, home = (Use(made=made, reverse=r, on_surface=at(a)) for r, a in ((False, out), (True, back)))
    return [*around[0], there, *over, home]


def _entry(wire: Wire) -> Any:
    """The vertex at which a loop begins."""
    from OCP.TopExp import TopExp

    vertex = TopExp.LastVertex_s if wire[0].reverse else TopExp.FirstVertex_s
    return vertex(wire[0].made, False)


def _line(layout: Layout, first: Array, last: Array) -> Straight | Circular:
    """The seam in space: a meridian."""
    if not isinstance(layout.surface, Sphere):
        return Straight(first=first, last=last)
    centre, radius = layout.surface.frame.origin, layout.surface.radius
    x, arm = (first - centre) / radius, (last - centre) / radius
    axis = np.cross(x, arm)
    sine = float(np.linalg.norm(axis))
    sweep = float(np.arctan2(sine, x @ arm))
    return Circular(centre=centre, x=x, axis=axis / sine, radius=radius, start=0.0, sweep=sweep)

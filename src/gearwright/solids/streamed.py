"""Properties of binary STL files of any size, in passing: in constant memory, without joining vertices."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np

from ..errors import GeometryError, Problem
from ..files.stl.records import Records, records
from ..moments.polyhedron import CLOSED
from ..moments.soup import Look, Soup, soup_moments
from .extent import Extent
from .properties import MassProperties


def stream_properties(path: str | Path, density: float = 1.0, *, threads: int | None = None) -> MassProperties:
    """Volume, centroid and inertia of a binary STL file of any size, read once.

    density   mass per cubed length unit
    threads   None for as many as there are processors

    That every edge has as many faces on one side as on the other is checked by numbers of 64 bits that must add up
    to nought, so that a hole or a flipped face is not missed but once in 2⁶⁴ times. Which bodies there are, and
    whether one lies inside another, is not looked for: `Polyhedron.load` does, in more memory.
    Raises FileError, MachineError; GeometryError if the faces do not close, or turn inward.
    """
    source = records(path)
    soup = Soup(corners=source.corners, count=source.count, threads=threads)
    return soup_properties(source, soup, soup.look(soup.middle), density)


def soup_properties(source: Records, soup: Soup, look: Look, density: float) -> MassProperties:
    """Properties from a look at the soup of a file about its middle. Raises GeometryError."""
    found = soup_moments(soup, look)
    if look.sides or not found.closure <= CLOSED or not np.all(np.isfinite(look.sums.rounded)):
        raise GeometryError(
            f"{source.path} does not bound a solid",
            [
                Problem(
                    f"closure residual {found.closure:.2g}",
                    "some edges have no face on one side, or faces turn inward, or coordinates are not finite;"
                    " `gearwright check` names the places",
                )
            ],
        )
    if not found.body.volume > 0.0:
        message = "must be positive; all faces are turned inward, or cancel each other"
        raise GeometryError(
            f"{source.path} does not bound a solid", [Problem(f"volume {found.body.volume:.6g}", message)]
        )
    return MassProperties.from_moments(found.body, density=density, find_extent=partial(Extent, found.area, look.box))

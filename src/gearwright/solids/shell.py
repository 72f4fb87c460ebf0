"""Thin shells: mass properties of a surface that has a thickness."""

from __future__ import annotations

from functools import partial

from ..arrays import Array, Indices
from ..errors import GeometryError, ParameterError, Problem
from ..moments.shell import surface_moments
from ..parameters import Parameter
from .extent import Extent
from .properties import MassProperties

_THICKNESS = Parameter(meaning="thickness of a shell", unit="length", above=0)


def shell_properties(
    vertices: Array, indices: Indices, offsets: Indices, thickness: float, density: float = 1.0
) -> MassProperties:
    """Of the sheet half a thickness to either side of the faces, to first order in the thickness.

    Volume = area × thickness, centroid and second moment those of the surface; what the sheet has too much or too
    little at edges, and its own spread across, are of higher order. The surface may be open.

    The faces are planar.
    Raises ParameterError if the thickness is not positive; GeometryError if there is no area.
    """
    if wrong := _THICKNESS.problem(thickness):
        raise ParameterError("A shell", [Problem(f"thickness = {thickness!r}", wrong)])
    found = surface_moments(vertices, indices, offsets) if len(offsets) > 1 else None
    if found is None or not found.area > 0.0:
        problem = Problem(f"{len(offsets) - 1} faces", "they have no area; at least one with an area is needed")
        raise GeometryError("This surface is no shell", [problem])
    return MassProperties(
        volume=found.area * thickness,
        centroid=found.centroid,
        central_second=found.central_second * thickness,
        density=density,
        find_extent=partial(Extent, found.area, found.bounding_box),
        method="polyhedron",
        error_bound=found.error_bound,
    )

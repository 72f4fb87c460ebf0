"""What notebooks show of solids, polyhedra and mass properties: tables, and a small picture where that is quick."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..boundary.extent import rough_diagonal
from ..colours import BRASS
from ..errors import GeometryError
from ..files.assembly import Assembly, Faceted, Part
from ..html_tables import beside, number, numbers, table

if TYPE_CHECKING:
    from ..pictures import View
    from .polyhedron import Polyhedron
    from .properties import MassProperties
    from .solid import Solid

MOST_TRIANGLES = 20_000
"""Up to so many a small picture takes about 0.3 s."""

COARSE = 2e-3
"""Chord tolerance in small pictures, in diagonals of the bounding box."""

_SIZE, _WIDTH = (480, 320), 240  # pixels of the picture, and of the page

MOST_EXAMINED = 300_000
"""Faces up to which a polyhedron's properties are found to be shown: 0.1 s."""


def properties_summary(properties: MassProperties) -> str:
    """Volume, centroid and inertia as a table."""
    return table("mass properties", ("", "about", "value"), property_rows(properties))


def property_rows(properties: MassProperties, length_unit: str = "") -> list[tuple[str, str, str]]:
    """Name, point or axes, and value of each property; units where the length unit is known."""
    density = f"{number(properties.density)} per {length_unit or 'length unit'}³"
    tensor = properties.central_inertia
    return [
        ("volume", "", _with_unit(number(properties.volume, 10), length_unit, "³")),
        *([("mass", density, number(properties.mass, 10))] if properties.density != 1.0 else []),
        ("centroid x, y, z", "origin", _with_unit(numbers(properties.centroid, 8), length_unit, "")),
        ("Ixx, Iyy, Izz", "centroid", numbers(np.diag(tensor))),
        ("Ixy, Iyz, Izx", "centroid", _beside_noise(tensor)),
        ("Ixx, Iyy, Izz", "origin", numbers(np.diag(properties.inertia))),
        ("principal moments", "centroid", numbers(properties.principal_moments)),
        ("radii of gyration", "principal axes", _with_unit(numbers(properties.radii_of_gyration), length_unit, "")),
        ("found by", "", f"{properties.method}, relative error below {properties.error_bound:.0e}"),
        *(("warning", "", warning) for warning in properties.warnings),
    ]


def _with_unit(text: str, length_unit: str, power: str) -> str:
    return f"{text} {length_unit}{power}" if length_unit else text


def _beside_noise(tensor: np.ndarray) -> str:
    """The products with what is rounding of the diagonal as 0."""
    least = 1e-14 * float(np.abs(tensor).max())
    return ", ".join(number(v if abs(v) > least else 0.0) for v in tensor[[0, 1, 2], [1, 2, 0]])


def polyhedron_summary(polyhedron: Polyhedron) -> str:
    """Size, properties or what is wrong, and a picture."""
    faces = len(polyhedron.offsets) - 1
    rows = [("faces", "", f"{faces:,}"), ("vertices", "", f"{len(polyhedron.vertices):,}")]
    if not faces or faces > MOST_EXAMINED:
        return table("polyhedron", ("", "about", "value"), rows)
    try:
        rows += property_rows(polyhedron.properties())
    except GeometryError as refusal:
        rows += [(problem.subject, "", problem.message) for problem in refusal.problems]
    return beside(table("polyhedron", ("", "about", "value"), rows), small_picture("polyhedron", [polyhedron]))


def solid_summary(solid: Solid) -> str:
    """Properties and a picture."""
    return beside(
        table("solid", ("", "about", "value"), property_rows(solid.properties())),
        small_picture("solid", [coarse(solid)]),
    )


def coarse(solid: Solid) -> Polyhedron:
    """As finely as a small picture needs it."""
    return solid.polyhedron(COARSE * rough_diagonal(solid.boundary))


def small_picture(title: str, shapes: list[Polyhedron]) -> str:
    """Bodies where they are as one small picture; nothing where it would not be quick."""
    return assembly_picture(
        title, Assembly(name=title, parts=tuple(Part(name="", shape=s, colour=BRASS) for s in shapes))
    )


def assembly_picture(title: str, assembly: Assembly[Faceted], view: View | None = None) -> str:
    """Bodies where they stand as one small picture; nothing where it would not be quick."""
    from ..viewer.still import image, still

    corners = sum(len(part.shape.indices) - 2 * (len(part.shape.offsets) - 1) for part in assembly.parts)
    if corners > MOST_TRIANGLES:
        return ""
    try:
        return image(still(title, assembly, view, _SIZE, titled=False), title, _WIDTH)
    except GeometryError:
        return ""  # a face that cannot be cut into triangles

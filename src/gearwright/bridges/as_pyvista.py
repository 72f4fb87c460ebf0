"""Bodies as PyVista meshes and blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..files.assembly import Assembly, Faceted, Part, placed_vertices
from .extras import required

if TYPE_CHECKING:
    import pyvista


def pyvista_mesh(part: Part[Faceted], length_unit: str | None) -> pyvista.PolyData:
    """A body in its own frame, its polygons kept.

    Its colour is in the cell array "RGB" (`plot(scalars="RGB", rgb=True)`), name, unit and colour in `user_dict`.
    Raises MachineError without PyVista.
    """
    return _mesh(part, part.shape.vertices, length_unit)


def pyvista_blocks(assembly: Assembly[Faceted]) -> pyvista.MultiBlock:
    """Bodies where they stand as blocks of their names; the placement (4, 4) of each is in its `user_dict`, too.

    Raises MachineError without PyVista.
    """
    blocks = required("pyvista", "PyVista", "notebook").MultiBlock()
    for part in assembly.parts:
        mesh = _mesh(part, placed_vertices(part), assembly.length_unit)
        mesh.user_dict["placement"] = part.placement.tolist()
        blocks.append(mesh, part.name)
    blocks.user_dict.update(name=assembly.name, length_unit=assembly.length_unit)
    return blocks


def _mesh(part: Part[Faceted], vertices: Array, length_unit: str | None) -> pyvista.PolyData:
    library = required("pyvista", "PyVista", "notebook")
    indices, offsets = part.shape.indices, part.shape.offsets
    # before the corners of each face stands their number
    faces = np.insert(indices, offsets[:-1], np.diff(offsets))
    mesh = library.PolyData(np.array(vertices, float), faces)
    mesh.user_dict.update(name=part.name, length_unit=length_unit)
    if part.colour is not None:
        mesh.user_dict["colour"] = list(part.colour)
        shade = np.rint(np.array(part.colour) * 255.0).astype(np.uint8)
        mesh.cell_data["RGB"] = np.tile(shade, (len(offsets) - 1, 1))
    return mesh

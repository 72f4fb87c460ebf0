"""Bodies as trimesh meshes and scenes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..files.assembly import Assembly, Faceted, Part
from .extras import required

if TYPE_CHECKING:
    import trimesh


def trimesh_mesh(part: Part[Faceted], length_unit: str | None) -> trimesh.Trimesh:
    """A body in its own frame as triangles over the same vertices, with its colour; name and unit are in `metadata`.

    Raises MachineError without trimesh; GeometryError where a face cannot be cut into triangles.
    """
    library = required("trimesh", "trimesh", "mesh")
    mesh = library.Trimesh(
        vertices=part.shape.vertices,
        faces=part.shape.simple_triangles(),
        metadata={"name": part.name, "length_unit": length_unit},
        process=False,  # which would join and reorder vertices
    )
    mesh.units = length_unit
    if part.colour is not None:
        mesh.visual.face_colors = np.rint(np.array([*part.colour, 1.0]) * 255.0).astype(np.uint8)
    return mesh


def trimesh_scene(assembly: Assembly[Faceted]) -> trimesh.Scene:
    """Bodies where they stand: each is a geometry and a node of its name. Raises as `trimesh_mesh`."""
    scene = required("trimesh", "trimesh", "mesh").Scene()
    scene.metadata.update(name=assembly.name, length_unit=assembly.length_unit)
    for part in assembly.parts:
        mesh = trimesh_mesh(part, assembly.length_unit)
        scene.add_geometry(mesh, geom_name=part.name, node_name=part.name, transform=part.placement)
    return scene

"""Binary STL files out.

They hold triangles with no shared vertices, single precision: about seven digits of the distance from the origin.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ... import disk
from ...arrays import Array, Indices
from ...errors import FileError
from ...moments.faces import triangle_vectors
from ..assembly import Assembly, Faceted, placed_vertices
from ..noted_unit import unit_note
from ..rounding import in_single_precision
from .layout import HEADER, RECORD

_MOST = 2**32 - 1
_BLOCK = 1 << 15
"""Triangles at a time, which stay in the cache of a processor."""


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes the triangles of all parts, where they stand, as a binary STL file, whole or not at all.

    Corners are rounded to single precision, equal vertices equally, so a closed boundary stays closed.
    Normals are those of the rounded corners, 0 where these have no area.
    Raises FileError if single precision cannot hold a body or the name is not a file's; GeometryError if a face
    cannot be cut into triangles; MachineError if the disk does not take it.
    """
    pieces = [(placed_vertices(part), part.shape.simple_triangles()) for part in assembly.parts]
    count = sum(len(triangles) for _, triangles in pieces)
    if count > _MOST:
        raise FileError(f"{path}: {count} triangles; an STL file holds at most {_MOST}; use a coarser tolerance")
    rounded = [(in_single_precision(path, "STL", vertices), triangles) for vertices, triangles in pieces]
    head = unit_note("binary STL", assembly.length_unit)
    with disk.written_whole(path) as stream:
        stream.write(head.encode("ascii", "replace")[:HEADER].ljust(HEADER))
        stream.write(count.to_bytes(4, "little"))
        for single, triangles in rounded:
            for start in range(0, len(triangles), _BLOCK):
                stream.write(_records(single, triangles[start : start + _BLOCK]).data)


def _records(vertices: Array, triangles: Indices) -> NDArray[np.void]:
    records = np.zeros(len(triangles), dtype=RECORD)
    normals = triangle_vectors(vertices, triangles)
    lengths = np.linalg.norm(normals, axis=-1, keepdims=True)
    records["normal"] = normals / np.where(lengths > 0.0, lengths, 1.0)
    records["corners"] = vertices[triangles]
    return records

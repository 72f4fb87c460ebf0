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
from .layout import HEADER, RECORD

_MOST = 2**32 - 1
_BLOCK = 1 << 18

_COARSEST = 1e-4
"""Rounding to single precision, relative to the body's diagonal, beyond which writing is refused."""


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
    rounded = [(_single_precision(str(path), vertices), triangles) for vertices, triangles in pieces]
    head = f"Gearwright binary STL, lengths in {assembly.length_unit or 'an unknown unit'}"
    with disk.written_whole(path) as stream:
        stream.write(head.encode("ascii", "replace")[:HEADER].ljust(HEADER))
        stream.write(count.to_bytes(4, "little"))
        for single, triangles in rounded:
            for start in range(0, len(triangles), _BLOCK):
                stream.write(_records(single, triangles[start : start + _BLOCK]).data)


def _single_precision(path: str, vertices: Array) -> Array:
    """The vertices rounded to single precision, still as float64."""
    if not len(vertices):
        return vertices
    with np.errstate(over="ignore"):
        single = vertices.astype(np.float32).astype(np.float64)
    error = float(np.abs(single - vertices).max())
    diagonal = float(np.linalg.norm(vertices.max(axis=0) - vertices.min(axis=0)))
    if not error <= _COARSEST * diagonal:
        raise FileError(
            f"{path}: single precision, all that STL has, would move points by {error:.3g}, and the body measures"
            f" {diagonal:.3g}; move it to the origin, or use a length unit that suits it"
        )
    return single


def _records(vertices: Array, triangles: Indices) -> NDArray[np.void]:
    records = np.zeros(len(triangles), dtype=RECORD)
    normals = triangle_vectors(vertices, triangles)
    lengths = np.linalg.norm(normals, axis=-1, keepdims=True)
    records["normal"] = normals / np.where(lengths > 0.0, lengths, 1.0)
    records["corners"] = vertices[triangles]
    return records

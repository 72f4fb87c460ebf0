"""PLY files out, binary with the least byte first: polygons as they are, all parts as one body."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ... import disk
from ...errors import FileError
from ..assembly import Assembly, Faceted, Part, placed_vertices
from ..colour_values import WHITE, bytes_of
from ..noted_unit import unit_note
from ..text.written import one_line

_MOST = 2**31 - 1
_COLOURS = ("red", "green", "blue")


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes all parts where they stand in double precision, whole or not at all.

    Where a part has a colour, every vertex has one, white in parts without. Names of parts are in comments.
    Raises FileError if the name is not a file's or the vertices are too many for whole numbers of PLY; MachineError
    if the disk does not take it.
    """
    coloured = any(part.colour for part in assembly.parts)
    shapes = [part.shape for part in assembly.parts]
    vertices = sum(len(shape.vertices) for shape in shapes)
    if vertices > _MOST:
        raise FileError(f"{path}: {vertices} vertices; a PLY file numbers at most {_MOST}; use a coarser tolerance")
    most = max(int(np.diff(shape.offsets).max(initial=0)) for shape in shapes)
    faces = sum(len(shape.offsets) - 1 for shape in shapes)
    counted = "uchar" if most < 256 else "int"
    with disk.written_whole(path) as stream:
        stream.write(_header(assembly, vertices, faces, coloured, counted).encode())
        for part in assembly.parts:
            stream.write(_vertices(part, coloured).data)
        first = 0
        for shape in shapes:
            stream.write(_faces(shape, first, "u1" if counted == "uchar" else "<i4").data)
            first += len(shape.vertices)


def _header(assembly: Assembly[Faceted], vertices: int, faces: int, coloured: bool, counted: str) -> str:
    lines = ["ply", "format binary_little_endian 1.0", f"comment {unit_note('PLY', assembly.length_unit)}"]
    lines += [f"comment part {one_line(part.name)[:80]}" for part in assembly.parts[:100]]
    lines += [f"element vertex {vertices}", *(f"property double {axis}" for axis in "xyz")]
    lines += [f"property uchar {name}" for name in _COLOURS] if coloured else []
    lines += [f"element face {faces}", f"property list {counted} int vertex_indices", "end_header", ""]
    return "\n".join(lines)


def _vertices(part: Part[Faceted], coloured: bool) -> NDArray[np.void]:
    colours = [(name, "u1") for name in _COLOURS] if coloured else []
    records = np.empty(len(part.shape.vertices), [("place", "<f8", 3), *colours])
    records["place"] = placed_vertices(part)
    if coloured:
        for name, value in zip(_COLOURS, bytes_of(part.colour or WHITE), strict=True):
            records[name] = value
    return records


def _faces(shape: Faceted, first: int, counted: str) -> NDArray[np.uint8]:
    """The bytes of every face: how many corners it has, and their vertices."""
    sizes = np.diff(shape.offsets).astype(counted)
    corners = (shape.indices + first).astype("<i4")
    counts = sizes.view(np.uint8).reshape(len(sizes), -1)
    places = shape.offsets[:-1, None] * corners.itemsize + np.arange(counts.size).reshape(counts.shape)
    result = np.empty(sizes.nbytes + corners.nbytes, np.uint8)
    of_corners = np.ones(len(result), bool)
    of_corners[places] = False
    result[places] = counts
    result[of_corners] = corners.view(np.uint8)
    return result

"""STL files: binary and text in, binary out.

An STL file is a list of triangles with no shared vertices, no length unit and, in its binary form,
single precision: about seven digits of the distance from the origin.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import disk
from ..arrays import Array, Indices
from ..errors import FileError
from ..moments.faces import triangle_vectors
from ..moments.soup import NOUGHT
from .contents import Body, Contents, Data
from .rounding import single_precision
from .stl_text import looks_like_text, parse_text
from .welding import Points, welded

HEADER = 80
START = HEADER + 4
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_MOST = 2**32 - 1
_BLOCK = 1 << 18
_ABSURD = 1000  # times more than the file has: what stands for a count is none
_SURPLUS = 0.5
"""Bytes after the triangles, relative to theirs, that programs may have added; with more the count is wrong."""
_EMPTY = "{}: an STL file without triangles; nothing was exported, or only empty bodies"
UNIT = re.compile(rb"lengths in (mm|in)\b")

_COARSEST = 1e-4
"""Rounding to single precision, relative to the body's diagonal, beyond which writing is refused."""


def parse(data: Data, name: str) -> Contents:
    """The bodies of an STL file: vertices with equal coordinates joined within each, and triangles.

    Every solid of a text file is a body with its name; a binary file is one body. Coordinates are taken as they stand,
    but those within 2⁻⁴⁶ × the largest of the body are 0. The stored normals are ignored: the order of the corners says
    which side is out. Rounding is that of single precision in binary files, as `Written.rounding` finds it in text.
    Raises FileError if the data are not a whole STL file of finite coordinates.
    """
    data = bytes(data)
    if not data:
        raise FileError(f"{name}: the file is empty; an STL file was expected; write it again")
    found = UNIT.search(data[:HEADER])
    length_unit = found[1].decode() if found else None
    count = int.from_bytes(data[HEADER:START], "little") if len(data) >= START else 0
    needed = START + count * RECORD.itemsize
    if (len(data) < START or len(data) != needed) and looks_like_text(data):
        return _text(data, name, length_unit)
    if len(data) < START or not needed <= len(data) <= needed + _SURPLUS * (needed - START):
        _refuse_length(name, len(data), count)
    corners = np.frombuffer(data, dtype=RECORD, offset=START, count=count)["corners"].reshape(-1, 3)
    if not count:
        raise FileError(_EMPTY.format(name))
    if not np.isfinite(corners).all():
        _refuse_not_finite(name, corners)
    vertices, triangles = _joined(corners)
    rounding = single_precision(float(np.abs(corners).max()))
    surplus = len(data) - needed
    return Contents(
        bodies=(_body("", vertices, triangles, rounding),),
        length_unit=length_unit,
        remarks=(f"left out: {surplus} bytes after the {count} triangles that the file announces",) if surplus else (),
    )


def _text(data: bytes, path: str, length_unit: str | None) -> Contents:
    solids, written = parse_text(path, data)
    bodies, empty = [], 0
    for solid in solids:
        if len(solid.corners):
            vertices, triangles = _joined(solid.corners)
            bodies.append(_body(solid.name, vertices, triangles, written.rounding(vertices)))
        else:
            empty += 1
    if not bodies:
        raise FileError(_EMPTY.format(path))
    remarks = (f"left out: {empty} solids without triangles",) if empty else ()
    return Contents(bodies=tuple(bodies), length_unit=length_unit, remarks=remarks)


def _joined(corners: Points) -> tuple[Array, Indices]:
    """Vertices from the corners (3 m, 3) of triangles, and the vertex of each."""
    size = np.abs(corners)
    return welded(np.where(size <= NOUGHT * size.max(), corners.dtype.type(0.0), corners))


def _body(name: str, vertices: Array, indices: Indices, rounding: float) -> Body:
    offsets = np.arange(0, len(indices) + 1, 3)
    return Body(name=name, vertices=vertices, indices=indices, offsets=offsets, rounding=rounding)


def _refuse_not_finite(path: str | Path, corners: Points) -> None:
    bad = np.unique(np.flatnonzero(~np.isfinite(corners).all(axis=1)) // 3)
    raise FileError(
        f"{path}: {len(bad)} of {len(corners) // 3} triangles have coordinates that are not finite, the first is"
        f" triangle {bad[0]}: {corners[3 * bad[0] : 3 * bad[0] + 3].tolist()}; write the file again from the program"
        " that made it"
    )


def _refuse_length(path: str, size: int, count: int) -> None:
    if size < START:
        raise FileError(
            f"{path}: {size} bytes that are no STL file; a binary one has at least {START}, a text one begins with"
            ' "solid"'
        )
    if count * RECORD.itemsize > _ABSURD * size:
        raise FileError(f'{path}: this is no STL file: neither text that begins with "solid" nor a binary one')
    whole, rest = divmod(size - START, RECORD.itemsize)
    needed = START + count * RECORD.itemsize
    cause = "the file is cut off, or it is no STL file" if size < needed else "the count is wrong, or it is no STL file"
    raise FileError(
        f"{path}: not a whole STL file: its header announces {count} triangles, which take {needed} bytes, but it has"
        f" {size}, room for {whole} triangles{f' and {rest} bytes' if rest else ''}; {cause}; write or copy it again"
    )


def write(path: str | Path, vertices: Array, triangles: Indices, *, length_unit: str = "mm") -> None:
    """Writes triangles (m, 3) over vertices (n, 3) as a binary STL file, whole or not at all.

    Corners are rounded to single precision, equal vertices equally, so a closed boundary stays closed.
    Normals are those of the rounded corners, 0 where these have no area.
    Raises FileError if single precision cannot hold the body or the name is not a file's;
    MachineError if the disk does not take it.
    """
    single = _single_precision(str(path), vertices, triangles)
    with disk.written_whole(path) as stream:
        stream.write(
            f"Gearwright binary STL, lengths in {length_unit}".encode("ascii", "replace")[:HEADER].ljust(HEADER)
        )
        stream.write(len(triangles).to_bytes(4, "little"))
        for start in range(0, len(triangles), _BLOCK):
            stream.write(_records(single, triangles[start : start + _BLOCK]).data)


def _single_precision(path: str, vertices: Array, triangles: Indices) -> Array:
    """The vertices rounded to single precision, still as float64."""
    if len(triangles) > _MOST:
        raise FileError(
            f"{path}: {len(triangles)} triangles; an STL file holds at most {_MOST}; use a coarser tolerance"
        )
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

"""STL files in, binary and text: lists of triangles with no shared vertices, no length unit and, in the binary form,
single precision.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ...arrays import Array, Indices
from ...errors import FileError
from ...moments.soup import NOUGHT
from ..contents import Body, Contents, Data
from ..noted_unit import noted_unit
from ..rounding import single_precision
from ..welding import Points, welded
from .layout import HEADER, RECORD, START
from .text import looks_like_text, parse_text

_ABSURD = 1000  # times more than the file has: what stands for a count is none
_SURPLUS = 0.5
"""Bytes after the triangles, relative to theirs, that programs may have added; with more the count is wrong."""
_EMPTY = "{}: an STL file without triangles; nothing was exported, or only empty bodies"


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
    length_unit = noted_unit(data[:HEADER])
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

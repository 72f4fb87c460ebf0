"""The binary form of OFF files: big-endian, integers of 4 bytes, coordinates in single precision.

vertices faces edges; every vertex x y z [normal, 3] [colour, 4] [texture, 2];
every face: its number of corners, their vertices from 0, how many numbers its colour has, and these.
"""

from __future__ import annotations

import numpy as np

from ...errors import FileError
from ...moments.faces import Corners
from ..binary.records import Field, record_places
from ..binary.values import list_corners
from ..contents import Body
from ..parts import used_alone
from ..rounding import single_precision
from ..text.places import AGAIN

_NUMBER = np.dtype(">i4")
_FACE = (Field(size=4, list_of=4, signed=True), Field(size=4, list_of=4, signed=True))
_ADDED = {"N": 3, "C": 4, "ST": 2}


def parse_binary(data: bytes, start: int, parts: str, path: str) -> Body:
    """The body after the header line, which ends at `start`.

    parts   which of "ST", "C" and "N" stand before OFF: what every vertex has besides coordinates
    Raises FileError with the place if the file is not whole or a number is not of a vertex.
    """
    if len(data) < start + 12:
        raise FileError(f"{path}: a binary OFF file that ends before its counts; it is cut off; {AGAIN}")
    vertices, faces = (int(n) for n in np.frombuffer(data, _NUMBER, 2, start))
    if vertices < 1 or faces < 1:
        raise FileError(
            f"{path}: a binary OFF file of {vertices} vertices and {faces} faces; nothing was exported, or the counts"
            f" are wrong; {AGAIN}"
        )
    width = 3 + sum(count for part, count in _ADDED.items() if part in parts)
    place, least = start + 12, vertices * width * 4 + faces * 8
    if least > len(data) - place:
        raise FileError(
            f"{path}: not a whole OFF file: it announces {vertices} vertices and {faces} faces, which take at least"
            f" {least} bytes, and has {len(data) - place}; it is cut off, or the counts are wrong; {AGAIN}"
        )
    numbers = np.frombuffer(data, ">f4", vertices * width, place).reshape(-1, width)
    with np.errstate(invalid="ignore"):  # signalling NaN
        points = numbers[:, :3].astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise FileError(f"{path}: coordinates of vertex {bad[0]} are not finite: {points[bad[0]].tolist()}; {AGAIN}")
    corners = _faces(path, data, place + vertices * width * 4, faces, vertices)
    points, corners = used_alone(points, corners)
    rounding = single_precision(float(np.abs(points).max()))
    return Body(name="", vertices=points, indices=corners.indices, offsets=corners.offsets, rounding=rounding)


def _faces(path: str, data: bytes, place: int, count: int, vertices: int) -> Corners:
    places, end = record_places(data, place, count, _FACE, False, path, "OFF", "face")
    if end != len(data):
        raise FileError(
            f"{path}: not a whole OFF file: {len(data) - end} bytes follow the {count} faces that it announces;"
            f" the counts are wrong; {AGAIN}"
        )
    return list_corners(path, data, places[:, 0], _FACE[0], False, vertices, "OFF")

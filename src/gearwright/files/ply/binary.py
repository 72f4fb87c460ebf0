"""The data of binary PLY files."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...errors import FileError
from ...moments.faces import Corners
from ..binary.records import Field, record_places
from ..binary.values import coordinates_at, list_corners
from ..text.places import AGAIN
from .header import LISTS, Element, Header, Property


def read_binary(data: bytes, header: Header, path: str) -> tuple[Array, Corners]:
    """Vertices (n, 3) and faces. Raises FileError with the place where the data are not whole."""
    place, little = header.end, header.form == "binary_little_endian"
    points, corners = np.empty((0, 3)), Corners(np.empty(0, np.int64), np.zeros(1, np.int64))
    vertices = header.element("vertex")
    for element in header.elements:
        fields = [_field(one) for one in element.properties]
        places, place = record_places(data, place, element.count, fields, little, path, "PLY", element.name)
        if element.name == "vertex":
            points = _points(path, data, element, places, little)
        elif element.name == "face":
            k = next(k for k, one in enumerate(element.properties) if one.name in LISTS)
            count = vertices.count if vertices else 0
            corners = list_corners(path, data, places[:, k], fields[k], little, count, "PLY")
    if place != len(data):
        raise FileError(
            f"{path}: not a whole PLY file: {len(data) - place} bytes follow all that its header announces;"
            f" the counts are wrong; {AGAIN}"
        )
    return points, corners


def _field(one: Property) -> Field:
    if one.count_type is None:
        return Field(size=int(one.type[1]))
    return Field(
        size=int(one.count_type[1]),
        signed=one.count_type[0] == "i",
        list_of=int(one.type[1]),
        items_signed=one.type[0] == "i",
    )


def _points(path: str, data: bytes, vertices: Element, places: Indices, little: bool) -> Array:
    points = np.empty((vertices.count, 3))
    for axis, name in enumerate("xyz"):
        k = next(k for k, one in enumerate(vertices.properties) if one.name == name)
        form = np.dtype(vertices.properties[k].type).newbyteorder("<" if little else ">")
        points[:, axis] = coordinates_at(data, places[:, k], form)
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise FileError(
            f"{path}: coordinates of vertex {bad[0]} (byte {places[bad[0], 0]}) are not finite:"
            f" {points[bad[0]].tolist()}; {AGAIN}"
        )
    return points

"""What stands at places of binary files: numbers, and faces as lists of vertex numbers."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...compiled import compiled
from ...errors import FileError
from ...moments.faces import Corners
from ..text.decimals import Characters
from ..text.places import AGAIN
from .records import Field, whole


def list_corners(
    path: str, data: bytes, places: Indices, field: Field, little: bool, vertices: int, kind: str
) -> Corners:
    """Faces from the places of their lists of vertex numbers, whole in the data.

    Raises FileError with face and byte where a face has fewer than 3 corners or a number is not of a vertex.
    """
    sizes = whole_at(data, places, field.size, field.signed, little)
    short = np.flatnonzero(sizes < 3)
    if len(short):
        raise FileError(
            f"{path}: not a whole {kind} file: face {short[0]} (byte {places[short[0]]}) has {sizes[short[0]]} corners;"
            f" at least 3 are needed; {AGAIN}"
        )
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    items = _item_places(places + field.size, sizes, offsets, field.list_of)
    indices = whole_at(data, items, field.list_of, field.items_signed, little)
    bad = np.flatnonzero((indices < 0) | (indices >= vertices))
    if len(bad):
        face = int(np.searchsorted(offsets, bad[0], side="right")) - 1
        raise FileError(
            f"{path}: not a whole {kind} file: face {face} (byte {items[bad[0]]}) has the vertex {indices[bad[0]]};"
            f" there are vertices 0 to {vertices - 1}; {AGAIN}"
        )
    return Corners(indices, offsets)


def coordinates_at(data: bytes, places: Indices, form: np.dtype[np.generic]) -> Array:
    """Numbers of a form that begin at places."""
    octets = np.frombuffer(data, np.uint8)[places[..., None] + np.arange(form.itemsize)]
    with np.errstate(invalid="ignore"):  # signalling NaN
        return np.ascontiguousarray(octets).view(form)[..., 0].astype(np.float64)


def whole_at(data: bytes, places: Indices, size: int, signed: bool, little: bool) -> Indices:
    """Integers of so many bytes that begin at places."""
    return _whole_at(np.frombuffer(data, np.uint8), places, size, signed, little)


def _item_places(firsts: Indices, sizes: Indices, offsets: Indices, width: int) -> Indices:
    """Where the numbers of lists begin, list after list."""
    within = np.arange(offsets[-1]) - np.repeat(offsets[:-1], sizes)
    return np.repeat(firsts, sizes) + width * within


@compiled
def _whole_at(data: Characters, places: Indices, size: int, signed: bool, little: bool) -> Indices:
    result = np.empty(len(places), np.int64)
    for k in range(len(places)):
        result[k] = whole(data, places[k], size, signed, little)
    return result

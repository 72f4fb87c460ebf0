"""Records of binary files that hold lists, so that where each begins follows from those before it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...arrays import Indices
from ...compiled import compiled
from ...errors import FileError
from ..text.decimals import Characters
from ..text.places import AGAIN


@dataclass(frozen=True, kw_only=True)
class Field:
    """A number, or a list: a count and as many numbers.

    size           bytes of the number, or of a list's count
    signed         whether that can be negative
    list_of        bytes of every number in a list; 0 where it is none
    items_signed   whether these can be negative
    """

    size: int
    signed: bool = False
    list_of: int = 0
    items_signed: bool = True


def record_places(
    data: bytes, start: int, count: int, fields: Sequence[Field], little: bool, path: str, kind: str, what: str
) -> tuple[Indices, int]:
    """Where every field (count, fields) of so many records begins, and where the last record ends.

    Raises FileError if the data end before, or a list has a negative count.
    """
    width = sum(field.size for field in fields)
    if count * width > len(data) - start:
        raise FileError(
            f"{path}: not a whole {kind} file: {count} records of {what} are announced, which take at least"
            f" {count * width} bytes, and {len(data) - start} are left; it is cut off, or the count is wrong; {AGAIN}"
        )
    sizes = np.array([field.size for field in fields])
    if not any(field.list_of for field in fields):
        firsts = start + width * np.arange(count)
        return firsts[:, None] + np.concatenate([[0], np.cumsum(sizes)[:-1]]), start + count * width
    lists = np.array([field.list_of for field in fields])
    signed = np.array([field.signed for field in fields])
    places, end, record = _walk(np.frombuffer(data, np.uint8), start, count, sizes, lists, signed, little)
    if end < 0:
        raise FileError(
            f"{path}: not a whole {kind} file: {what} {record} (byte {places[record, -end - 1]}) has a list of"
            f" a negative count or one that goes beyond the end of the file; it is cut off, or the counts are wrong;"
            f" {AGAIN}"
        )
    return places, end


@compiled
def whole(data: Characters, place: int, size: int, signed: bool, little: bool) -> int:
    """The integer of so many bytes, at most 4, at a place."""
    value = 0
    for k in range(size):
        value = value << 8 | data[place + (size - 1 - k if little else k)]
    if signed and value >= 1 << (8 * size - 1):
        value -= 1 << (8 * size)
    return value


@compiled
def _walk(
    data: Characters, place: int, count: int, sizes: Indices, lists: Indices, signed: Indices, little: bool
) -> tuple[Indices, int, int]:
    """Places of fields (count, fields) and the end; or minus the field, from 1, and the record that fails."""
    places = np.empty((count, len(sizes)), np.int64)
    for record in range(count):
        for k in range(len(sizes)):
            places[record, k] = place
            if len(data) - place < sizes[k]:
                return places, -k - 1, record
            if lists[k]:
                length = whole(data, place, sizes[k], signed[k], little)
                if length < 0 or length > (len(data) - place - sizes[k]) // lists[k]:
                    return places, -k - 1, record
                place += length * lists[k]
            place += sizes[k]
    return places, place, 0

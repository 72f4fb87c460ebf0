"""Numbers and lists in binary files, against `struct`, and which of them a refusal names."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from gearwright.errors import FileError
from gearwright.files.binary.records import Field, record_places
from gearwright.files.binary.values import list_corners, whole_at

FORMS = {1: "b", 2: "h", 4: "i"}


@pytest.mark.parametrize("size", FORMS)
@pytest.mark.parametrize("signed", [True, False])
@pytest.mark.parametrize("little", [True, False])
def test_integers_at_the_ends_of_their_ranges(size, signed, little):
    half = 2 ** (8 * size - 1)
    values = [-half, 1 - half, -2, -1, 0, 1, half - 2, half - 1] if signed else [0, 1, half - 1, half, 2 * half - 1]
    form = FORMS[size] if signed else FORMS[size].upper()
    data = b"\xa5" + struct.pack(f"{'<' if little else '>'}{len(values)}{form}", *values)
    assert whole_at(data, 1 + size * np.arange(len(values)), size, signed, little).tolist() == values


FIELDS = (Field(size=2), Field(size=1, list_of=4), Field(size=2, list_of=1, signed=True))


def record(first, second, shift=0):
    return struct.pack(f"<HB{len(first)}ih{len(second)}b", 7, len(first), *first, len(second) + shift, *second)


def test_places_of_fields_follow_from_the_lists_before_them():
    data = b"xyz" + record([1, 2], [5]) + record([], [6, 7, 8]) + record([9], [])
    places, end = record_places(data, 3, 3, FIELDS, True, "part", "PLY", "row")
    assert places.tolist() == [[3, 5, 14], [17, 19, 20], [25, 27, 32]]
    assert end == len(data) == 34


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (record([1], [2]) + record([], [3], shift=1), "row 1 (byte 13) has a list"),  # the second list of it
        (record([1], [2]) + record([], [3], shift=-2), "row 1 (byte 13) has a list of a negative count"),
        (record([1, 2], [3])[:6] + b"\0\0\0\0", "row 0 (byte 2) has a list"),
        (record([1], [2]) + record([1], [])[:-1], "row 1 (byte 17)"),
    ],
)
def test_the_list_that_fails_is_named_by_its_place(data, said):
    with pytest.raises(FileError) as caught:
        record_places(data, 0, 2, FIELDS, True, "part", "PLY", "row")
    assert said in str(caught.value)


def test_the_first_of_several_wrong_faces_is_named():
    lists = [(0, 1, 2), (0, 1, 3), (0, 4, 2), (0, 1)]
    data = b"".join(struct.pack(f">B{len(one)}h", len(one), *one) for one in lists)
    field = Field(size=1, list_of=2)

    def said(places):
        with pytest.raises(FileError) as caught:
            list_corners("part", data, np.array(places), field, False, 3, "PLY")
        return str(caught.value)

    assert "face 1 (byte 12) has the vertex 3; there are vertices 0 to 2" in said([0, 7, 14])
    assert "face 3 (byte 21) has 2 corners" in said([0, 7, 14, 21])

"""OFF files: headers and every refusal; round trips stand in test_round_trips."""

from __future__ import annotations

import struct
import time

import pytest

from gearwright.errors import FileError
from gearwright.files.off import reader as off

TEXT = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


def binary(points=((0, 0, 0), (1, 0, 0), (0, 1, 0)), faces=((0, 1, 2),), counts=None, more=b""):
    data = b"OFF BINARY\n" + struct.pack(">3i", *(counts or (len(points), len(faces), 0)))
    data += b"".join(struct.pack(">3f", *p) for p in points)
    return data + b"".join(struct.pack(f">i{len(f)}ii", len(f), *f, 0) for f in faces) + more


@pytest.mark.parametrize(
    "header", ["OFF 4 4 6", "\ufeffOFF\n4 4", "# x\n\n OFF # y\n# z\n4\n4 6", "COFF\n4 4 0", "STCNOFF 4 4"]
)
def test_headers(header):
    (body,) = off.parse(TEXT.replace("OFF\n4 4 6", header).encode(), "part.off").bodies
    assert body.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert body.indices.tolist() == [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]


def test_vertices_without_faces_are_left_out():
    (body,) = off.parse(b"OFF 4 1 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3", "part.off").bodies
    assert body.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert body.indices.tolist() == [0, 1, 2]


@pytest.mark.parametrize("corners", [4, 5, 24, 25, 300])
def test_faces_of_many_corners(corners):
    """Of which nobody knows how many there are before they are read."""
    points = "".join(f"{k} {k * k} 1\n" for k in range(corners))
    around = " ".join(map(str, range(corners)))
    (body,) = off.parse(f"OFF {corners} 2 0\n{points}{corners} {around}\n3 2 1 0\n".encode(), "part.off").bodies
    assert body.indices.tolist() == [*range(corners), 2, 1, 0]
    assert body.offsets.tolist() == [0, corners, corners + 3]


def spoilt(old, new):
    assert old in TEXT
    return TEXT.replace(old, new, 1)


REFUSED = [
    ("", "the file is empty"),
    ("4 4 6\n", 'line 1 has "4" where the word that begins such files'),
    ("OFFICE 1", 'line 1 has "OFFICE" where the word that begins'),
    (spoilt("OFF", "4OFF"), "its vertices have 4 coordinates (4OFF); bodies have 3"),
    (spoilt("OFF", "CnOFF"), "any number of coordinates (CnOFF)"),
    ("OFF", "line 1 has the end of the file where the number of vertices is expected"),
    (spoilt("4 4 6", "-4 4 6"), 'line 2 has "-4" where the number of vertices'),
    (spoilt("4 4 6", "4 4.0 6"), 'line 2 has "4.0" where the number of faces'),
    (spoilt("4 4 6", "0 0 0"), "without vertices"),
    (spoilt("4 4 6", "4 0 0"), "without faces"),
    (spoilt("4 4 6", "4294967296 4 6"), "announces 4294967296 vertices and 4 faces, which take at least 25769803807"),
    (spoilt("4 4 6", "4 4294967296 6"), "it is cut off, or the counts are wrong"),
    (spoilt("4 4 6", "9" * 30 + " 4 6"), "where the number of vertices is expected"),
    (spoilt("4 4 6", "3 4 6"), 'line 6 has a face of fewer than 3 corners'),
    (spoilt("4 4 6", "4 3 6"), 'line 10 has "3" where the end, after 4 vertices and 3 faces, is expected'),
    (spoilt("1 0 0", "1 0"), "line 4 has its end where a number is expected"),
    (spoilt("1 0 0", "1 O 0"), 'line 4 has "O" where a number'),
    (spoilt("1 0 0", "1 nan 0"), 'line 4 has "nan" where a finite number'),
    (spoilt("1 0 0", "1 1e400 0"), 'line 4 has "1e400" where a finite number'),
    (spoilt("3 0 1 3", "2 0 1 3"), "line 8 has a face of fewer than 3 corners"),
    (spoilt("3 0 1 3", "-3 0 1 3"), 'line 8 has "-3" where the number of corners'),
    (spoilt("3 0 1 3", "3 0 1 4"), 'line 8 has "4" where the number of a vertex, 0 to 3, is expected'),
    (spoilt("3 0 1 3", "3 0 1 -1"), 'line 8 has "-1" where the number of a vertex'),
    (spoilt("3 0 1 3", "3 0 1"), "line 8 has its end where the number of a vertex"),
    (spoilt("3 0 1 3", "2147483648 0 1 3"), "line 8 has its end where"),
    (spoilt("3 2 0 3\n", "#" * 9), "line 10 has the end of the file where"),
    (TEXT[:20], "it is cut off"),
    (binary()[:20], "ends before its counts"),
    (binary(counts=(-3, 1, 0)), "-3 vertices and 1 faces"),
    (binary(counts=(3, 0, 0)), "3 vertices and 0 faces"),
    (binary(counts=(3, 2**31 - 1, 0)), "take at least 17179869212 bytes"),
    (binary(counts=(2**31 - 1, 1, 0)), "it is cut off, or the counts are wrong"),
    (binary(counts=(3, 2, 0)), "is cut off"),
    (binary()[:-1], "face 0 (byte 75) has a list of a negative count or one that goes beyond the end"),
    (binary(more=b"\0"), "1 bytes follow the 1 faces"),
    (binary(faces=[(0, 1)]), "face 0 (byte 59) has 2 corners; at least 3"),
    (binary(faces=[(0, 1, 2), (0, 1, 3)]), "face 1 (byte 91) has the vertex 3; there are vertices 0 to 2"),
    (binary(faces=[(0, -1, 2)]), "face 0 (byte 67) has the vertex -1"),
    (binary(points=[(0, 0, 0), (1, float("nan"), 0), (0, 1, 0)]), "vertex 1 are not finite"),
]  # fmt: skip


@pytest.mark.parametrize(("data", "said"), REFUSED)
def test_refusals(data, said):
    start = time.process_time()
    with pytest.raises(FileError) as caught:
        off.parse(data.encode() if isinstance(data, str) else data, "part.off")
    assert str(caught.value).startswith("part.off: ")
    assert said in str(caught.value)
    assert time.process_time() - start < 10  # the first may compile

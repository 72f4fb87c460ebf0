"""PLY files: every refusal; round trips stand in test_round_trips."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from gearwright.errors import FileError
from gearwright.files.ply import reader

HEADER = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
)
TEXT = HEADER + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
LITTLE = HEADER.replace("ascii", "binary_little_endian")


def binary(points=((0, 0, 0), (1, 0, 0), (0, 1, 0)), faces=((0, 1, 2),), header=LITTLE, more=b""):
    data = header.encode() + b"".join(struct.pack("<3f", *p) for p in points)
    return data + b"".join(struct.pack(f"<B{len(f)}i", len(f), *f) for f in faces) + more


def spoilt(old, new, text=TEXT):
    assert old in text
    return text.replace(old, new, 1)


FACES = "element face 1\nproperty list uchar int vertex_indices\n"
AT = len(LITTLE)
REFUSED = [
    ("", "the file is empty"),
    ("plywood\n", 'its first line is not "ply"'),
    ("ply", '"end_header" was expected'),
    (spoilt("end_header", "end header"), '"end_header" was expected'),
    (spoilt("end_header", "comment\n" * 10000 + "end_header"), "within 65536 bytes"),
    (spoilt("format ascii 1.0\n", ""), 'has no line "format ascii 1.0"'),
    (spoilt("ascii 1.0", "ascii 2.0"), 'line 2 of this PLY file has "format ascii 2.0" where a line of the header'),
    (spoilt("ascii", "middle_endian"), "line 2 of this PLY file"),
    (spoilt("element vertex 3", "element vertex -3"), 'line 3 of this PLY file has "element vertex -3"'),
    (spoilt("element vertex 3", "element vertex " + "9" * 99), "line 3 of this PLY file"),
    (spoilt("element face 1", "element vertex 1"), 'line 7 of this PLY file has "element vertex 1"'),
    (spoilt("float y", "float x"), 'line 5 of this PLY file has "property float x"'),
    (spoilt("float y", "quad y"), 'line 5 of this PLY file has "property quad y"'),
    (spoilt("element vertex 3\n", ""), 'line 3 of this PLY file has "property float x"'),
    (spoilt("property list uchar int vertex_indices\n", ""), "the element face of this PLY file has no properties"),
    (spoilt("float y", "float u"), "vertices of this PLY file have no numbers y"),
    (spoilt("float y", "list uchar float y"), "vertices of this PLY file have no numbers y"),
    (spoilt(FACES, ""), "without faces, points alone bound no body"),
    (spoilt("element face 1", "element face 0"), "without faces"),
    (spoilt("element vertex 3", "element vertex 0"), "without vertices"),
    (spoilt(FACES, FACES.replace("face", "tristrips")), "strips of triangles (tristrips), not faces; write it again"),
    (spoilt("vertex_indices", "corners"), 'no list "vertex_indices" of integers, but corners'),
    (spoilt("list uchar int vertex_indices", "int vertex_indices"), 'no list "vertex_indices"'),
    (spoilt("list uchar int", "list uchar float"), 'no list "vertex_indices" of integers'),
    (spoilt("end_header", "property list float int x\nend_header"), "has a count that is no integer"),
    (spoilt("element vertex 3", "element vertex 4294967296"), "4294967296 rows of vertex are announced, which take"),
    (spoilt("element face 1", "element face 4294967296"), "it is cut off, or the count is wrong"),
    (spoilt("1 0 0", "1 0"), "line 11 has its end where a number (vertex: x, y, z) is expected"),
    (spoilt("1 0 0", "1 0 0 0"), 'line 11 has "0" where the end of the line (vertex: x, y, z) is expected'),
    (spoilt("1 0 0", "1 a 0"), 'line 11 has "a" where a number'),
    (spoilt("1 0 0", "1 nan 0"), 'line 11 has "nan" where a finite number'),
    (spoilt("1 0 0", "1 0 -1e500"), 'line 11 has "-1e500" where a finite number'),
    (spoilt("3 0 1 2", "x 0 1 2"), 'line 13 has "x" where the count of a list'),
    (spoilt("3 0 1 2", "-1 0 1 2"), 'line 13 has "-1" where the count of a list'),
    (spoilt("3 0 1 2", "2 0 1"), "line 13 has a face of fewer than 3 corners"),
    (spoilt("3 0 1 2", "3 0 1 3"), 'line 13 has "3" where the number of a vertex, 0 to 2, is expected'),
    (spoilt("3 0 1 2", "3 0 1 -2"), 'line 13 has "-2" where'),
    (spoilt("3 0 1 2", "4 0 1 2"), "line 13 has its end where the number of a vertex"),
    (TEXT + "3 0 1 2\n", 'line 14 has "3" where the end, after all that its header announces, is expected'),
    (spoilt("3 0 1 2\n", "#    "), "line 13 has the end of the file"),
    (binary(points=[(0, 0, np.inf), (1, 0, 0), (0, 1, 0)]), f"vertex 0 (byte {AT}) are not finite"),
    (binary()[:-1], f"face 0 (byte {AT + 36}) has a list of a negative count or one that goes beyond the end"),
    (binary()[: AT + 20], "3 records of vertex are announced, which take at least 36 bytes, and 20 are left"),
    (binary(more=b"xy"), "2 bytes follow all that its header announces"),
    (binary(faces=[(0, 1, 3)]), f"face 0 (byte {AT + 45}) has the vertex 3; there are vertices 0 to 2"),
    (binary(faces=[(0, 1, -3)]), "has the vertex -3"),
    (binary(faces=[(0, 1, -(2**31))]), "has the vertex -2147483648"),
    (binary(faces=[(0, 1)]), f"face 0 (byte {AT + 36}) has 2 corners; at least 3 are needed"),
    (binary(faces=[()], header=LITTLE.replace("uchar", "char")), "has 0 corners"),
    (binary(faces=[], header=LITTLE.replace("uchar", "char"), more=b"\xff" * 13), "negative count"),
    (binary(header=LITTLE.replace("element face 1", "element face 4294967296")), "4294967296 records of face"),
    (binary(header=LITTLE.replace("element vertex 3", "element vertex 99999999999999999")), "records of vertex"),
]  # fmt: skip


@pytest.mark.parametrize(("data", "said"), REFUSED)
def test_refusals(data, said):
    with pytest.raises(FileError) as caught:
        reader.parse(data.encode() if isinstance(data, str) else data, "part.ply")
    assert str(caught.value).startswith("part.ply: ")
    assert said in str(caught.value)


def test_unsigned_vertex_numbers_beyond_signed_ones_are_read():
    points = "".join(f"{k} {k % 7} {k % 3}\n" for k in range(256))
    text = TEXT.split("end_header")[0].replace("uchar int", "uchar uchar").replace("vertex 3", "vertex 256")
    data = text.replace("ascii", "binary_big_endian").encode() + b"end_header\n"
    data += b"".join(struct.pack(">3f", *map(float, line.split())) for line in points.splitlines())
    (body,) = reader.parse(data + bytes([3, 0, 128, 255]), "part.ply").bodies
    assert body.vertices[:, 0].tolist() == [0, 128, 255]

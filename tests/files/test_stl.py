"""STL files: round trips, and everything that can be wrong with one."""

from __future__ import annotations

import os
import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gearwright import disk
from gearwright.errors import FileError, MachineError
from gearwright.files.assembly import Assembly, Part
from gearwright.files.stl import reader, writer
from gearwright.solids.polyhedron import Polyhedron

VERTICES = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
TEXT = "solid a b\n" + "".join(
    "facet normal 0 0 0\n outer loop\n"
    + "".join(f"  vertex {x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in VERTICES[t])
    + " endloop\nendfacet\n"
    for t in TRIANGLES
) + "endsolid a b\n"  # fmt: skip


def binary(triangles=((0.0,) * 9,), count=None, header=b""):
    records = b"".join(struct.pack("<12fH", 0, 0, 0, *t, 0) for t in triangles)
    return header.ljust(80) + struct.pack("<I", len(triangles) if count is None else count) + records


def read(path):
    """Vertices and triangles of a file's one body."""
    (body,) = reader.parse(disk.contents(path), str(path)).bodies
    return body.vertices, body.indices.reshape(-1, 3)


def refused(tmp_path, data, *said):
    path = tmp_path / "part.stl"
    path.write_bytes(data)
    with pytest.raises(FileError) as caught:
        read(path)
    assert str(path) in str(caught.value)
    for words in said:
        assert words in str(caught.value)


def assert_same_body(found, vertices=VERTICES, triangles=TRIANGLES):
    np.testing.assert_array_equal(found[0][found[1]], np.asarray(vertices)[triangles])
    assert len(np.unique(found[0], axis=0)) == len(found[0])


def save(path, vertices, triangles, *, length_unit="mm"):
    part = Part(name="part", shape=Polyhedron(vertices, triangles))
    writer.write(path, Assembly(name="part", parts=(part,), length_unit=length_unit))


def test_written_and_read(tmp_path):
    path = tmp_path / "part.stl"
    save(path, VERTICES, TRIANGLES, length_unit="in")
    assert_same_body(read(path))
    data = path.read_bytes()
    assert len(data) == 84 + 50 * 4
    assert data[:80].rstrip() == b"Gearwright binary STL, lengths in in"
    normal = np.frombuffer(data, "<f4", 3, 84 + 2 * 50)
    np.testing.assert_allclose(normal, np.ones(3) / np.sqrt(3), rtol=1e-6)


@settings(max_examples=50, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(0, 2**32 - 1), st.integers(1, 60), st.integers(1, 40))
def test_any_triangles_survive_in_single_precision(tmp_path, seed, n, m):
    random = np.random.default_rng(seed)
    vertices = random.normal(size=(n, 3)).astype(np.float32).astype(float)
    vertices[random.random((n, 3)) < 0.3] = -0.0
    vertices[0] = [-5, -5, -5]  # so that not all points are one
    vertices[-1] = [5, 5, 5]
    triangles = random.integers(0, n, (m, 3))
    save(tmp_path / "part.stl", vertices, triangles)
    found = read(tmp_path / "part.stl")
    assert_same_body(found, vertices, triangles)
    _, first = np.unique(found[1], return_index=True)
    assert np.all(np.diff(first) > 0)  # numbered as they occur


def test_text(tmp_path):
    shapes = {
        "plain": TEXT,
        "upper case": TEXT.upper(),
        "windows": TEXT.replace("\n", "\r\n"),
        "old mac": TEXT.replace("\n", "\r"),
        "mark": "\ufeff" + TEXT,
        "names of keywords": TEXT.replace("a b", "vertex endfacet 1 2"),
        "no name": TEXT.replace(" a b", ""),
        "indented": "  \n\t" + TEXT.replace("\n", "\n  ") + "\n\n",
    }
    for name, text in shapes.items():
        (tmp_path / name).write_bytes(text.encode())
        assert_same_body(read(tmp_path / name))


def test_every_solid_of_a_text_is_a_body_with_its_name():
    second = TEXT.replace(" 1", " 2.5E+00").replace("a b", "Vertex  solid ÿ")
    first, again = reader.parse((TEXT + second).encode(), "part.stl").bodies
    assert (first.name, again.name) == ("a b", "Vertex solid ÿ")
    assert first.vertices.max() == 1
    assert again.vertices.max() == 2.5
    assert len(first.vertices) == len(again.vertices) == 4
    assert first.offsets.tolist() == again.offsets.tolist() == [0, 3, 6, 9, 12]


def test_empty_solids_are_left_out_with_a_remark():
    contents = reader.parse(b"solid nothing\nendsolid\n" + TEXT.encode(), "part.stl")
    assert [body.name for body in contents.bodies] == ["a b"]
    assert contents.remarks == ("left out: 1 solids without triangles",)


def test_normals_that_are_not_finite_do_not_matter():
    (body,) = reader.parse(TEXT.replace("normal 0 0 0", "normal -nan(ind) NaN inf").encode(), "part.stl").bodies
    assert len(body.vertices) == 4


def test_bytes_after_the_triangles_are_left_out_with_a_remark_if_they_are_few():
    contents = reader.parse(binary([range(9)]) + b"x" * 25, "part.stl")
    assert contents.bodies[0].vertices.tolist() == [[0, 1, 2], [3, 4, 5], [6, 7, 8]]
    assert contents.remarks == ("left out: 25 bytes after the 1 triangles that the file announces",)
    with pytest.raises(FileError, match="the count is wrong"):
        reader.parse(binary([range(9)]) + b"x" * 26, "part.stl")
    assert not reader.parse(binary([range(9)]), "part.stl").remarks


def test_text_keeps_double_precision(tmp_path):
    (tmp_path / "part.stl").write_text(TEXT.replace("vertex 1", "vertex 0.12345678901234567"))
    assert 0.12345678901234567 in read(tmp_path / "part.stl")[0]


def test_binary_that_begins_with_solid(tmp_path):
    (tmp_path / "part.stl").write_bytes(binary([range(9)], header=b"solid part, facet normal"))
    assert read(tmp_path / "part.stl")[1].shape == (1, 3)


def test_rounding_errors_of_nought_do_not_tear_the_boundary(tmp_path):
    triangles = [VERTICES[t].ravel() for t in TRIANGLES]
    triangles[0] = np.where(triangles[0] == 0, -2.7e-16, triangles[0])
    (tmp_path / "part.stl").write_bytes(binary(triangles))
    assert_same_body(read(tmp_path / "part.stl"))


@pytest.mark.parametrize("difference", [1e-7, 1e-12])
def test_what_differs_by_more_stays_apart(tmp_path, difference):
    (tmp_path / "part.stl").write_bytes(binary([(0, 0, 0, difference, 0, 0, 1, 1, 1)]))
    assert len(read(tmp_path / "part.stl")[0]) == 3


def test_refusals(tmp_path):
    refused(tmp_path, b"", "the file is empty")
    refused(tmp_path, binary([]), "without triangles")
    refused(tmp_path, b"solid Empty\nendsolid Empty", "without triangles")
    refused(tmp_path, b"junk", "4 bytes that are no STL file", '"solid"')
    refused(tmp_path, binary()[:-1], "announces 1 triangles, which take 134 bytes, but it has 133", "cut off")
    refused(tmp_path, binary() + b"x" * 60, "has 194, room for 2 triangles and 10 bytes", "the count is wrong")
    refused(tmp_path, binary(count=3), "announces 3 triangles", "room for 1 triangles")
    refused(tmp_path, binary(count=2**32 - 1), "this is no STL file")
    refused(tmp_path, binary(header=b"solid")[:-1], "announces 1 triangles")
    refused(tmp_path, bytes(range(256)) * 50, "this is no STL file")
    refused(tmp_path, binary([(*range(8), np.nan)]), "1 of 1 triangles", "triangle 0", "nan")
    refused(tmp_path, binary([range(9), (*range(8), -np.inf)]), "1 of 2 triangles", "triangle 1", "inf")


def test_refusals_of_text(tmp_path):
    def spoilt(old, new, *said):
        refused(tmp_path, TEXT.replace(old, new, 1).encode(), *said)

    spoilt("endsolid a b\n", "", 'does not end with "endsolid"', "cut off")
    refused(tmp_path, TEXT[: len(TEXT) // 2].encode(), "cut off")
    spoilt("vertex 0", "vertex 0,5", 'line 4 has "0,5" where a number is expected')
    spoilt("vertex 0", "vertx 0", 'line 4 has "vertx" where "vertex" is expected')
    spoilt(" endloop", "", 'line 8 has "endfacet" where "endloop" is expected')
    spoilt(" endloop\nendfacet\n", "", '"facet" where "endloop"')
    spoilt("vertex 0", "vertex nan", "not finite")
    spoilt("vertex 0", "vertex 1e999", "not finite")
    spoilt("vertex 0", "vertex " + "9" * 5000, "where a number is expected")
    spoilt("vertex 0 0 0", "vertex 0 0", 'line 5 has "vertex" where a number is expected')
    refused(tmp_path, b"solid a\nfacet normal 0 0 1\nendsolid a", "not complete")
    two = TEXT.replace("endsolid a b\n", "endsolid a b\nfacet normal 0 0 0\n") + TEXT
    refused(tmp_path, two.encode(), 'line 31 has "facet" where "solid" or the end is expected')


def test_names_that_are_no_files(tmp_path):
    with pytest.raises(FileError, match="there is no such file"):
        read(tmp_path / "nothing.stl")
    with pytest.raises(FileError, match="this is a folder"):
        read(tmp_path)
    with pytest.raises(FileError, match="cannot be a file"):
        read("a\0b.stl")
    with pytest.raises(FileError, match="device"):
        read("/dev/null")
    with pytest.raises(FileError, match="there is no folder"):
        save(tmp_path / "nowhere" / "part.stl", VERTICES, TRIANGLES)
    with pytest.raises(FileError, match="folder or device"):
        save(tmp_path, VERTICES, TRIANGLES)
    with pytest.raises(FileError, match="folder or device"):
        save("/dev/null", VERTICES, TRIANGLES)
    with pytest.raises(FileError, match="the name is too long"):
        save(tmp_path / ("x" * 300 + ".stl"), VERTICES, TRIANGLES)


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "part.stl"
    path.write_bytes(b"old")

    def full(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(MachineError, match="No space left on device"):
        save(path, VERTICES, TRIANGLES)
    assert path.read_bytes() == b"old"
    assert [p.name for p in tmp_path.iterdir()] == ["part.stl"]


def test_an_interrupted_write_leaves_nothing(tmp_path):
    def interrupted():
        with disk.written_whole(tmp_path / "part.stl") as stream:
            stream.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert not list(tmp_path.iterdir())


def test_writing_keeps_permissions_and_follows_links(tmp_path):
    path, link = tmp_path / "part.stl", tmp_path / "link.stl"
    path.write_bytes(b"old")
    path.chmod(0o640)
    link.symlink_to(path)
    save(link, VERTICES, TRIANGLES)
    assert link.is_symlink()
    assert path.stat().st_mode & 0o777 == 0o640
    assert_same_body(read(path))


def test_what_single_precision_cannot_hold_is_refused(tmp_path):
    path = tmp_path / "part.stl"
    with pytest.raises(FileError, match="move it to the origin"):
        save(path, VERTICES * 0.3 + 1e6, TRIANGLES)
    with pytest.raises(FileError, match="single precision"):
        save(path, VERTICES * 1e39, TRIANGLES)
    assert not path.exists()


@settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(st.data())
def test_any_bytes_give_a_mesh_or_a_file_error(tmp_path: Path, data):
    kind = data.draw(st.sampled_from(["bytes", "spoilt text", "spoilt binary", "words"]))
    if kind == "bytes":
        content = data.draw(st.binary(max_size=400))
    elif kind == "words":
        words = [
            "solid",
            "endsolid",
            "facet",
            "normal",
            "outer",
            "loop",
            "vertex",
            "endloop",
            "endfacet",
            "1",
            "-2e3",
            "\n",
        ]
        content = ("solid " + " ".join(data.draw(st.lists(st.sampled_from(words), max_size=60)))).encode()
    else:
        content = bytearray(
            TEXT.encode() if kind == "spoilt text" else binary([range(9), range(1, 10)], header=b"solid")
        )
        for _ in range(data.draw(st.integers(0, 4))):
            place = data.draw(st.integers(0, len(content) - 1))
            content[place : place + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=3))
    path = tmp_path / "part.stl"
    path.write_bytes(content)
    try:
        vertices, triangles = read(path)
    except FileError as error:
        assert str(path) in str(error)  # noqa: PT017
    else:
        assert np.isfinite(vertices).all()
        assert triangles.min() >= 0
        assert triangles.max() < len(vertices)

"""What bytes are, told by themselves."""

from __future__ import annotations

import io
import struct
import time

import pytest

from gearwright.errors import FileError, MachineError
from gearwright.files import formats, reading
from gearwright.files.recognition import recognise

OBJ = b"# by hand\r\nmtllib x\r\n\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"
STL = b"solid".ljust(80) + struct.pack("<I12fH", 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)


@pytest.mark.parametrize(
    ("data", "name"),
    [
        (OBJ, "OBJ"),
        (b"f -1 -2 -3\r", "OBJ"),
        (STL, "STL"),
        (b"\xef\xbb\xbf\n SOLID a\n", "STL"),
        (b"# x\n# y\n\nSTCNOFF\n", "OFF"),
        (b"# x\rOFF\r1 1", "OFF"),
        (b"OFF BINARY\n\0\0\0\1", "OFF"),
        (b"ply\r\nformat ascii 1.0", "PLY"),
    ],
)
def test_recognised(data, name):
    assert recognise(data, "input").name == name
    assert recognise(memoryview(data), "input").name == name


@pytest.mark.parametrize(
    ("data", "name"),
    [
        (b"PK\x03\x04rest", "3MF"),
        (b"glTF\2\0\0\0", "glTF"),
        (b' {"scenes": [], "asset" : {"version": "2.0"}}', "glTF"),
        (b"/* a comment */\nISO-10303-21;\nHEADER;", "STEP"),
    ],
)
def test_a_format_that_is_not_listed_is_named(data, name, monkeypatch):
    monkeypatch.setattr("gearwright.files.recognition.FILE_FORMATS", formats.FILE_FORMATS[:1])
    with pytest.raises(FileError, match=rf"input: this looks like {name}, which is not read here; .* STL"):
        recognise(data, "input")
    listed = (formats.FileFormat(name=name, summary="", suffixes=(), parser="a:b"),)
    monkeypatch.setattr("gearwright.files.recognition.FILE_FORMATS", listed)
    assert recognise(data, "input").name == name


@pytest.mark.parametrize(
    "data", [b"", b" \n", b"junk", b"OFFICE", b"plywood", b"{}", b"vt 0 0", b"v\0v 1 2 3\nv 1", b"x v 1"]
)
def test_what_is_nothing(data):
    with pytest.raises(FileError, match=f"input: .*{len(data)} bytes"):
        recognise(data, "input")


def test_many_comments_take_no_longer_than_their_length():
    start = time.process_time()
    for data in (b"/**/" * 100_000 + b"/*", b"# \n" * 100_000):
        with pytest.raises(FileError):
            recognise(data, "input")
    assert time.process_time() - start < 2


class Dripping(io.RawIOBase):
    """A pipe that gives a few bytes at a time."""

    def __init__(self, data):
        self.rest = data

    def read(self, _=-1):
        given, self.rest = self.rest[:7], self.rest[7:]
        return given


def test_a_stream_is_read_to_its_end():
    (body,) = reading.read_stream(Dripping(OBJ)).bodies
    assert body.indices.tolist() == [0, 1, 2]
    with pytest.raises(FileError, match='standard input: not a whole OBJ file: line 8 has "junk"'):
        reading.read_stream(Dripping(OBJ + b"junk"))
    with pytest.raises(FileError, match="pipe: there is nothing to read"):
        reading.read_stream(io.BytesIO(), "pipe")


def test_a_stream_without_end_is_refused(monkeypatch):
    class Endless(io.RawIOBase):
        def read(self, _=-1):
            return b"v 0 0 0\n"

    monkeypatch.setattr(reading, "MOST_BYTES", 1000)
    with pytest.raises(FileError, match=r"standard input: more than 1000 bytes, .* save them as a file"):
        reading.read_stream(Endless())


def test_a_stream_that_breaks_is_the_machines_fault():
    class Broken(io.RawIOBase):
        def read(self, _=-1):
            raise OSError(5, "Input/output error")

    with pytest.raises(MachineError, match=r"standard input: cannot be read \(Input/output error\)"):
        reading.read_stream(Broken())


def test_files_are_read_by_their_suffix(tmp_path):
    path = tmp_path / "part.OBJ"
    path.write_bytes(OBJ)
    assert len(reading.read(path).bodies) == 1
    (tmp_path / "part").write_bytes(OBJ)
    for name in ("part", "part.xyz"):
        with pytest.raises(FileError, match=r"cannot be read; known suffixes: \.stl, "):
            reading.read(tmp_path / name)

"""FILE_FORMATS: the kinds of files of bodies, and what reads and writes each. Listing them loads none."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

from .. import disk
from ..errors import FileError, MachineError
from ..sources import Source, load

if TYPE_CHECKING:  # so that listing the formats loads no numpy
    from .contents import Contents


@dataclass(frozen=True, kw_only=True)
class FileFormat:
    """A kind of file.

    suffixes   of its names, lower case, with the dot
    parser     a function of bytes and a name that gives Contents; None where it is not read
    writer     None where it is not written
    """

    name: str
    summary: str
    suffixes: tuple[str, ...]
    parser: Source | None = None
    writer: Source | None = None


MOST_BYTES = 4 * 2**30
"""The most that is read from a stream, whose length nobody knows before its end."""

_BLOCK = 1 << 22

FILE_FORMATS = (
    FileFormat(
        name="STL",
        summary="triangles, binary or text",
        suffixes=(".stl",),
        parser="gearwright.files.stl.reader:parse",
        writer="gearwright.files.stl.writer:write",
    ),
    FileFormat(
        name="3MF",
        summary="placed meshes with a unit, in a zip package",
        suffixes=(".3mf",),
        parser="gearwright.files.three_mf.bodies:parse",
    ),
    FileFormat(
        name="glTF",
        summary="a scene of meshes, as text or binary; lengths in metres",
        suffixes=(".gltf", ".glb"),
        parser="gearwright.files.gltf.scene:parse",
    ),
    FileFormat(
        name="STEP",
        summary="smooth solids, read as polyhedra to a tolerance (extra step)",
        suffixes=(".step", ".stp"),
        parser="gearwright.files.step.reading:parse",
    ),
    FileFormat(
        name="OBJ",
        summary="polygons in objects or groups",
        suffixes=(".obj",),
        parser="gearwright.files.obj.reader:parse",
    ),
    FileFormat(
        name="OFF",
        summary="polygons, text or binary",
        suffixes=(".off",),
        parser="gearwright.files.off.reader:parse",
    ),
    FileFormat(
        name="PLY",
        summary="polygons, text or binary",
        suffixes=(".ply",),
        parser="gearwright.files.ply.reader:parse",
    ),
)


def read(path: str | Path) -> Contents:
    """What a file holds, in the format of its suffix.

    Raises FileError where the suffix is of no known format or the file is not whole; MachineError if the disk does
    not give it.
    """
    parse = load(format_of(path, "read").parser or "")
    return parse(disk.contents(path), str(path))


def read_stream(stream: BinaryIO, name: str = "standard input") -> Contents:
    """What a stream of bytes holds, read to its end, in the format that its contents show.

    Raises FileError where they show none, are not whole or are more than MOST_BYTES; MachineError if the stream
    cannot be read.
    """
    from .recognition import recognise

    data = _all_bytes(stream, name)
    return load(recognise(data, name).parser or "")(data, name)


def _all_bytes(stream: BinaryIO, name: str) -> bytes:
    blocks, size = [], 0
    try:
        while block := stream.read(_BLOCK):
            blocks.append(block)
            size += len(block)
            if size > MOST_BYTES:
                raise FileError(
                    f"{name}: more than {MOST_BYTES} bytes, the most that is read from a stream; save them as a"
                    " file and name that"
                )
    except OSError as error:
        raise MachineError(f"{name}: cannot be read ({error.strerror or error})") from error
    return b"".join(blocks)


def format_of(path: str | Path, done: str) -> FileFormat:
    """The format of a name's suffix that can be "read" or "written". Raises FileError where there is none."""
    known = [one for one in FILE_FORMATS if (one.parser if done == "read" else one.writer)]
    suffix = Path(path).suffix.lower()
    for one in known:
        if suffix in one.suffixes:
            return one
    raise FileError(
        f"{path}: a file whose name ends in {suffix or 'no suffix'} cannot be {done}; known suffixes:"
        f" {', '.join(suffix for one in known for suffix in one.suffixes)}"
    )

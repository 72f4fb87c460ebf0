"""FILE_FORMATS: the kinds of files of bodies, and what reads and writes each. Listing them loads none."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

from .. import disk
from ..errors import FileError
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


FILE_FORMATS = (
    FileFormat(
        name="STL",
        summary="triangles, binary or text",
        suffixes=(".stl",),
        parser="gearwright.files.stl:parse",
        writer="gearwright.files.stl:write",
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
)


def read(path: str | Path) -> Contents:
    """What a file holds, in the format of its suffix.

    Raises FileError where the suffix is of no known format or the file is not whole; MachineError if the disk does
    not give it.
    """
    parse = load(format_of(path, "read").parser or "")
    return parse(disk.contents(path), str(path))


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


def read_stream(stream: BinaryIO) -> Contents:
    """What a stream of bytes holds, in the first format that can be read from it.

    Raises FileError where it is of no known format, with what the first one found wrong.
    """
    data = stream.read()
    refusals = []
    for one in FILE_FORMATS:
        parse = load(one.parser) if one.parser else None
        try:
            if parse is not None:
                found: Contents = parse(data, "standard input")
                return found
        except FileError as error:
            refusals.append(error)
    raise refusals[0]

"""FILE_FORMATS: the kinds of files of bodies, and what reads and writes each. Listing them loads none."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from ..errors import FileError
from ..sources import Source


@dataclass(frozen=True, kw_only=True)
class FileFormat:
    """A kind of file.

    suffixes   of its names, lower case, with the dot
    parser     a function of bytes and a name that gives Contents; None where it is not read
    writer     a function of a path and an Assembly of what the format holds, or a Mechanism; None where it is not
               written
    holds      polygon faces, or smooth ones; or a mechanism: bodies with masses on joints
    bodies     whether bodies stay apart, by their names, in what is written
    has_unit   whether what is written always states a unit of length
    up         the axis that points up
    """

    name: str
    summary: str
    suffixes: tuple[str, ...]
    parser: Source | None = None
    writer: Source | None = None
    holds: Literal["polygons", "smooth faces", "mechanism"] = "polygons"
    bodies: bool = False
    has_unit: bool = False
    up: Literal["y", "z"] = "z"


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
        writer="gearwright.files.three_mf.writer:write",
        bodies=True,
        has_unit=True,
    ),
    FileFormat(
        name="glTF",
        summary="a scene of meshes, as text or binary; lengths in metres",
        suffixes=(".gltf", ".glb"),
        parser="gearwright.files.gltf.scene:parse",
        writer="gearwright.files.gltf.writer:write",
        bodies=True,
        has_unit=True,
        up="y",
    ),
    FileFormat(
        name="STEP",
        summary="smooth solids, for CAD",
        suffixes=(".step", ".stp"),
        parser="gearwright.files.step.reading:parse",
        writer="gearwright.files.step.writer:write",
        holds="smooth faces",
        bodies=True,
        has_unit=True,
    ),
    FileFormat(
        name="OBJ",
        summary="polygons in objects or groups",
        suffixes=(".obj",),
        parser="gearwright.files.obj.reader:parse",
        writer="gearwright.files.obj.writer:write",
        bodies=True,
    ),
    FileFormat(
        name="OFF",
        summary="polygons, text or binary",
        suffixes=(".off",),
        parser="gearwright.files.off.reader:parse",
        writer="gearwright.files.off.writer:write",
    ),
    FileFormat(
        name="PLY",
        summary="polygons, text or binary",
        suffixes=(".ply",),
        parser="gearwright.files.ply.reader:parse",
        writer="gearwright.files.ply.writer:write",
    ),
    FileFormat(
        name="URDF",
        summary="bodies on joints with masses and meshes, for simulators of robots",
        suffixes=(".urdf",),
        writer="gearwright.files.robots.urdf:write",
        holds="mechanism",
    ),
    FileFormat(
        name="SDFormat",
        summary="bodies on joints with masses and meshes, for Gazebo",
        suffixes=(".sdf",),
        writer="gearwright.files.robots.sdf:write",
        holds="mechanism",
    ),
    FileFormat(
        name="MJCF",
        summary="bodies on joints with masses and meshes, for MuJoCo",
        suffixes=(".mjcf", ".xml"),
        writer="gearwright.files.robots.mjcf:write",
        holds="mechanism",
    ),
)


def written_suffixes(holds: str = "") -> list[str]:
    """Of files that can be written, of all or of those that hold "polygons", "smooth faces" or a "mechanism"."""
    formats = (one for one in FILE_FORMATS if one.writer and holds in ("", one.holds))
    return [suffix for one in formats for suffix in one.suffixes]


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

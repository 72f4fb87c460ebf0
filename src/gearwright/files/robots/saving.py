"""A mechanism's file and the meshes in a folder beside it, written all or none."""

from __future__ import annotations

from pathlib import Path

from ...disk import written_together
from ...errors import FileError
from ..assembly import Assembly, Part
from ..stl import writer
from .mechanism import Link, Mechanism


def folder_of(mechanism: Mechanism) -> str:
    """The folder of the meshes, relative to the file."""
    return f"{mechanism.name}_meshes"


def mesh_file(link: Link) -> str:
    """The name of a link's mesh in that folder."""
    return f"{link.name}.stl"


def uri(mechanism: Mechanism, link: Link) -> str:
    """Where a link's mesh lies, relative to the file."""
    return f"{folder_of(mechanism)}/{mesh_file(link)}"


def save(path: str | Path, mechanism: Mechanism, document: bytes) -> list[Path]:
    """Writes the document and the meshes, in m, and gives their paths, the document's first.

    Raises FileError, also where XML cannot hold the mechanism's name; MachineError.
    """
    if not mechanism.name.isprintable():
        raise FileError(f"{str(path)!r}: the file's name stands in it, and XML cannot hold it; take letters and digits")
    target = Path(path)
    with written_together(target.parent) as staged:
        meshes = staged / folder_of(mechanism)
        meshes.mkdir()
        for link in mechanism.links:
            part = Part(name=link.name, shape=link.shape)
            assembly = Assembly(name=link.name, parts=(part,), length_unit="m")
            writer.write(meshes / mesh_file(link), assembly)
        (staged / target.name).write_bytes(document)
    return [target, *(target.parent / uri(mechanism, link) for link in mechanism.links)]

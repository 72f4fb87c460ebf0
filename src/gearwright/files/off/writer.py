"""OFF files out, as text: polygons as they are, all parts as one body."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ... import disk
from ..assembly import Assembly, Faceted, placed_vertices
from ..noted_unit import unit_note
from ..polygons import listed
from ..text.written import rows


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes all parts where they stand, whole or not at all. Their names and colours are lost.

    Raises FileError if the name is not a file's; MachineError if the disk does not take it.
    """
    with disk.written_whole(path) as stream:
        stream.writelines(_lines(assembly))


def _lines(assembly: Assembly[Faceted]) -> Iterator[bytes]:
    vertices = sum(len(part.shape.vertices) for part in assembly.parts)
    faces = sum(len(part.shape.offsets) - 1 for part in assembly.parts)
    yield f"OFF\n# {unit_note('OFF', assembly.length_unit)}\n{vertices} {faces} 0\n".encode("ascii")
    for part in assembly.parts:
        yield from rows("%r %r %r\n", placed_vertices(part))
    first = 0
    for part in assembly.parts:
        yield from listed("{}", part.shape, first=first)
        first += len(part.shape.vertices)

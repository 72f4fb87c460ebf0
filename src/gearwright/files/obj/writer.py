"""OBJ files out: one object a part, polygons as they are, no materials, which would take a second file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ... import disk
from ..assembly import Assembly, Faceted, placed_vertices
from ..noted_unit import unit_note
from ..polygons import listed
from ..text.written import distinct_lines, rows


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes all parts where they stand, each an object (o) by its name, whole or not at all.

    Raises FileError if the name is not a file's; MachineError if the disk does not take it.
    """
    with disk.written_whole(path) as stream:
        stream.writelines(_lines(assembly))


def _lines(assembly: Assembly[Faceted]) -> Iterator[bytes]:
    yield f"# {unit_note('OBJ', assembly.length_unit)}\n".encode("ascii")
    first = 1
    for part, name in zip(assembly.parts, distinct_lines(part.name for part in assembly.parts), strict=True):
        yield f"o {name}\n".encode()
        yield from rows("v %r %r %r\n", placed_vertices(part))
        yield from listed("f", part.shape, first=first)
        first += len(part.shape.vertices)

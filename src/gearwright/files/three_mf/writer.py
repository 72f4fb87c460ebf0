"""3MF files out: an object a part in its own frame, placed by the build, with names, unit and colours.

Source: 3MF Core Specification 1.3; a package of three parts.
"""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from ... import disk
from ...arrays import Array, Indices
from ...errors import FileError
from ..assembly import Assembly, Faceted, Part
from ..colour_values import bytes_of
from ..text.written import one_line, rows
from .bodies import DEFAULT_START, MODEL_TYPE, RELATIONSHIPS
from .extensions import CORE
from .model_part import UNITS

_MOST = 2**31 - 1
_LEVEL = 1
"""Of deflate: 6 takes four times as long for files smaller by a tenth."""

_OWN = 'xmlns="http://schemas.openxmlformats.org/package/2006/'
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
_TYPES = (
    f'{_HEAD}<Types {_OWN}content-types"><Default Extension="rels"'
    ' ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model"'
    ' ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>\n'
).encode()
_START = (
    f'{_HEAD}<Relationships {_OWN}relationships"><Relationship Target="/{DEFAULT_START}" Id="rel0"'
    f' Type="{MODEL_TYPE}"/></Relationships>\n'
).encode()
_COLOURS = 1
"""Number of the resource that lists the colours; objects have those that follow."""


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes the triangles of every part, in double precision with the fewest digits, whole or not at all.

    Triangles with two corners at one vertex, which 3MF does not allow and which bound nothing, are left out.
    Raises FileError if the unit of length is not known, there are too many vertices or the name is not a file's;
    GeometryError if a face cannot be cut into triangles; MachineError if the disk does not take it.
    """
    unit = next((name for name, key in UNITS.items() if key == assembly.length_unit), None)
    if unit is None:
        raise FileError(f"{path}: a 3MF file states its unit of length, and none is given; give one of {_units()}")
    meshes = [(part.shape.vertices, _distinct(part.shape.simple_triangles())) for part in assembly.parts]
    if any(len(vertices) > _MOST for vertices, _ in meshes):
        raise FileError(f"{path}: a 3MF file numbers at most {_MOST} vertices of an object; use a coarser tolerance")
    large = sum(100 * len(vertices) + 60 * len(triangles) for vertices, triangles in meshes) > 1 << 31
    with (
        disk.written_whole(path) as stream,
        zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, compresslevel=_LEVEL) as package,
    ):
        contents = {"[Content_Types].xml": [_TYPES], RELATIONSHIPS: [_START]}
        for name, pieces in {**contents, DEFAULT_START: _model(assembly, unit, meshes)}.items():
            with package.open(name, "w", force_zip64=large) as stored:  # without the time, so that files are repeatable
                stored.writelines(pieces)


def _units() -> str:
    return ", ".join(UNITS.values())


def _distinct(triangles: Indices) -> Indices:
    return triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]


def _model(assembly: Assembly[Faceted], unit: str, meshes: list[tuple[Array, Indices]]) -> Iterator[bytes]:
    coloured = [part for part in assembly.parts if part.colour]
    yield (
        f'{_HEAD}<model unit="{unit}" xml:lang="en-US" xmlns="{CORE}">\n'
        f'<metadata name="Title">{_text(assembly.name)}</metadata>\n'
        '<metadata name="Application">Gearwright</metadata>\n'
        f"<resources>\n{_base_materials(coloured)}"
    ).encode()
    for number, (part, mesh) in enumerate(zip(assembly.parts, meshes, strict=True), start=_COLOURS + 1):
        colour = f' pid="{_COLOURS}" pindex="{coloured.index(part)}"' if part.colour else ""
        yield f'<object id="{number}" type="model" name={_quoted(part.name)}{colour}>\n<mesh>\n<vertices>\n'.encode()
        yield from rows('<vertex x="%r" y="%r" z="%r"/>\n', mesh[0])
        yield b"</vertices>\n<triangles>\n"
        yield from rows('<triangle v1="%d" v2="%d" v3="%d"/>\n', mesh[1])
        yield b"</triangles>\n</mesh>\n</object>\n"
    yield b"</resources>\n<build>\n"
    for number, part in enumerate(assembly.parts, start=_COLOURS + 1):
        yield f'<item objectid="{number}"{_transform(part.placement)}/>\n'.encode()
    yield b"</build>\n</model>\n"


def _base_materials(coloured: list[Part[Faceted]]) -> str:
    """The colours of parts, each as what its part is made of; nothing where none has one."""
    bases = (
        f'<base name={_quoted(part.name)} displaycolor="#{bytes(bytes_of(part.colour)).hex().upper()}"/>'
        for part in coloured
        if part.colour
    )
    return f'<basematerials id="{_COLOURS}">{"".join(bases)}</basematerials>\n' if coloured else ""


def _transform(placement: Array) -> str:
    """By which row vectors are multiplied, (x y z 1) M: its rows are the columns of the placement."""
    if np.array_equal(placement, np.eye(4)):
        return ""
    return f' transform="{" ".join(map(repr, placement[:3].T.reshape(-1).tolist()))}"'


def _quoted(name: str) -> str:
    return quoteattr(one_line(name))


def _text(name: str) -> str:
    return escape(one_line(name))

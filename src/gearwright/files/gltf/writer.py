"""glTF 2 files out: a node a part, placed under a root that turns z up into the y up of glTF; lengths in metres.

Source: glTF 2.0 Specification, sections 3.4 (coordinates and units), 3.6 (accessors), 3.7 (meshes), 4.4 (.glb).
"""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ... import disk
from ...arrays import Array, Indices
from ...colours import Colour
from ...errors import FileError
from ...parameters import LENGTH_UNITS
from ..assembly import Assembly, Faceted, Part
from ..colour_values import linear
from ..rounding import in_single_precision
from ..text.written import one_line
from .container import BINARY, CHUNK, HEADER, JSON, MAGIC

_FLOAT, _UNSIGNED = 5126, 5125
_CORNERS, _NUMBERS = 34962, 34963
_MOST = 2**32 - 1
_UPRIGHT = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
"""By columns: x stays, z becomes y, y becomes −z."""


class _Mesh(NamedTuple):
    """Points in metres in single precision, and the points of triangles."""

    points: Array
    triangles: Indices


def write(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes the triangles of every part in single precision as .glb or .gltf, by the suffix, whole or not at all.

    No normals are written, so that every triangle is shaded as flat; a .gltf holds its numbers within, as base64.
    Raises FileError if the unit of length is not known, single precision cannot hold a body, or the name is no file's;
    GeometryError if a face cannot be cut into triangles; MachineError if the disk does not take it.
    """
    if assembly.length_unit is None:
        units = ", ".join(LENGTH_UNITS)
        raise FileError(f"{path}: glTF has metres, and the unit of these lengths is not known; give one of {units}")
    metres = LENGTH_UNITS[assembly.length_unit] / 1000.0
    meshes = [
        _Mesh(in_single_precision(path, "glTF", part.shape.vertices * metres), part.shape.simple_triangles())
        for part in assembly.parts
    ]
    document = _document(assembly, meshes, metres)
    pieces = [array for mesh in meshes for array in (mesh.points.astype("<f4"), mesh.triangles.astype("<u4"))]
    form = _binary if Path(path).suffix.lower() == ".glb" else _text
    head = form(str(path), document, pieces)
    with disk.written_whole(path) as stream:
        stream.write(head)
        for array in pieces if form is _binary else []:
            stream.write(array.data)


def _text(_: str, document: dict[str, Any], pieces: Sequence[Array | Indices]) -> bytes:
    """The document with its buffer in it."""
    data = b"".join(array.tobytes() for array in pieces)
    uri = f"data:application/octet-stream;base64,{b64encode(data).decode()}"
    return _json({**document, "buffers": [{"byteLength": len(data), "uri": uri}]})


def _binary(path: str, document: dict[str, Any], pieces: Sequence[Array | Indices]) -> bytes:
    """All of a binary file up to its buffer."""
    size = sum(array.nbytes for array in pieces)
    text = _json({**document, "buffers": [{"byteLength": size}]})
    text += b" " * (-len(text) % 4)
    whole = HEADER.size + 2 * CHUNK.size + len(text) + size
    if whole > _MOST:
        raise FileError(f"{path}: {whole} bytes; a binary glTF file has at most {_MOST}; use a coarser tolerance")
    return HEADER.pack(MAGIC, 2, whole) + CHUNK.pack(len(text), JSON) + text + CHUNK.pack(size, BINARY)


def _json(document: dict[str, Any]) -> bytes:
    return json.dumps(document, separators=(",", ":")).encode()


def _document(assembly: Assembly[Faceted], meshes: Sequence[_Mesh], metres: float) -> dict[str, Any]:
    """All but the buffer: for every part a node, a mesh, two views of the buffer and two accessors."""
    colours = list(dict.fromkeys(part.colour for part in assembly.parts if part.colour))
    whole = one_line(assembly.name)
    root = {"name": whole, "matrix": _UPRIGHT, "children": list(range(1, len(meshes) + 1))}
    return {
        "asset": {"version": "2.0", "generator": "Gearwright"},
        "scene": 0,
        "scenes": [{"name": whole, "nodes": [0]}],
        "nodes": [root, *(_node(part, k, metres) for k, part in enumerate(assembly.parts))],
        "meshes": [_mesh(part, k, colours) for k, part in enumerate(assembly.parts)],
        **({"materials": [_material(colour) for colour in colours]} if colours else {}),
        **_tables(meshes),
    }


def _mesh(part: Part[Faceted], number: int, colours: list[Colour]) -> dict[str, Any]:
    primitive: dict[str, Any] = {"attributes": {"POSITION": 2 * number}, "indices": 2 * number + 1}
    if part.colour:
        primitive["material"] = colours.index(part.colour)
    return {"name": one_line(part.name), "primitives": [primitive]}


def _node(part: Part[Faceted], mesh: int, metres: float) -> dict[str, Any]:
    node: dict[str, Any] = {"name": one_line(part.name), "mesh": mesh}
    if not np.array_equal(part.placement, np.eye(4)):
        placement = part.placement.copy()
        placement[:3, 3] *= metres
        node["matrix"] = placement.T.reshape(-1).tolist()
    return node


def _material(colour: Colour) -> dict[str, Any]:
    look = {"baseColorFactor": [*linear(colour), 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.6}
    return {"pbrMetallicRoughness": look}


def _tables(meshes: Sequence[_Mesh]) -> dict[str, Any]:
    """Accessors, and the views of the buffer that they read: the points of each mesh, then its triangles."""
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    start = 0
    for points, triangles in meshes:
        for target, size in ((_CORNERS, 12 * len(points)), (_NUMBERS, 12 * len(triangles))):
            views.append({"buffer": 0, "byteOffset": start, "byteLength": size, "target": target})
            start += size
        accessors += [
            {
                "bufferView": len(accessors),
                "componentType": _FLOAT,
                "count": len(points),
                "type": "VEC3",
                "min": points.min(axis=0).tolist(),
                "max": points.max(axis=0).tolist(),
            },
            {
                "bufferView": len(accessors) + 1,
                "componentType": _UNSIGNED,
                "count": triangles.size,
                "type": "SCALAR",
            },
        ]
    return {"bufferViews": views, "accessors": accessors}

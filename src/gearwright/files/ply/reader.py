"""The body of a PLY file."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ..contents import Body, Contents, Data
from ..noted_unit import noted_unit
from ..parts import used_alone
from ..rounding import single_precision
from ..text.places import AGAIN
from .binary import read_binary
from .header import LISTS, Header, read_header
from .text import read_text


def parse(data: Data, name: str) -> Contents:
    """The one body of a PLY file, text or binary of either order. Polygons stay whole; vertices without
    faces are left out.

    Properties and elements other than vertices' x, y, z and faces' vertex_indices or vertex_index are passed over.
    Rounding is that of single precision where x, y or z has this type, and in text what `Written.rounding` finds.
    Raises FileError with the place and what stands there if the file is not whole or holds no faces.
    """
    data = bytes(data)
    if not data.strip():
        raise FileError(f"{name}: the file is empty; a PLY file was expected; write it again")
    header = read_header(data, name)
    _require_body(name, header)
    if header.form == "ascii":
        points, corners, rounding = read_text(data, header, name)
    else:
        points, corners = read_binary(data, header, name)
        rounding = 0.0
    points, corners = used_alone(points, corners)
    body = Body(
        name="",
        vertices=points,
        indices=corners.indices,
        offsets=corners.offsets,
        rounding=max(rounding, _rounding_of_type(header, points)),
    )
    return Contents(bodies=(body,), length_unit=noted_unit(data), remarks=_remarks(header))


def _require_body(path: str, header: Header) -> None:
    """Raises FileError unless the header tells of vertices with coordinates and of faces."""
    vertices, faces = header.element("vertex"), header.element("face")
    if header.element("tristrips") and not (faces and faces.count):
        raise FileError(
            f"{path}: this PLY file has strips of triangles (tristrips), not faces; write it again with faces, as most"
            " programs do if asked, or read it once with MeshLab or vcglib and save it"
        )
    if not vertices or not vertices.count:
        raise FileError(f"{path}: a PLY file without vertices; nothing was exported")
    wrong = [axis for axis in "xyz" if not (found := vertices.named(axis)) or found.count_type]
    if wrong:
        raise FileError(f"{path}: the vertices of this PLY file have no numbers {', '.join(wrong)}; {AGAIN}")
    if not faces or not faces.count:
        raise FileError(f"{path}: a PLY file without faces, points alone bound no body; export its polygons as well")
    corners = faces.named(*LISTS)
    if not corners or not corners.count_type or "f" in corners.type + corners.count_type:
        raise FileError(
            f'{path}: the faces of this PLY file have no list "vertex_indices" of integers, but {faces.listed}; {AGAIN}'
        )
    for element in header.elements:
        for one in element.properties:
            if one.count_type and "f" in one.count_type:
                raise FileError(
                    f"{path}: the list {one.name} of {element.name} in this PLY file has a count that is"
                    f" no integer; {AGAIN}"
                )


def _rounding_of_type(header: Header, points: Array) -> float:
    vertices = header.element("vertex")
    single = vertices and any(one.type == "f4" and one.name in "xyz" for one in vertices.properties)
    return single_precision(float(np.abs(points).max())) if single else 0.0


def _remarks(header: Header) -> tuple[str, ...]:
    others = [
        f"{one.name} ({one.count})" for one in header.elements if one.name not in ("vertex", "face") and one.count
    ]
    return (f"left out, as they are neither vertices nor faces: {', '.join(others)}",) if others else ()

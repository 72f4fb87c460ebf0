"""Model parts of a 3MF file, read element by element."""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable
from dataclasses import replace
from typing import final

import numpy as np

from ...arrays import Array
from ..text.places import shown
from .extensions import CORE, PRODUCTION, remark_about, require_known
from .model import Mesh, ModelPart, Object, Reference
from .package import Package, part_name
from .xml import Attributes, Reader

UNITS = {"micron": "um", "millimeter": "mm", "centimeter": "cm", "inch": "in", "foot": "ft", "meter": "m"}
"""Keys of LENGTH_UNITS by the names that 3MF has for them."""

_WHOLE = re.compile(r"\d{1,10}", re.ASCII)
_KINDS = ("model", "solidsupport", "support", "surface", "other")
_LONGEST = 200  # characters of a name that are kept

_PARENTS = {
    "model": "", "resources": "model", "object": "resources", "mesh": "object", "vertices": "mesh", "triangles": "mesh",
    "vertex": "vertices", "triangle": "triangles", "components": "object", "component": "components", "build": "model",
    "item": "build",
}  # fmt: skip
"""What each element of the core specification that is read stands in."""


def read_part(package: Package, part: str) -> ModelPart:
    """The model in a part of a package. Raises FileError naming part and line where it is not one of 3MF."""
    reading = _Reading(package.name, part)
    reading.reader.feed(package.chunks(part))
    return reading.result()


@final
class _Reading:
    """Elements of a part as they come. Those of other namespaces are passed over with all that is in them."""

    def __init__(self, file: str, part: str):
        self._file, self._part = file, part
        self.reader = Reader(f"{file}: {shown(part, 80)}", self._start, self._end)
        handlers = {
            "model": self._model, "object": self._object, "mesh": self._mesh, "vertex": self._vertex,
            "triangle": self._triangle, "component": self._component, "item": self._item,
        }  # fmt: skip
        self._starts: dict[str, tuple[str, Callable[[Attributes], None] | None]] = {
            f"{CORE}|{tag}": (f"{CORE}|{parent}" if parent else "", handlers.get(tag))
            for tag, parent in _PARENTS.items()
        }
        self._ends = {f"{CORE}|object": self._object_ends, f"{CORE}|mesh": self._mesh_ends}
        self._stack = [""]
        self._passed_over = 0
        self._unit = "mm"
        self._objects: dict[int, Object] = {}
        self._items: list[Reference] = []
        self._remarks: dict[str, None] = {}
        self._number = 0
        self._open = Object(name="", kind="model")
        self._components: list[Reference] = []
        self._coordinates, self._corners = array("d"), array("q")

    def result(self) -> ModelPart:
        return ModelPart(
            length_unit=self._unit, objects=self._objects, items=tuple(self._items), remarks=tuple(self._remarks)
        )

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        if self._passed_over:
            self._passed_over += 1
            return
        known = self._starts.get(tag)
        if known is None:
            self._pass_over(tag)
            return
        parent, handle = known
        if self._stack[-1] != parent:
            raise self.reader.error(f"<{_bare(tag)}> stands in <{_bare(self._stack[-1])}>, not in <{_bare(parent)}>")
        self._stack.append(tag)
        if handle is not None:
            handle(attributes)

    def _end(self, tag: str) -> None:
        if self._passed_over:
            self._passed_over -= 1
            return
        self._stack.pop()
        close = self._ends.get(tag)
        if close is not None:
            close()

    def _pass_over(self, tag: str) -> None:
        if len(self._stack) == 1:
            raise self.reader.error(
                f"begins with <{_bare(tag)}>, not with <model> of the namespace {CORE}; it is no 3MF model"
            )
        self._passed_over = 1
        if (remark := remark_about(tag.rpartition("|")[0])) is not None:
            self._remarks[remark] = None

    def _model(self, attributes: Attributes) -> None:
        unit = attributes.get("unit", "millimeter")
        if unit not in UNITS:
            raise self.reader.error(f'unit="{shown(unit)}"; 3MF has {", ".join(UNITS)}')
        self._unit = UNITS[unit]
        for prefix in attributes.get("requiredextensions", "").split():
            uri = self.reader.prefixes.get(prefix, prefix)
            require_known(self._file, uri)

    def _object(self, attributes: Attributes) -> None:
        self._number = self._whole(attributes, "id")
        if self._number in self._objects:
            raise self.reader.error(f"a second object has id {self._number}")
        kind = attributes.get("type", "model")
        if kind not in _KINDS:
            raise self.reader.error(f'type="{shown(kind)}" of an object; 3MF has {", ".join(_KINDS)}')
        name = attributes.get("name") or attributes.get("partnumber") or ""
        self._open = Object(name=name[:_LONGEST], kind=kind)
        self._components = []

    def _object_ends(self) -> None:
        self._objects[self._number] = replace(self._open, components=tuple(self._components))

    def _mesh(self, _: Attributes) -> None:
        if self._open.mesh is not None:
            raise self.reader.error(f"object {self._number} has two meshes")
        self._coordinates, self._corners = array("d"), array("q")

    def _vertex(self, attributes: Attributes) -> None:
        try:
            x, y, z = attributes["x"], attributes["y"], attributes["z"]
            self._coordinates.extend((float(x), float(y), float(z)))
        except (KeyError, ValueError):
            raise self.reader.error(f"a vertex needs numbers x, y and z, and has {_shown(attributes)}") from None
        if "_" in (text := x + y + z) or not text.isascii():  # 1_0 is 10 to Python alone
            raise self.reader.error(f"a vertex needs numbers x, y and z, and has {_shown(attributes)}")

    def _triangle(self, attributes: Attributes) -> None:
        try:
            a, b, c = attributes["v1"], attributes["v2"], attributes["v3"]
            self._corners.extend((int(a), int(b), int(c)))
        except (KeyError, ValueError, OverflowError):
            raise self.reader.error(f"a triangle needs vertex numbers v1, v2 and v3: {_shown(attributes)}") from None
        if "_" in (text := a + b + c) or not text.isascii():
            raise self.reader.error(f"a triangle needs vertex numbers v1, v2 and v3: {_shown(attributes)}")

    def _mesh_ends(self) -> None:
        vertices = np.array(self._coordinates, dtype=np.float64).reshape(-1, 3)
        triangles = np.array(self._corners, dtype=np.int64).reshape(-1, 3)
        where = f"object {self._number}"
        bad = np.flatnonzero(~np.isfinite(vertices).all(axis=1))
        if len(bad):
            raise self.reader.error(f"vertex {bad[0]} of {where} is not finite: {vertices[bad[0]].tolist()}")
        bad = np.flatnonzero(((triangles < 0) | (triangles >= len(vertices))).any(axis=1))
        if len(bad):
            raise self.reader.error(
                f"triangle {bad[0]} of {where} has the corners {triangles[bad[0]].tolist()}; there are"
                f" {len(vertices)} vertices, numbered from 0"
            )
        self._open = replace(self._open, mesh=Mesh(vertices=vertices, triangles=triangles))

    def _component(self, attributes: Attributes) -> None:
        self._components.append(self._reference(attributes))

    def _item(self, attributes: Attributes) -> None:
        self._items.append(self._reference(attributes))

    def _reference(self, attributes: Attributes) -> Reference:
        path = attributes.get(f"{PRODUCTION}|path")
        return Reference(
            part=self._part if path is None else part_name(path, self._file),
            number=self._whole(attributes, "objectid"),
            matrix=self._matrix(attributes.get("transform")),
            name=attributes.get("partnumber", "")[:_LONGEST],
        )

    def _whole(self, attributes: Attributes, key: str) -> int:
        text = attributes.get(key, "")
        if not _WHOLE.fullmatch(text):
            raise self.reader.error(f'{key}="{shown(text)}"; a whole number from 0 is needed')
        return int(text)

    def _matrix(self, text: str | None) -> Array:
        """From "m00 m01 m02 m10 … m32", by which row vectors are multiplied: (x y z 1) M."""
        matrix = np.eye(4)
        if text is None:
            return matrix
        try:
            values = [float(word) for word in text.split()]
        except ValueError:
            values = []
        if len(values) != 12 or not np.isfinite(values).all() or "_" in text:
            raise self.reader.error(f'transform="{shown(text, 80)}"; 12 numbers are needed')
        matrix[:3] = np.array(values).reshape(4, 3).T
        return matrix


def _bare(tag: str) -> str:
    return shown(tag.rpartition("|")[2])


def _shown(attributes: Attributes) -> str:
    return ", ".join(f'{shown(key, 20)}="{shown(value)}"' for key, value in list(attributes.items())[:5]) or "none"

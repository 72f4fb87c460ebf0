"""Bodies of a 3MF file: one for every mesh that its build places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple, final

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ..contents import Body, Contents, Data
from ..instances import expanded, placed
from ..text.places import shown
from .model import ModelPart, Object
from .model_part import read_part
from .package import Package, part_name
from .xml import Reader

RELATIONSHIPS = "_rels/.rels"
MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
DEFAULT_START = "3D/3dmodel.model"


def parse(data: Data, name: str) -> Contents:
    """The bodies that a 3MF file builds: one a placed mesh, its vertices shared as they are in the file.

    Mirrored meshes have their faces turned, so that they stay outward. Objects of type support, solidsupport, surface
    and other are no bodies; colours, materials and pictures are passed over.
    Raises FileError if the data are not a whole 3MF file with a body, require an extension that changes shapes, or
    unpack, nest or repeat beyond the limits of `package` and `instances`.
    """
    package = Package(data, name)
    model = _Model(package)
    bodies = tuple(placed(name, model.bodies()))
    if not bodies:
        raise FileError(
            f"{name}: a 3MF file that builds no body: {'; '.join(model.left_out()) or 'its build has no items'};"
            " export it again with the bodies chosen"
        )
    return Contents(bodies=bodies, length_unit=model.start.length_unit, remarks=model.remarks())


_BUILD = ""
"""Stands for the part where a key is of an item of the build, by its number there."""


class _Key(NamedTuple):
    """An object of a part, or an item of the build."""

    part: str
    number: int

    def __str__(self) -> str:
        return f"object {self.number} of {shown(self.part)}"


@final
class _Model:
    """Parts of a package, each read once when it is first needed."""

    def __init__(self, package: Package):
        self._package = package
        self._parts: dict[str, ModelPart] = {}
        self._left_out: dict[str, int] = {}
        self._bodies: dict[_Key, Body] = {}
        start = _start_part(package)
        self.start = read_part(package, start)
        self._parts[start.lower()] = self.start

    def bodies(self) -> Iterator[tuple[Body, Array]]:
        """Meshes with their matrices, in the order of the build."""
        roots = [(_Key(_BUILD, number), np.eye(4)) for number in range(len(self.start.items))]
        for path, matrix in expanded(self._package.name, roots, self._children):
            body = None if path[-1].part == _BUILD else self._body(path[-1])
            if body is not None:
                yield (body if body.name else replace(body, name=self._outer_name(path))), matrix

    def left_out(self) -> list[str]:
        """What was found and is no body, in words."""
        return [f"{count} {what} left out" for what, count in self._left_out.items()]

    def remarks(self) -> tuple[str, ...]:
        """Of all parts, each once."""
        return tuple(dict.fromkeys([*self.left_out(), *(r for part in self._parts.values() for r in part.remarks)]))

    def _body(self, key: _Key) -> Body | None:
        one = self._object(key)
        if one.kind != "model":
            if one.mesh is not None:
                self._leave_out(f'object(s) of type "{one.kind}"')
            return None
        if one.mesh is None:
            return None
        if not len(one.mesh.triangles):
            self._leave_out("object(s) without triangles")
            return None
        if key not in self._bodies:
            count = 3 * len(one.mesh.triangles)
            self._bodies[key] = Body(
                name=one.name,
                vertices=one.mesh.vertices,
                indices=one.mesh.triangles.reshape(-1),
                offsets=np.arange(0, count + 1, 3),
            )
        return self._bodies[key]

    def _leave_out(self, what: str) -> None:
        self._left_out[what] = self._left_out.get(what, 0) + 1

    def _children(self, key: _Key) -> Sequence[tuple[_Key, Array]]:
        held = (self.start.items[key.number],) if key.part == _BUILD else self._object(key).components
        return [(_Key(one.part, one.number), one.matrix) for one in held]

    def _outer_name(self, path: tuple[_Key, ...]) -> str:
        """Of the item or else of the innermost object around a mesh without a name."""
        outer = (self._object(key).name for key in path[-2:0:-1])
        return self.start.items[path[0].number].name or next(filter(None, outer), "")

    def _object(self, key: _Key) -> Object:
        found = self._part(key.part).objects.get(key.number)
        if found is None:
            raise FileError(f"{self._package.name}: there is no {key}, which another one places; write the file again")
        return found

    def _part(self, part: str) -> ModelPart:
        found = self._parts.get(part.lower())
        if found is None:
            found = self._parts[part.lower()] = read_part(self._package, part)
            if found.length_unit != self.start.length_unit:
                raise FileError(
                    f"{self._package.name}: lengths of {shown(part)} are in {found.length_unit}, those of the part"
                    f" that places it in {self.start.length_unit}; one unit is needed; write the file again"
                )
        return found


def _start_part(package: Package) -> str:
    """The part that the package's relationships name as its model; the usual one where they name none."""
    targets: list[str] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        if tag.rpartition("|")[2] == "Relationship" and attributes.get("Type") == MODEL_TYPE:
            targets.append(attributes.get("Target", ""))

    if RELATIONSHIPS in package:
        reader = Reader(f"{package.name}: {RELATIONSHIPS}", start, lambda _: None)
        reader.feed(package.chunks(RELATIONSHIPS))
    return part_name(targets[0], package.name) if targets else DEFAULT_START

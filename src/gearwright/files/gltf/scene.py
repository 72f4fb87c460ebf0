"""Bodies of a glTF file: one for every node of its scene that has a mesh."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple, final

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ..contents import Body, Contents, Data
from ..instances import expanded, placed
from ..text.places import shown
from .accessors import Accessors
from .buffers import Buffers, chosen
from .container import opened
from .document import Value
from .meshes import Meshes

_COMPRESSED = ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression")
_INSTANCING = "EXT_mesh_gpu_instancing"
_UNDERSTOOD = "KHR_mesh_quantization"
_HARMLESS = ("KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_lights_", "EXT_texture_", "MSFT_texture_",
             "MSFT_packing_", "KHR_xmp", "KHR_animation_pointer")  # fmt: skip
"""How extensions begin that leave meshes and their places as they are."""


def parse(data: Data, name: str) -> Contents:
    """The bodies of a glTF file's scene, in metres: one a node with a mesh, all triangles of the mesh together.

    Coordinates stay as they stand in the file, where y is up; points of a mesh with equal coordinates are joined,
    since glTF splits them where normals or colours change. Mirrored meshes have their faces turned. Poses are those
    of the nodes: animations, skins and morph targets are not applied.
    Raises FileError if the data are not a whole glTF 2 file with a body, require an extension that hides or repeats
    meshes or is not known, or name data outside the file's folder.
    """
    found, binary = opened(bytes(data), name)
    _require_known(found, name)
    scene = _Scene(found, Meshes(found, Accessors(found, Buffers(found, binary, name))), name)
    bodies = tuple(placed(name, scene.bodies()))
    remarks = scene.remarks()
    if not bodies:
        raise FileError(f"{name}: a glTF file without a body: {'; '.join(remarks) or 'its scene has no meshes'}")
    return Contents(bodies=bodies, length_unit="m", remarks=tuple(remarks))


def _require_known(found: Value, name: str) -> None:
    """Raises FileError where the file requires an extension that hides or repeats meshes, or may, being unknown.

    Source: section 3.12: what requires an extension that a reader does not know must not be read.
    """
    for one in found.words("extensionsRequired"):
        if one in _COMPRESSED:
            raise FileError(
                f"{name}: its meshes are compressed ({one}), which is not read; export it without compression, or"
                " unpack it with a glTF tool"
            )
        if one == _INSTANCING:
            raise FileError(f"{name}: requires {one}, which is not read; export it with one node for every instance")
        if one != _UNDERSTOOD and not one.startswith(_HARMLESS):
            raise FileError(
                f"{name}: requires the glTF extension {shown(one, 80)}, which is not known here and so may change"
                " the shape or number of bodies; export it without"
            )


class _Node(NamedTuple):
    """A node by its number, for messages."""

    number: int

    def __str__(self) -> str:
        return f"node {self.number}"


@final
class _Scene:
    """Nodes of the scene that is shown."""

    def __init__(self, found: Value, meshes: Meshes, name: str):
        self._nodes, self._meshes, self._name = found.items("nodes"), meshes, name
        self._remarks: dict[str, None] = {}
        self._require_a_tree()
        self._roots = self._shown(found)

    def bodies(self) -> Iterator[tuple[Body, Array]]:
        """Meshes with their matrices, in the order of the scene."""
        roots = [(root, self._matrix(root)) for root in self._roots]
        for path, matrix in expanded(self._name, roots, self._children):
            node = self._nodes[path[-1].number]
            if "mesh" not in node:
                continue
            mesh = chosen(self._meshes.listed, node, "mesh", "meshes")
            body = self._meshes.body(node.whole("mesh"))
            if "skin" in node:
                self._remarks["skins left out: bodies are read in the pose in which they are stored"] = None
            if _INSTANCING in node.member("extensions"):
                self._remarks[f"instances by {_INSTANCING} left out: a body is read once a node"] = None
            if body is not None:
                yield replace(body, name=node.name() or mesh.name()), matrix

    def remarks(self) -> list[str]:
        return [*self._remarks, *self._meshes.left_out]

    def _shown(self, found: Value) -> list[_Node]:
        """The roots of the scene the file names, or else of its first; of all nodes where it has none."""
        scenes = found.items("scenes")
        if not scenes:
            held = {self._number(one) for node in self._nodes for one in node.items("children")}
            return [_Node(number) for number in range(len(self._nodes)) if number not in held]
        scene = chosen(scenes, found, "scene", "scenes") if "scene" in found else scenes[0]
        if len(scenes) > 1:
            self._remarks[f"{len(scenes) - 1} other scenes left out"] = None
        return [_Node(self._number(one)) for one in scene.items("nodes")]

    def _require_a_tree(self) -> None:
        holders: dict[int, Value] = {}
        for node in self._nodes:
            for one in node.items("children"):
                number = self._number(one)
                if number in holders:
                    raise one.error(f"node {number} is held by {holders[number].place}, too; a node has one place")
                holders[number] = node

    def _number(self, one: Value) -> int:
        number = one.index()
        if number >= len(self._nodes):
            raise one.error(f"there is no node {number}; there are {len(self._nodes)}, numbered from 0")
        return number

    def _children(self, node: _Node) -> Sequence[tuple[_Node, Array]]:
        held = (_Node(self._number(one)) for one in self._nodes[node.number].items("children"))
        return [(one, self._matrix(one)) for one in held]

    def _matrix(self, one: _Node) -> Array:
        """Of a node in what holds it (4, 4): given by columns, or T R S of its parts. Source: section 3.5.3."""
        node = self._nodes[one.number]
        if "matrix" in node:
            matrix = np.array(node.numbers("matrix", [0.0] * 16)).reshape(4, 4).T
            if not np.array_equal(matrix[3], [0.0, 0.0, 0.0, 1.0]):
                raise node.error(f"the last row of its matrix is {matrix[3].tolist()}; 0 0 0 1 is needed")
            return matrix
        matrix = np.eye(4)
        rotation = _rotation(node, node.numbers("rotation", [0.0, 0.0, 0.0, 1.0]))
        matrix[:3, :3] = rotation * np.array(node.numbers("scale", [1.0, 1.0, 1.0]))
        matrix[:3, 3] = node.numbers("translation", [0.0, 0.0, 0.0])
        return matrix


_FROM_UNIT = 1e-2
"""A quaternion may be this far from length 1, as rounded ones are; it is scaled to it."""


def _rotation(node: Value, quaternion: list[float]) -> Array:
    """The rotation (3, 3) of a unit quaternion x, y, z, w: v → v + 2 w (q × v) + 2 q × (q × v)."""
    length = math.hypot(*quaternion)  # which does not overflow, as norms do
    if not abs(length - 1.0) <= _FROM_UNIT:
        raise node.error(f"its rotation {quaternion} has length {length:.6g}; a unit quaternion is needed")
    x, y, z, w = np.array(quaternion) / length
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + 2.0 * w * cross + 2.0 * cross @ cross

"""Meshes of a glTF file as bodies: all triangles of a mesh, points with equal coordinates joined."""

from __future__ import annotations

from typing import final

import numpy as np

from ...arrays import Array, Indices
from ..contents import Body
from ..welding import welded
from .accessors import Accessors
from .document import Value

_POINTS, _LINES, _TRIANGLES, _STRIP, _FAN = 0, (1, 2, 3), 4, 5, 6
_TARGETS = "morph targets left out: bodies are read without them"


@final
class Meshes:
    """Bodies by the numbers of their meshes; `left_out` counts what is none, in words."""

    def __init__(self, found: Value, accessors: Accessors):
        self.listed = found.items("meshes")
        self._accessors = accessors
        self._bodies: dict[int, Body | None] = {}
        self.left_out: dict[str, None] = {}

    def body(self, number: int) -> Body | None:
        """A mesh's triangles as it has them; None where it has none, only points or lines.

        Raises FileError where an accessor or an index is wrong.
        """
        if number not in self._bodies:
            self._bodies[number] = self._joined(self.listed[number])
        return self._bodies[number]

    def _joined(self, mesh: Value) -> Body | None:
        corners: list[Array] = []
        rounding = 0.0
        for primitive in mesh.items("primitives"):
            found = self._corners(primitive)
            if found is not None:
                corners.append(found[0])
                rounding = max(rounding, found[1])
        if not corners:
            return None
        same = {one.dtype for one in corners} == {np.dtype(np.float32)}
        points = np.concatenate(corners) if same else np.concatenate([one.astype(np.float64) for one in corners])
        vertices, indices = welded(points)
        return Body(
            name=mesh.name(),
            vertices=vertices,
            indices=indices,
            offsets=np.arange(0, len(indices) + 1, 3),
            rounding=rounding,
        )

    def _corners(self, primitive: Value) -> tuple[Array, float] | None:
        """Points of the corners (3 m, 3) of a primitive's triangles and their rounding; None where it has none."""
        mode = primitive.whole("mode", _TRIANGLES, most=6)
        attributes = primitive.member("attributes")
        if mode < _TRIANGLES or "POSITION" not in attributes:
            what = "points" if mode == _POINTS else "lines" if mode in _LINES else "triangles without positions"
            self.left_out[f"{what} left out"] = None
            return None
        if primitive.items("targets"):
            self.left_out[_TARGETS] = None
        positions, rounding = self._accessors.positions(attributes)
        count = len(positions)
        numbers = self._accessors.indices(primitive) if "indices" in primitive else np.arange(count)
        if numbers.max() >= count:
            raise primitive.error(
                f"index {numbers.max()} at place {int(numbers.argmax())}; there are {count} points, numbered from 0;"
                " write the file again"
            )
        triangles = _triangles(primitive, mode, numbers)
        return (positions[triangles.reshape(-1)], rounding) if len(triangles) else None


def _triangles(primitive: Value, mode: int, numbers: Indices) -> Indices:
    """Triangles (m, 3) of points in the order of a list, a strip or a fan.

    Triangles of a strip with two corners at one point link its pieces and are no faces. Source: section 3.7.2.1.
    """
    count = len(numbers)
    if mode == _TRIANGLES:
        if count % 3:
            raise primitive.error(f"{count} corners, which make no whole triangles; the file is damaged")
        return numbers.reshape(-1, 3)
    k = np.arange(max(count - 2, 0))
    if mode == _FAN:
        return np.stack([numbers[k + 1], numbers[k + 2], np.broadcast_to(numbers[:1], k.shape)], axis=1)
    odd = k % 2
    strip = np.stack([numbers[k], numbers[k + 1 + odd], numbers[k + 2 - odd]], axis=1)
    linking = (strip == np.roll(strip, 1, axis=1)).any(axis=1)
    return strip[~linking]

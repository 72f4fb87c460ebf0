"""What a page draws as one binary message: a header in JSON, then arrays that a browser reads without copying.

    uint32 length of the header | header, padded with spaces to a multiple of 8 in all | arrays, each padded to 4 bytes

A position takes 8 bytes: its coordinates are whole steps, 2²¹ to the extent of its shell, x in the lowest bits. A
normal takes 4: two int16 of the octahedral map, on which the sphere is unfolded into a square. Triangles and edges that
the page knows already, by a key made from them, are not sent again.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import blake2b
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from .shells import Shell
from .turning import AT_REST, Turning

_STEPS = 2**21 - 1
_FULL = 32767  # int16


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnBody:
    """A body where it stands. placement (4, 4) puts it there; turning says how it moves from there

    called   what people call it
    """

    name: str
    called: str
    colour: tuple[float, float, float]
    shells: Sequence[Shell]
    placement: Array
    turning: Turning = AT_REST


@dataclass
class _Buffers:
    """Arrays one behind another, and where each begins."""

    parts: list[bytes] = field(default_factory=list)
    length: int = 0

    def add(self, array: Array | Indices, kind: str) -> int:
        data = np.ascontiguousarray(array, kind).tobytes()
        data += b"\0" * (-len(data) % 4)
        start = self.length
        self.parts.append(data)
        self.length += len(data)
        return start


def frame(header: Mapping[str, Any], bodies: Sequence[DrawnBody], known: Collection[str] = ()) -> bytes:
    """The message. header   what is said beside the bodies; known   keys of topologies that the page has"""
    buffers = _Buffers()
    described = [_body(body, known, buffers) for body in bodies]
    extents = [np.subtract(one["most"], one["least"]) for one in described]
    turning = any(body.turning != AT_REST for body in bodies)
    turns = [body.turning.most(extent) for body, extent in zip(bodies, extents, strict=True)]
    triangles = sum(shell.pattern.order * len(shell.triangles) for body in bodies for shell in body.shells)
    document = {
        **header,
        "turns": min(turns) if turning else None,
        "triangles": triangles,
        "bytes": buffers.length,
        "bodies": described,
    }
    text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-(4 + len(text)) % 8)
    return b"".join([len(text).to_bytes(4, "little"), text, *buffers.parts])


def _body(body: DrawnBody, known: Collection[str], buffers: _Buffers) -> dict[str, Any]:
    placed = np.concatenate([_placed(body.placement, _box_corners(shell)) for shell in body.shells])
    return {
        "name": body.name,
        "called": body.called,
        "colour": body.colour,
        "place": body.placement.reshape(-1).tolist(),
        "spin": body.turning.spin,
        "slide": body.turning.slide,
        "least": placed.min(axis=0).tolist(),
        "most": placed.max(axis=0).tolist(),
        "closed": True,
        "shells": [_shell(shell, known, buffers) for shell in body.shells],
    }


def _box_corners(shell: Shell) -> Array:
    """Points (n, 3) that the images of a shell reach."""
    return shell.pattern.images(shell.positions).reshape(-1, 3)


def _placed(placement: Array, points: Array) -> Array:
    return points @ placement[:3, :3].T + placement[:3, 3]


def _shell(shell: Shell, known: Collection[str], buffers: _Buffers) -> dict[str, Any]:
    least, most = shell.positions.min(axis=0), shell.positions.max(axis=0)
    step = (most - least) / _STEPS
    whole = np.rint((shell.positions - least) / np.where(step > 0.0, step, 1.0)).astype(np.uint64)
    x, y, z = whole[:, 0], whole[:, 1], whole[:, 2]
    key = _key(shell)
    sent = key not in known
    flat = shell.normals.ndim == 1
    image = shell.pattern.image(1) if shell.pattern.order > 1 else None
    return {
        "key": key,
        "order": shell.pattern.order,
        "image": None if image is None else _matrix(image.matrix, image.shift),
        "vertices": len(shell.positions),
        "least": least.tolist(),
        "step": step.tolist(),
        "positions": buffers.add(x | y << np.uint64(21) | z << np.uint64(42), "<u8"),
        "normals": None if flat else buffers.add(_octahedral(shell.normals), "<i2"),
        "normal": shell.normals.tolist() if flat else None,
        "triangles": [buffers.add(shell.triangles, "<u4"), len(shell.triangles)] if sent else None,
        "edges": [buffers.add(shell.edges, "<u4"), len(shell.edges)] if sent else None,
    }


def _matrix(rotation: Array, shift: Array) -> list[float]:
    """A rigid map as 16 numbers, row by row."""
    whole = np.eye(4)
    whole[:3, :3], whole[:3, 3] = rotation, shift
    return whole.reshape(-1).tolist()


def _key(shell: Shell) -> str:
    digest = blake2b(digest_size=9)
    for array in (shell.triangles, shell.edges):
        digest.update(array.tobytes())
        digest.update(b"|")
    return digest.hexdigest()


def _octahedral(normals: Array) -> Array:
    """Unit vectors (n, 3) as whole numbers (n, 2) of the octahedral map: the lower half folds over the upper."""
    flat = normals[:, :2] / np.sum(np.abs(normals), axis=1, keepdims=True)
    folded = (1.0 - np.abs(flat[:, ::-1])) * np.where(flat >= 0.0, 1.0, -1.0)
    return np.rint(np.where(normals[:, 2:] >= 0.0, flat, folded) * _FULL)

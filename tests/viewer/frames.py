"""Messages of the viewer read as a page reads them: positions from whole steps, images as powers of the first."""

import json
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass
class Shell:
    entry: dict[str, Any]
    positions: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray | None
    edges: np.ndarray | None

    def images(self, points: np.ndarray, w: float = 1.0) -> np.ndarray:
        """Images (order, n, 3) of points, or with w = 0 of vectors."""
        first = np.eye(4) if self.entry["image"] is None else np.reshape(self.entry["image"], (4, 4))
        rows = np.c_[points, np.full(len(points), w)]
        return np.stack([(rows @ np.linalg.matrix_power(first, k).T)[:, :3] for k in range(self.entry["order"])])


def read(message: bytes) -> tuple[dict[str, Any], dict[str, list[Shell]]]:
    """The header, and the shells of each body by its name."""
    length = int.from_bytes(message[:4], "little")
    assert (4 + length) % 8 == 0
    header = json.loads(message[4 : 4 + length])
    data = message[4 + length :]
    assert header["bytes"] == len(data)
    return header, {body["name"]: [_shell(one, data) for one in body["shells"]] for body in header["bodies"]}


def _shell(entry: dict[str, Any], data: bytes) -> Shell:
    n = entry["vertices"]
    words = np.frombuffer(data, "<u4", 2 * n, entry["positions"]).astype(np.int64).reshape(n, 2)
    low, high = words[:, 0], words[:, 1]
    whole = np.stack([low & 0x1FFFFF, (low >> 21) | ((high & 0x3FF) << 11), high >> 10], axis=1)
    normals = np.broadcast_to(np.array(entry["normal"] or (0, 0, 0), float), (n, 3))
    if entry["normals"] is not None:
        normals = _unfolded(np.frombuffer(data, "<i2", 2 * n, entry["normals"]).reshape(n, 2) / 32767)
    return Shell(
        entry=entry,
        positions=np.array(entry["least"]) + np.array(entry["step"]) * whole,
        normals=normals,
        triangles=_numbers(entry["triangles"], 3, data),
        edges=_numbers(entry["edges"], 2, data),
    )


def _numbers(place: list[int] | None, corners: int, data: bytes) -> np.ndarray | None:
    if place is None:
        return None
    start, count = place
    return np.frombuffer(data, "<u4", corners * count, start).reshape(count, corners).astype(int)


def _unfolded(square: np.ndarray) -> np.ndarray:
    z = 1 - np.abs(square).sum(axis=1)
    folded = np.sign(square + 1e-12) * (1 - np.abs(square[:, ::-1]))
    vectors = np.c_[np.where(z[:, None] < 0, folded, square), z]
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)

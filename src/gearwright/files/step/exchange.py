"""What the process that runs Open CASCADE hands back: solids and their places as bytes, which hold no code."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Array
from ...errors import FileError, GearwrightError, MachineError
from ..contents import Body, SmoothProperties


@dataclass(frozen=True, kw_only=True, eq=False)
class Found:
    """Solids, each once, where their own frames have them, and as often as they are placed the solid and its matrix."""

    bodies: tuple[Body, ...]
    placements: tuple[tuple[int, Array], ...]
    remarks: tuple[str, ...]


def packed(found: Found | GearwrightError) -> bytes:
    """An npz archive of it; an error as its kind and text."""
    arrays: dict[str, Any] = {}
    if isinstance(found, GearwrightError):
        head: dict[str, Any] = {"error": str(found), "machine": isinstance(found, MachineError)}
    else:
        head = {"names": [body.name for body in found.bodies], "remarks": list(found.remarks)}
        arrays["places"] = np.array([number for number, _ in found.placements], dtype=np.int64)
        arrays["matrices"] = np.array([matrix for _, matrix in found.placements]).reshape(-1, 4, 4)
        for number, body in enumerate(found.bodies):
            arrays[f"vertices {number}"] = body.vertices
            arrays[f"triangles {number}"] = body.indices.reshape(-1, 3)
            if body.smooth is not None:
                smooth = body.smooth
                arrays[f"smooth {number}"] = np.vstack([[smooth.volume] * 3, smooth.centroid, smooth.second_moment])
    stream = io.BytesIO()
    np.savez(stream, head=np.frombuffer(json.dumps(head).encode(), np.uint8), **arrays)
    return stream.getvalue()


def unpacked(data: bytes) -> Found:
    """What `packed` took. Raises that error where it was one; ValueError, KeyError, OSError if data are cut off."""
    with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
        head = json.loads(arrays["head"].tobytes())
        if "error" in head:
            raise (MachineError if head["machine"] else FileError)(head["error"])
        bodies = tuple(_body(arrays, number, name) for number, name in enumerate(head["names"]))
        placements = tuple(zip(arrays["places"].tolist(), arrays["matrices"], strict=True))
    return Found(bodies=bodies, placements=placements, remarks=tuple(head["remarks"]))


def _body(arrays: Mapping[str, Any], number: int, name: str) -> Body:
    triangles, smooth = arrays[f"triangles {number}"], f"smooth {number}"
    return Body(
        name=name,
        vertices=arrays[f"vertices {number}"],
        indices=triangles.reshape(-1),
        offsets=np.arange(0, triangles.size + 1, 3),
        smooth=_smooth(arrays[smooth]) if smooth in arrays else None,
    )


def _smooth(rows: Array) -> SmoothProperties:
    return SmoothProperties(volume=float(rows[0, 0]), centroid=rows[1], second_moment=rows[2:])

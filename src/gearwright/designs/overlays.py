"""What a page draws over the bodies on request: reference surfaces of gears, lines along which a pair touches."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .. import catalog
from ..errors import GeometryError
from ..parameters import Size
from ..sources import Source, load
from .built import Built, Part

_CYLINDERS = {"pitch": "pitch_diameter", "base": "base_diameter", "tip": "outside_diameter", "root": "root_diameter"}
_CONES = {"pitch": "pitch_angle", "base": "base_angle", "face": "face_angle", "root": "root_angle"}
_APEXES = {"face": "face_apex", "root": "root_apex"}
"""Reference surfaces by the sizes that give them; the apex of face and root cone may lie off the pitch cone's."""


def overlays(kind: catalog.Element, built: Built) -> dict[str, Any]:
    """{"bodies": surfaces of each member in its own frame, "lines": lines of contact in the frame of the pair}."""
    bodies = [{"name": name, "surfaces": _surfaces(part)} for name, part in built.parts.items()]
    return {"bodies": bodies, "lines": [] if kind.lines is None else _contact(kind.lines, built.pair)}


def _contact(source: Source, pair: Any) -> list[dict[str, Any]]:
    """Lines of contact; none where they cannot be found, as of a face that is hardly any."""
    try:
        steps, pitch = load(source)(pair)
    except GeometryError:
        return []
    return [{"name": "lines of contact", "pitch": pitch, "steps": [[p.tolist() for p in s] for s in steps]}]


def _surfaces(part: Part) -> list[dict[str, Any]]:
    sizes = part.gear.sizes()
    if "pitch_angle" in sizes:
        return [_cone(name, sizes) for name, angle in _CONES.items() if angle in sizes]
    box = part.properties.bounding_box
    if box is None:
        return []
    least, most = box[:, 2]
    return [
        {
            "name": f"{name} cylinder",
            "kind": name,
            "form": "cylinder",
            "radius": sizes[diameter].value / 2.0,
            "least": float(least),
            "most": float(most),
        }
        for name, diameter in _CYLINDERS.items()
        if diameter in sizes
    ]


def _cone(name: str, sizes: Mapping[str, Size]) -> dict[str, Any]:
    """From its apex to the outer cone distance."""
    half_angle = sizes[_CONES[name]].value
    apex = -sizes[_APEXES[name]].value if name in _APEXES and _APEXES[name] in sizes else 0.0
    most = sizes["cone_distance"].value * float(np.cos(np.radians(sizes["pitch_angle"].value)))
    return {
        "name": f"{name} cone",
        "kind": name,
        "form": "cone",
        "half_angle": half_angle,
        "apex": apex,
        "least": min(apex, 0.0),
        "most": most,
    }

"""The parts that an element is made of, and where they stand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from .. import catalog
from ..arrays import Array
from ..elements.assembly import PlacedPart


def members(kind: catalog.Element, element: Any) -> dict[str, Any]:
    """Parts by name: a pair's pinion and gear, or the one part by the name of its kind."""
    return element.members if kind.members == 2 else {kind.name: element}


def called(kind: catalog.Element, name: str) -> str:
    """What people call a part of an element of a kind."""
    return kind.mate if kind.members == 2 and name == "gear" else name


def placements(kind: catalog.Element, element: Any, turn: float = 0.0) -> list[Array]:
    """Rigid motions (4, 4) that put the parts in mesh, the pinion turned by degrees; one part stays where it is."""
    return list(element.placements(turn)) if kind.members == 2 else [np.eye(4)]


def placed_parts(
    parts: Mapping[str, Any], where: Iterable[Array], tolerance: float | None, clearance: float = 0.0
) -> list[PlacedPart]:
    """Parts where they stand, to be written or drawn within a tolerance and with a clearance (lengths)."""
    return [
        PlacedPart(
            name=name,
            label=f"{name}\n{part.description}" if len(parts) > 1 else "",
            element=part,
            placement=placement,
            upward=part.upward,
            tolerance=tolerance,
            clearance=clearance,
        )
        for (name, part), placement in zip(parts.items(), where, strict=True)
    ]

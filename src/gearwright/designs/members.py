"""The parts that an element is made of, and where they stand."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import catalog
from ..arrays import Array


def members(kind: catalog.Element, element: Any) -> dict[str, Any]:
    """Parts by name: a pair's pinion and gear, or the one part by the name of its kind."""
    return element.members if kind.members == 2 else {kind.name: element}


def called(kind: catalog.Element, name: str) -> str:
    """What people call a part of an element of a kind."""
    return kind.mate if kind.members == 2 and name == "gear" else name


def placements(kind: catalog.Element, element: Any, turn: float = 0.0) -> list[Array]:
    """Rigid motions (4, 4) that put the parts in mesh, the pinion turned by degrees; one part stays where it is."""
    return list(element.placements(turn)) if kind.members == 2 else [np.eye(4)]

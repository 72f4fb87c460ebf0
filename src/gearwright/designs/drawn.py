"""What is built as a page draws it: a binary message of its bodies where they stand."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, Literal, Protocol

import numpy as np

from .. import catalog
from ..boundary.boundary import Boundary
from ..boundary.extent import edge_diagonal
from ..boundary.sampling import sampling
from ..colours import BRASS, STEEL
from ..elements.assembly import alone
from ..pictures.camera import Shape, View, view_of
from ..viewer.frame import DrawnBody, frame
from ..viewer.shells import Shell, shells
from ..viewer.turning import AT_REST, STEP, Turning
from .members import called, members, placements

TOLERANCE = 1e-4
"""How far what is drawn may lie from the exact surface, by the diagonal of each body's edges."""


class Drawn(Protocol):
    """An element that is one part."""

    @property
    def upward(self) -> Literal[1, -1]: ...
    @property
    def boundary(self) -> Boundary: ...


def drawn(kind: catalog.Element, element: Any, number: int | None, known: Collection[str]) -> bytes:
    """The message of `viewer.frame` for an element of a kind.

    number   of the question that it answers
    known    keys of topologies that the page has
    """
    parts: dict[str, Drawn] = members(kind, element)
    placed = placements(kind, element)
    turnings = [AT_REST]
    if kind.members == 2:
        turnings = [Turning.between(*both) for both in zip(placed, placements(kind, element, STEP), strict=True)]
    bodies = [
        DrawnBody(
            name=name,
            called=called(kind, name),
            colour=(BRASS, STEEL)[i % 2],
            shells=_shells(part.boundary),
            placement=placed[i],
            turning=turnings[i],
        )
        for i, (name, part) in enumerate(parts.items())
    ]
    view = alone(element.upward) if kind.members == 1 else _suitable(bodies, list(parts.values()))
    header = {
        "answer": "mesh",
        "id": number,
        "title": f"{kind.name}: {element.description}",
        "unit": element.length_unit,
        "direction": view.direction,
        "up": view.up,
        "tolerance": TOLERANCE,
    }
    return frame(header, bodies, known)


def _shells(boundary: Boundary) -> list[Shell]:
    return shells(boundary, sampling(boundary, TOLERANCE * edge_diagonal(boundary)))


def _suitable(bodies: Sequence[DrawnBody], parts: Sequence[Drawn]) -> View:
    """From where a pair's working faces are seen; a member with a pattern about its axis is a round one."""
    shapes = []
    for body, part in zip(bodies, parts, strict=True):
        points = np.concatenate([shell.pattern.images(shell.positions).reshape(-1, 3) for shell in body.shells])
        low, high = points.min(axis=0), points.max(axis=0)
        rotation, shift = body.placement[:3, :3], body.placement[:3, 3]
        is_round = any(shell.pattern.order > 1 for shell in body.shells)
        shapes.append(
            Shape(
                middle=rotation @ ((low + high) / 2.0) + shift,
                axis=rotation[:, 2] * part.upward if is_round else np.array([0.0, 0.0, 1.0]),
                is_round=is_round,
                size=float(np.linalg.norm(high - low)),
            )
        )
    return view_of(shapes)

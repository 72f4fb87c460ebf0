"""Meshes placed by a graph of nodes, as 3MF components and glTF scenes place them: one body an instance."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from ..arrays import Array
from ..errors import FileError
from .contents import Body
from .text.places import shown

Key = TypeVar("Key")

MOST_DEPTH = 128
"""Nodes one inside another; skeletons and assemblies have a few dozen."""

MOST_NODES = 100_000
"""Nodes after repeated ones are written out: ten objects that hold the next one ten times are 10¹⁰."""

MOST_FACES = 20_000_000
"""Faces after repeated bodies are written out: 2 GB in memory."""

_FLAT = 1e-12
"""Least stretch over largest, below which a map is flat: its inverse would have lost all digits but four."""


def expanded(
    name: str, roots: Iterable[tuple[Key, Array]], children: Callable[[Key], Sequence[tuple[Key, Array]]]
) -> Iterator[tuple[tuple[Key, ...], Array]]:
    """Every node that the roots lead to, as often as they do: the keys from its root to it, and its matrix (4, 4).

    roots, children   keys and the matrices (4, 4) that place them in what holds them; points are columns
    Raises FileError, naming the file, where nodes hold themselves, are too deep or too many.
    """
    stack: list[tuple[tuple[Key, ...], Array]] = []
    stack.extend(((key,), matrix) for key, matrix in reversed(list(roots)))
    count = len(stack)
    while stack:
        path, matrix = stack.pop()
        yield path, matrix
        held = children(path[-1])
        count += len(held)
        if count > MOST_NODES:
            raise FileError(
                f"{name}: its parts stand for more than {MOST_NODES} placed ones, the most that are read; parts that"
                " repeat others many times over do this; split the file"
            )
        if held and len(path) == MOST_DEPTH:
            raise FileError(f"{name}: its parts are nested more than {MOST_DEPTH} deep, the most that is read")
        for key, inner in reversed(held):
            if key in path:
                raise FileError(f"{name}: {key} holds itself{_through(path, key)}; write the file again")
            with np.errstate(all="ignore"):
                stack.append(((*path, key), matrix @ inner))


def _through(path: tuple[Key, ...], key: Key) -> str:
    between = path[path.index(key) + 1 :]
    return f" through {', '.join(map(str, between[:3]))}" if between else ""


def placed(name: str, bodies: Iterable[tuple[Body, Array]]) -> Iterator[Body]:
    """Bodies of triangles mapped by matrices (4, 4), r → A r + t; where A mirrors, faces are turned to stay outward.

    Raises FileError, naming the file and the body, where a matrix is flat or not finite, or the faces are too many.
    """
    total = 0
    for body, matrix in bodies:
        total += len(body.offsets) - 1
        if total > MOST_FACES:
            raise FileError(
                f"{name}: its bodies have more than {MOST_FACES} triangles together, repeated ones counted as often as"
                " they are placed, the most that are read; split the file"
            )
        yield _mapped(name, body, matrix)


def _mapped(name: str, body: Body, matrix: Array) -> Body:
    if np.array_equal(matrix, np.eye(4)):
        return body
    linear, shift = matrix[:3, :3], matrix[:3, 3]
    stretches = np.linalg.svd(linear, compute_uv=False) if np.isfinite(matrix).all() else np.zeros(3)
    if not stretches[2] > _FLAT * stretches[0]:
        raise FileError(
            f'{name}: the transform of the body "{shown(body.name)}" is flat or not finite: it keeps no volume;'
            f" {matrix[:3].tolist()}; write the file again from the program that made it"
        )
    with np.errstate(all="ignore"):
        vertices = body.vertices @ linear.T + shift
    if not np.isfinite(vertices).all():
        raise FileError(f'{name}: the transform of the body "{shown(body.name)}" takes it beyond all numbers')
    mirrors = np.linalg.det(linear / stretches[0]) < 0.0
    return replace(
        body,
        vertices=vertices,
        indices=body.indices.reshape(-1, 3)[:, ::-1].reshape(-1) if mirrors else body.indices,
        smooth=body.smooth and body.smooth.mapped(linear, shift),
        rounding=body.rounding * float(np.abs(linear).sum(axis=1).max()),
    )

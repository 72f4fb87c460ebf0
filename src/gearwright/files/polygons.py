"""Polygons as lines of text, each a head and its vertex numbers, as OBJ and OFF list them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .assembly import Faceted

_BLOCK = 1 << 15
"""Faces at a time."""


def listed(head: str, shape: Faceted, *, first: int) -> Iterator[bytes]:
    """The faces in their order, a line each.

    head    what a line begins with; "{}" in it becomes the number of corners
    first   the number of the shape's first vertex
    """
    sizes = np.diff(shape.offsets)
    lines = {size: head.format(size) + size * " %d" + "\n" for size in np.unique(sizes).tolist()}
    for start in range(0, len(sizes), _BLOCK):
        block = sizes[start : start + _BLOCK].tolist()
        corners = shape.indices[shape.offsets[start] : shape.offsets[start + len(block)]] + first
        yield ("".join(map(lines.__getitem__, block)) % tuple(corners.tolist())).encode("ascii")

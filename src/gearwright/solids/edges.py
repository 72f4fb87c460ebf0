"""Which edges of a polyhedron's boundary do not have exactly one face on either side."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Indices
from ..moments.faces import next_corners


@dataclass(frozen=True, kw_only=True, eq=False)
class EdgeDefects:
    """Edges (k, 2), as pairs of vertex numbers, that do not pair up two faces of one orientation.

    open          an odd number of faces meet there, mostly one: a hole, or vertices not shared
    flipped       the faces there do not all turn the same way
    non_manifold  more than two faces meet there; where they pair up the boundary still closes
    """

    open: Indices
    flipped: Indices
    non_manifold: Indices


def edge_defects(count: int, indices: Indices, offsets: Indices) -> EdgeDefects:
    """Defects of the faces' edges; `count` is the number of vertices.

    Every edge must be walked as often one way as the other. Faces with fewer than three different
    corners bound nothing and are left out.
    """
    start, end = indices, next_corners(indices, offsets)
    proper = start != end
    sides = np.add.reduceat(proper, offsets[:-1], dtype=np.int64) if len(offsets) > 1 else np.empty(0, np.int64)
    proper &= np.repeat(sides > 2, np.diff(offsets))
    start, end = start[proper], end[proper]
    # one sortable number an edge use: lower vertex, higher vertex, direction
    uses = (np.minimum(start, end) * count + np.maximum(start, end)) * 2 + (start > end)
    uses.sort()
    edges = uses >> 1
    first = np.flatnonzero(np.diff(edges, prepend=-1))
    faces = np.diff(first, append=len(edges))
    backward = np.add.reduceat(uses & 1, first) if len(first) else np.empty(0, np.int64)
    pairs = np.stack(np.divmod(edges[first], max(count, 1)), axis=-1)
    odd = faces % 2 == 1
    return EdgeDefects(open=pairs[odd], flipped=pairs[~odd & (2 * backward != faces)], non_manifold=pairs[faces > 2])

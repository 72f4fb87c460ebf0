"""The edges of a polyhedron's faces: which faces use them, and in which sense.

An edge use is a corner and the vertex after it in its face. Uses are sorted by counting, first by the higher vertex,
then by the lower one: linear in their number, however many edges meet at a vertex.

A face that runs along an edge both ways, as one with a hole does along the bridge to it, bounds nothing there: the two
uses cancel. So do those of a face that collapses to a line.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arrays import Indices
from ...compiled import compiled
from .edge_defects import EdgeDefects

Flags = NDArray[np.bool_]


class EdgeUses(NamedTuple):
    """Edge uses by edges: those of edge e are starts[e] to starts[e + 1] − 1.

    corners  (u,) corner at which a use begins; those of one face stand side by side
    forward  (u,) whether it goes from the lower vertex to the higher one
    faces    (u,) its face
    starts   (e + 1,)
    """

    corners: Indices
    forward: Flags
    faces: Indices
    starts: Indices


def edge_uses(count: int, indices: Indices, offsets: Indices) -> EdgeUses:
    """The uses of all edges between different vertices; `count` is the number of vertices."""
    return EdgeUses(*_sorted_uses(count, indices, offsets))


def bounding_uses(uses: EdgeUses) -> EdgeUses:
    """The uses without those of one face that cancel each other."""
    kept = _kept(uses.forward, uses.faces, uses.starts)
    if kept.all():
        return uses
    before = np.concatenate([[0], np.cumsum(kept)])
    starts = np.unique(before[uses.starts])
    return EdgeUses(uses.corners[kept], uses.forward[kept], uses.faces[kept], starts)


def edge_defects(bounding: EdgeUses, indices: Indices, offsets: Indices) -> EdgeDefects:
    """Defects of the faces' edges: every edge must be walked as often one way as the other."""
    unlike = np.flatnonzero(_unlike_two(bounding.forward, bounding.starts))
    uses = np.diff(bounding.starts)[unlike]
    ahead = np.concatenate([[0], np.cumsum(bounding.forward)])
    excess = 2 * np.diff(ahead[bounding.starts])[unlike] - uses
    edges = vertices_of(bounding, unlike, indices, offsets)
    one_way = np.where((excess > 0)[:, None], edges, edges[:, ::-1])
    return EdgeDefects(
        open=edges[uses % 2 == 1],
        flipped=edges[(uses % 2 == 0) & (excess != 0)],
        non_manifold=edges[uses > 2],
        excess=np.repeat(one_way, np.abs(excess), axis=0),
    )


def vertices_of(uses: EdgeUses, edges: Indices, indices: Indices, offsets: Indices) -> Indices:
    """Vertices (k, 2) of edges by their numbers (k,), the lower one first."""
    corners, faces = uses.corners[uses.starts[edges]], uses.faces[uses.starts[edges]]
    following = np.where(corners + 1 < offsets[faces + 1], corners + 1, offsets[faces])
    return np.sort(np.stack([indices[corners], indices[following]], axis=-1), axis=-1)


@compiled
def _sorted_uses(count: int, indices: Indices, offsets: Indices) -> tuple[Indices, Flags, Indices, Indices]:
    lower, higher = np.empty(len(indices), np.int64), np.empty(len(indices), np.int64)
    of_lower, of_higher = np.zeros(count + 1, np.int64), np.zeros(count + 1, np.int64)
    faces, total = np.empty(len(indices), np.int64), 0
    for f in range(len(offsets) - 1):
        for c in range(offsets[f], offsets[f + 1]):
            a, b = indices[c], indices[c + 1 if c + 1 < offsets[f + 1] else offsets[f]]
            lower[c], higher[c], faces[c] = min(a, b), max(a, b), f
            if a != b:
                of_lower[lower[c] + 1] += 1
                of_higher[higher[c] + 1] += 1
                total += 1
    for vertex in range(count):
        of_lower[vertex + 1] += of_lower[vertex]
        of_higher[vertex + 1] += of_higher[vertex]
    by_higher, corners = np.empty(total, np.int64), np.empty(total, np.int64)
    for c in range(len(indices)):
        if lower[c] != higher[c]:
            by_higher[of_higher[higher[c]]] = c
            of_higher[higher[c]] += 1
    for place in range(total):
        vertex = lower[by_higher[place]]
        corners[of_lower[vertex]] = by_higher[place]
        of_lower[vertex] += 1
    forward, of_use, starts, edges = np.empty(total, np.bool_), np.empty(total, np.int64), by_higher, 0
    low, high = np.int64(-1), np.int64(-1)
    for use in range(total):
        c = corners[use]
        forward[use], of_use[use] = indices[c] == lower[c], faces[c]
        if lower[c] != low or higher[c] != high:
            low, high = lower[c], higher[c]
            starts[edges] = use  # no edge begins before its number: what is written here has been read
            edges += 1
    ends = np.empty(edges + 1, np.int64)
    ends[:edges], ends[edges] = starts[:edges], total
    return corners, forward, of_use, ends


@compiled
def _kept(forward: Flags, faces: Indices, starts: Indices) -> Flags:
    """Which uses (u,) are left when those of one face along one edge cancel."""
    kept = np.ones(len(forward), np.bool_)
    for edge in range(len(starts) - 1):
        start = starts[edge]
        while start < starts[edge + 1]:
            stop, excess = start, 0
            while stop < starts[edge + 1] and faces[stop] == faces[start]:
                excess += 1 if forward[stop] else -1
                stop += 1
            if stop - start > 1:
                for use in range(start, stop):
                    kept[use] = excess != 0 and forward[use] == (excess > 0)
                    if kept[use]:
                        excess -= 1 if excess > 0 else -1
            start = stop
    return kept


@compiled
def _unlike_two(forward: Flags, starts: Indices) -> Flags:
    """Which edges (e,) are not used once either way."""
    found = np.ones(len(starts) - 1, np.bool_)
    for edge in range(len(starts) - 1):
        first = starts[edge]
        found[edge] = starts[edge + 1] - first != 2 or forward[first] == forward[first + 1]
    return found

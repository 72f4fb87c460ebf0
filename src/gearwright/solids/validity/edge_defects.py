"""Edges of a polyhedron's faces that keep it from bounding a solid, or nearly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Indices


@dataclass(frozen=True, kw_only=True, eq=False)
class EdgeDefects:
    """Edges (k, 2), as pairs of vertex numbers, that do not pair up two faces of one orientation.

    open          an odd number of faces meet there, mostly one: a hole, or vertices not shared
    flipped       the faces there do not all turn the same way
    non_manifold  more than two faces meet there; where they pair up the boundary still closes
    excess        (k, 2) edges that faces use more often one way, in that way, as often as they do: of these the
                  fans towards any point would close the boundary
    """

    open: Indices
    flipped: Indices
    non_manifold: Indices
    excess: Indices


def chains(edges: Indices) -> int:
    """Number of connected chains that edges (k, 2) make: of open edges, the number of holes."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    names, ends = np.unique(edges, return_inverse=True)
    ends = ends.reshape(-1, 2)
    graph = coo_matrix((np.ones(len(ends), np.int8), (ends[:, 0], ends[:, 1])), shape=(len(names), len(names)))
    return int(connected_components(graph, directed=False)[0])

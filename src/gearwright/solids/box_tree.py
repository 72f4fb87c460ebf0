"""Which of many boxes overlap: a binary tree over boxes in the order of a space-filling curve."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled

LEAF = 4
"""Boxes a leaf holds."""

_BLOCK = 256
"""Boxes whose partners are listed at a time, so that memory stays small where very many overlap."""


def overlapping_pairs(boxes: Array) -> Iterator[Indices]:
    """Pairs (k, 2) of boxes (n, 2, 3), lowest and highest coordinates, that share a point; each once, in blocks."""
    if not len(boxes):
        return
    order, ordered, nodes = box_tree(boxes)
    for start in range(0, len(boxes), _BLOCK):
        yield order[_pairs(ordered, nodes, start, min(start + _BLOCK, len(boxes)))]


def box_tree(boxes: Array) -> tuple[Indices, Array, Array]:
    """Order (n,) of boxes (n, 2, 3) along the curve, the boxes so (n, 6), and the boxes (2 m, 6) of the nodes.

    Leaf k of the last m nodes holds the boxes from LEAF (k − m) on, LEAF of them.
    """
    order = np.argsort(_curve_places(boxes.mean(axis=1)), kind="stable")
    ordered = np.ascontiguousarray(boxes[order].reshape(-1, 6))
    return order, ordered, _tree(ordered)


def _curve_places(points: Array) -> Indices:
    """Places of points (n, 3) along a curve through 1024³ cells: bits of the three coordinates in turn."""
    low = points.min(axis=0)
    size = float(np.max(points.max(axis=0) - low)) or 1.0
    cells = np.minimum((points - low) * (1024.0 / size), 1023.0).astype(np.int64)
    places = np.zeros(len(points), np.int64)
    for bit in range(10):
        for axis in range(3):
            places |= (cells[:, axis] >> bit & 1) << (3 * bit + axis)
    return places


def _tree(boxes: Array) -> Array:
    """Boxes (2 m, 6) of a full binary tree's nodes: children of k are 2 k and 2 k + 1, leaves the last m."""
    leaves = 1 << max(0, int(np.ceil(np.log2(len(boxes) / LEAF))))
    padded = np.empty((leaves * LEAF, 6))
    padded[:, :3], padded[:, 3:] = np.inf, -np.inf
    padded[: len(boxes)] = boxes
    nodes = np.empty((2 * leaves, 6))
    level = padded.reshape(leaves, LEAF, 6)
    while True:
        count = len(level)
        nodes[count : 2 * count, :3] = level[..., :3].min(axis=1)
        nodes[count : 2 * count, 3:] = level[..., 3:].max(axis=1)
        if count == 1:
            return nodes
        level = nodes[count : 2 * count].reshape(count // 2, 2, 6)


@compiled
def _pairs(boxes: Array, nodes: Array, start: int, stop: int) -> Indices:
    """Pairs (k, 2), the first from start to stop, the second after it."""
    leaves = len(nodes) // 2
    found = np.empty((4 * (stop - start), 2), np.int64)
    count = 0
    waiting = np.empty(128, np.int64)
    for i in range(start, stop):
        waiting[0] = 1
        depth = 1
        while depth:
            depth -= 1
            node = waiting[depth]
            if not _overlap(boxes, i, nodes, node):
                continue
            if node < leaves:
                # what lies wholly before box i has met it already
                for child in (2 * node, 2 * node + 1):
                    if _last_leaf(child, leaves) >= i // LEAF:
                        waiting[depth] = child
                        depth += 1
                continue
            first = (node - leaves) * LEAF
            for j in range(max(first, i + 1), min(first + LEAF, len(boxes))):
                if _overlap(boxes, i, boxes, j):
                    if count == len(found):
                        found = np.concatenate((found, np.empty_like(found)))
                    found[count, 0], found[count, 1] = i, j
                    count += 1
    return found[:count]


@compiled
def _overlap(ones: Array, i: int, others: Array, j: int) -> bool:
    apart = False
    for axis in range(3):
        apart |= ones[i, axis] > others[j, axis + 3] or others[j, axis] > ones[i, axis + 3]
    return not apart


@compiled
def _last_leaf(node: int, leaves: int) -> int:
    """Number of the last leaf below a node."""
    while node < leaves:
        node = 2 * node + 1
    return node - leaves

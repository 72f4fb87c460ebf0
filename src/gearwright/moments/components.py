"""Parts of a polyhedron's boundary, each closed by itself: their boxes, and what they wind around.

`labels` (f,) are the numbers of the faces' parts, from 0.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..compiled import compiled

_BLOCK = 65536


@compiled
def component_boxes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, count: int) -> Array:
    """Bounding boxes (count, 2, 3) of the parts."""
    boxes = np.empty((count, 2, 3))
    boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
    for f in range(len(labels)):
        box = boxes[labels[f]]
        for c in range(offsets[f], offsets[f + 1]):
            for k in range(3):
                box[0, k] = min(box[0, k], vertices[indices[c], k])
                box[1, k] = max(box[1, k], vertices[indices[c], k])
    return boxes


def winding_number(point: Array, vertices: Array, triangles: Indices) -> float:
    """How often closed triangles (t, 3) wind around a point (3,): 1 inside an outward boundary, 0 outside.

    The solid angle they subtend over 4π; about ½ on the boundary itself.
    Source: van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983), eq. (8).
    """
    total = 0.0
    for start in range(0, len(triangles), _BLOCK):
        a, b, c = (vertices[triangles[start : start + _BLOCK, k]] - point for k in range(3))
        la, lb, lc = (np.linalg.norm(p, axis=1) for p in (a, b, c))
        above = np.einsum("ij,ij->i", a, np.cross(b - a, c - a))
        below = la * lb * lc + sum(np.einsum("ij,ij->i", p, q) * r for p, q, r in ((a, b, lc), (b, c, la), (c, a, lb)))
        total += float(np.arctan2(above, below).sum())
    return total / (2.0 * np.pi)

"""The sums of `kernels.sums` as the formulas say it, in a few lines of NumPy: what the kernels are held to."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from .compensated import compensated_sum
from .faces import face_vectors, fan_triangles
from .matrix import LEFT, RIGHT

_CYCLIC = ((1, 2, 0), (2, 0, 1), (0, 1, 2))


def reference_sums(vertices: Array, indices: Indices, offsets: Indices, origin: Array) -> Array:
    """The sums (16,) over polygon faces about an origin (3,): every term in plain arithmetic, added without loss."""
    triangles = fan_triangles(indices, offsets)
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    u, v = b - a, c - a
    a, b, c = a - origin, b - origin, c - origin
    s = a + b + c
    n = np.cross(u, v)
    d = np.sum(a * n, axis=1)
    second = np.sum([p[:, LEFT] * p[:, RIGHT] for p in (a, b, c, s)], axis=0)
    products = sum(np.abs(u[:, [i, j]] * v[:, [j, i]]).sum(axis=1) * np.abs(a[:, k]) for i, j, k in _CYCLIC)
    rows = [d, *(d * s.T), *(d * second.T), *n.T, 0.0 * d, products, products * second[:, :3].sum(axis=1)]
    sums = compensated_sum(np.array(rows))
    sums[13] = compensated_sum(2.0 * np.linalg.norm(face_vectors(vertices, indices, offsets), axis=1))
    return sums

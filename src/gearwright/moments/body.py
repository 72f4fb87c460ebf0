"""What every route to the moments of a body answers with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ..arrays import Array
from .matrix import central_second, shifted

Method = Literal["exact", "quadrature", "polyhedron"]


@dataclass(frozen=True, kw_only=True)
class BodyMoments:
    """The moments of a body about a point near its centroid.

    origin        (3,)    that point
    matrix        (4, 4)  moment matrix about it
    method        how they were found: "exact" (closed form or converged one-dimensional quadrature),
                  "quadrature" (boundary flux) or "polyhedron"
    error_bound   relative to the volume, and to the norm of the central second moment
    evaluations   how often a one-dimensional quadrature evaluated the motion; 0 for a closed form
    """

    origin: Array
    matrix: Array
    method: Method
    error_bound: float
    evaluations: int = 0

    @property
    def volume(self) -> float:
        return float(self.matrix[0, 0])

    @property
    def centroid(self) -> Array:
        return self.origin + self.matrix[0, 1:] / self.matrix[0, 0]

    @property
    def central_second(self) -> Array:
        return central_second(self.matrix)


def about_centroid(matrix: Array, method: Method, error: float, origin: Array | None = None) -> BodyMoments:
    """BodyMoments recentred on the body's own centroid from a moment matrix about `origin` (nought if None).

    error   relative error of the entries of the matrix

    The shift subtracts q qᵀ/V, into which the errors of V and q enter once more, from S; the bound grows by as
    much as that cancels.
    """
    centroid = matrix[0, 1:] / matrix[0, 0]
    centred = shifted(matrix, -centroid)
    loss = 4.0 * float(np.linalg.norm(matrix[1:, 1:]) / np.linalg.norm(centred[1:, 1:]))
    start = np.zeros(3) if origin is None else origin
    return BodyMoments(origin=start + centroid, matrix=centred, method=method, error_bound=error * max(1.0, loss))


def summed(parts: Sequence[BodyMoments]) -> BodyMoments:
    """The moments of bodies that do not overlap, all together: matrices add about their common centroid."""
    volumes = np.array([part.volume for part in parts])
    origin = volumes @ np.array([part.centroid for part in parts]) / volumes.sum()
    matrix = np.sum([shifted(part.matrix, part.origin - origin) for part in parts], axis=0)
    method: Method = "exact" if all(part.method == "exact" for part in parts) else "quadrature"
    found = about_centroid(matrix, method, max(part.error_bound for part in parts), origin)
    return replace(found, evaluations=sum(part.evaluations for part in parts))

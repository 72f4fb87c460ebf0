"""Rigid placements: where a body is put, without stretching or mirroring it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .arrays import Array, ArrayLike
from .errors import GeometryError, Problem

ORTHONORMAL = 1e-12
"""How far R Rᵀ may be from 1 where shapes are moved by R: what sixteen digits leave, so that nothing is bent."""

Row = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class Placement:
    """The map r → R r + t. `rotation` holds the rows of R, `translation` t; without either, nothing moves."""

    rotation: tuple[Row, Row, Row] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    translation: Row = (0.0, 0.0, 0.0)

    @classmethod
    def of(cls, rotation: ArrayLike, translation: ArrayLike = (0.0, 0.0, 0.0)) -> Placement:
        """From arrays R (3, 3) and t (3,), taken as they are."""
        first, second, third = (_row(row) for row in np.asarray(rotation, float))
        return cls(rotation=(first, second, third), translation=_row(np.asarray(translation, float)))

    @cached_property
    def matrix(self) -> Array:
        """R (3, 3)."""
        return np.array(self.rotation)

    @cached_property
    def shift(self) -> Array:
        """t (3,)."""
        return np.array(self.translation)

    def points(self, points: Array) -> Array:
        """Where points (..., 3) go."""
        return self.vectors(points) + self.shift

    def vectors(self, vectors: Array) -> Array:
        """How vectors (..., 3) are turned."""
        return vectors @ self.matrix.T

    def points_back(self, points: Array) -> Array:
        """Where points (..., 3) come from."""
        return self.vectors_back(points - self.shift)

    def vectors_back(self, vectors: Array) -> Array:
        """What vectors (..., 3) were before the turn."""
        return vectors @ self.matrix

    def after(self, first: Placement) -> Placement:
        """The placement that does another one first and then this one."""
        return Placement.of(self.matrix @ first.matrix, self.points(first.shift))

    @property
    def keeps_axis(self) -> bool:
        """Whether the z axis stays in itself and points the same way, so that turns about it stay such turns."""
        across = (*self.rotation[2][:2], self.rotation[0][2], self.rotation[1][2], *self.translation[:2])
        return not any(across) and self.rotation[2][2] > 0.0

    @property
    def flips_axis(self) -> bool:
        """Whether the z axis stays in itself but points the other way."""
        across = (*self.rotation[2][:2], self.rotation[0][2], self.rotation[1][2], *self.translation[:2])
        return not any(across) and self.rotation[2][2] < 0.0


def require_rotation(rotation: ArrayLike, within: float) -> Array:
    """The matrix (3, 3) if it is a right-handed rotation to within so much, entry by entry; else GeometryError."""
    try:
        matrix = np.array(rotation, dtype=float)
    except (TypeError, ValueError):
        matrix = np.empty(0)
    if matrix.shape != (3, 3):
        given, wanted = f"rotation of shape {matrix.shape}", "an array (3, 3) is needed"
    elif np.abs(matrix @ matrix.T - np.eye(3)).max() < within and np.linalg.det(matrix) > 0.0:
        return matrix
    else:
        given = f"rotation = {matrix.tolist()}"
        wanted = (
            f"a right-handed rotation is needed: orthonormal rows (to {within:g}), determinant +1; to mirror or scale,"
            " transform the body itself"
        )
    raise GeometryError("A body cannot be moved by this matrix", [Problem(given, wanted)])


def _row(values: Array) -> Row:
    x, y, z = (float(v) for v in values)
    return x, y, z

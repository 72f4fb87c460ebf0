"""Principal axes, settled where mathematics leaves a choice."""

from __future__ import annotations

import numpy as np

from ..arrays import Array

_EQUAL = 1e-12
"""Principal moments closer than this, relative to the largest, count as equal: their axes are free."""


def principal_axes(tensor: Array) -> Array:
    """Principal axes of a symmetric tensor as columns (3, 3), eigenvalues ascending.

    Right-handed. The largest component of each axis is positive as far as handedness allows: the first
    two columns (the first of equally large components counts), the third is their cross product. Where
    two moments are equal, their axes are those nearest to the frame's; where three are, the frame's.
    """
    values, vectors = np.linalg.eigh(tensor)
    gaps = np.diff(values) > _EQUAL * np.abs(values).max()
    if not gaps.any():
        return np.eye(3)
    if not gaps.all():
        alone = 0 if gaps[0] else 2
        vectors = _about(_settled(vectors[:, alone]), alone)
    first, second = _settled(vectors[:, 0]), _settled(vectors[:, 1])
    return np.stack([first, second, np.cross(first, second)], axis=1)


def _about(axis: Array, column: int) -> Array:
    """Frame whose one column is a given axis, its next the coordinate axis most across that, made normal."""
    across = np.eye(3)[np.argmin(np.round(np.abs(axis), 9))]
    across = across - (across @ axis) * axis
    across /= np.linalg.norm(across)
    third = np.cross(axis, across)
    columns = [axis, across, third] if column == 0 else [across, third, axis]
    return np.stack(columns, axis=1)


def _settled(axis: Array) -> Array:
    """The axis with its largest component positive."""
    size = np.abs(axis)
    leading = int(np.flatnonzero(size > size.max() * (1.0 - 1e-9))[0])
    return np.asarray(axis * np.sign(axis[leading]))

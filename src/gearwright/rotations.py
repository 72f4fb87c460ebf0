"""Rotations as matrices, unit quaternions, and turns about fixed axes."""

from __future__ import annotations

import numpy as np

from .arrays import Array, ArrayLike


def quaternion_of(rotation: ArrayLike) -> Array:
    """Unit quaternion (w, x, y, z), w ≥ 0, of a rotation matrix (3, 3): p ↦ R p.

    Where w is nought, the first component that is not is positive. It is the eigenvector of the symmetric matrix that
    R gives, to its largest eigenvalue: no component is divided by a small one.
    Source: Bar-Itzhack, J. Guid. Control Dyn. 23 (2000).
    """
    r = np.asarray(rotation, float)
    across = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    form = np.empty((4, 4))
    form[0, 0] = np.trace(r)
    form[0, 1:] = form[1:, 0] = across
    form[1:, 1:] = r + r.T - np.trace(r) * np.eye(3)
    quaternion = np.linalg.eigh(form)[1][:, -1]
    quaternion = np.where(np.abs(quaternion) < _NOUGHT, 0.0, quaternion)
    quaternion *= np.sign(quaternion[np.flatnonzero(quaternion)[0]])
    return np.asarray(quaternion / np.linalg.norm(quaternion) + 0.0)


def rotation_of(quaternion: ArrayLike) -> Array:
    """Rotation matrix (3, 3) of a quaternion (w, x, y, z) that is not nought; its length does not matter."""
    given = np.asarray(quaternion, float)
    w, x, y, z = given / np.linalg.norm(given)
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


def roll_pitch_yaw(rotation: ArrayLike) -> Array:
    """Turns about the fixed axes x, then y, then z, radians: R = Rz(yaw) Ry(pitch) Rx(roll).

    Where pitch is ±90°, roll is 0.
    """
    r = np.asarray(rotation, float)
    along = float(np.hypot(r[2, 1], r[2, 2]))
    pitch = float(np.arctan2(-r[2, 0], along))
    if along < _NOUGHT:
        return np.array([0.0, pitch, float(np.arctan2(-r[0, 1], r[1, 1]))])
    return np.array([float(np.arctan2(r[2, 1], r[2, 2])), pitch, float(np.arctan2(r[1, 0], r[0, 0]))])


_NOUGHT = 1e-15
"""What rounding leaves of a component that is nought."""

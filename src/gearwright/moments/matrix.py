"""The moment matrix: volume, first and second moments of a body in one symmetric matrix.

    M = ∫ h hᵀ dV,  h = (1, x, y, z):   M = [V qᵀ; q S]

It is additive over disjoint bodies and follows an affine map r → A r + t by eq. (M1),
M′ = |det A| T M Tᵀ with T = [1 0; t A]: parallel axes, rotation, scaling and mirroring in one line.
Sources: Al-Daccak 1989, eqs. (4.4), (5.1), in homogeneous form. All functions also take the 3×3
matrix of a plane region and stacks of matrices on leading axes.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, ArrayLike


def moment_matrix(volume: ArrayLike, first: ArrayLike, second: ArrayLike) -> Array:
    """The (d+1, d+1) matrix [V qᵀ; q S] from V (), q (d,) and S = ∫ r rᵀ dV (d, d)."""
    first = np.asarray(first, float)
    d = first.shape[-1]
    matrix = np.empty((*first.shape[:-1], d + 1, d + 1))
    matrix[..., 0, 0] = volume
    matrix[..., 0, 1:] = matrix[..., 1:, 0] = first
    matrix[..., 1:, 1:] = second
    return matrix


LEFT, RIGHT = np.array([0, 1, 2, 0, 1, 2]), np.array([0, 1, 2, 1, 2, 0])
"""Rows and columns of the six components xx yy zz xy yz zx."""


def symmetric(components: Array) -> Array:
    """The symmetric tensor (3, 3) of its components xx yy zz xy yz zx (6,)."""
    tensor = np.empty((3, 3))
    tensor[LEFT, RIGHT] = tensor[RIGHT, LEFT] = components
    return tensor


def affine(linear: ArrayLike, translation: ArrayLike) -> Array:
    """T = [1 0; t A] of the map r → A r + t, for A (d, k) and t (d,)."""
    linear = np.asarray(linear, float)
    matrix = np.zeros((*linear.shape[:-2], linear.shape[-2] + 1, linear.shape[-1] + 1))
    matrix[..., 0, 0] = 1.0
    matrix[..., 1:, 0] = translation
    matrix[..., 1:, 1:] = linear
    return matrix


def transformed(matrix: Array, linear: ArrayLike, translation: ArrayLike = 0.0) -> Array:
    """Moments of the body mapped by r → A r + t, A (d, d): eq. (M1), with |det A|."""
    map_ = affine(linear, translation)
    scale = np.abs(np.linalg.det(np.asarray(linear, float)))[..., None, None]
    return scale * (map_ @ matrix @ np.swapaxes(map_, -1, -2))


def shifted(matrix: Array, translation: ArrayLike) -> Array:
    """Moments of the body moved by a translation (d,)."""
    map_ = affine(np.eye(matrix.shape[-1] - 1), translation)
    return map_ @ matrix @ map_.T


def patterned(matrix: Array, order: int) -> Array:
    """Moments about the origin of `order` copies of a body, turned about z by equal steps of 2π/order.

    Exact zeros stay exact: for order ≥ 3 only V, q_z, S_zz and S_xx = S_yy survive.
    """
    if order == 1:
        return matrix
    axial = np.isin(np.arange(matrix.shape[-1]), (1, 2), invert=True)
    result = np.where(np.outer(axial, axial), order * matrix, 0.0)
    if order == 2:
        result[..., 1:3, 1:3] = 2.0 * matrix[..., 1:3, 1:3]
    else:
        result[..., 1, 1] = result[..., 2, 2] = order * (matrix[..., 1, 1] + matrix[..., 2, 2]) / 2.0
    return result


def central_second(matrix: Array) -> Array:
    """Second moment about the centroid, S − q qᵀ/V.

    Take the matrix about a point near the centroid, or this difference loses digits.
    """
    first = matrix[..., 1:, 0]
    centroid = first / matrix[..., 0, 0, None]
    return matrix[..., 1:, 1:] - first[..., :, None] * centroid[..., None, :]


def inertia_tensor(second: ArrayLike) -> Array:
    """I = tr(S) 1 − S (3, 3): the off-diagonals are minus the products ∫xy, ∫yz, ∫zx."""
    second = np.asarray(second, float)
    inertia = -second
    for k, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):  # the trace without its k-th term, which may be the largest
        inertia[..., k, k] = second[..., i, i] + second[..., j, j]
    return inertia

"""Moments of a plane region from its smooth boundary, without any polygon.

By the divergence theorem, for every parametrised boundary and a + b ≤ 3,

    ∫ x^a y^b dA = 1/(a+b+2) ∮ x^a y^b (x dy − y dx),

and on analytic arcs Gauss–Legendre quadrature converges exponentially. The moments are taken in the
complex form μ_jk = ∫ z^j z̄^k dA, z = x + iy, in which a turn by φ multiplies μ_jk by e^{i(j−k)φ}: the
sum over N equal turns is N μ_jk where N divides j − k and exactly nought elsewhere.
Source: Al-Daccak 1989, eqs. (4.5)–(4.12), there for polygons.
"""

from __future__ import annotations

from math import comb

import numpy as np

from ..arrays import Array

HIGHEST_ORDER = 3


def plane_moments(points: Array, tangents: Array, order: int = 1) -> Array:
    """m[a, b] = ∫ x^a y^b dA (..., 4, 4) for a + b ≤ 3, nought elsewhere.

    points, tangents   (..., n, 2)  nodes of the boundary and weighted tangents, counter-clockwise
    order              the whole boundary is this many turns about the origin of the part given
    """
    z = points[..., 0] + 1j * points[..., 1]
    dz = tangents[..., 0] + 1j * tangents[..., 1]
    weight = (np.conj(z) * dz).imag
    complex_moments = np.zeros((*z.shape[:-1], HIGHEST_ORDER + 1, HIGHEST_ORDER + 1), complex)
    for j in range(HIGHEST_ORDER + 1):
        for k in range(HIGHEST_ORDER + 1 - j):
            if (j - k) % order == 0:
                integral = np.sum(z**j * np.conj(z) ** k * weight, axis=-1)
                complex_moments[..., j, k] = order * integral / (j + k + 2)
    return _real_moments(complex_moments)


def _real_moments(complex_moments: Array) -> Array:
    """∫ x^a y^b dA from ∫ z^j z̄^k dA (..., 4, 4), with x = (z + z̄)/2 and y = (z − z̄)/2i."""
    moments = np.zeros(complex_moments.shape)
    for a in range(HIGHEST_ORDER + 1):
        for b in range(HIGHEST_ORDER + 1 - a):
            total = 0j
            for p in range(a + 1):
                for q in range(b + 1):
                    sign = (-1) ** (b - q)
                    total = total + comb(a, p) * comb(b, q) * sign * complex_moments[..., p + q, a + b - p - q]
            moments[..., a, b] = (total / (2**a * (2j) ** b)).real
    return moments


def moment_matrix_2d(moments: Array) -> Array:
    """The 3×3 moment matrix with h = (1, x, y) from m[a, b]."""
    m = moments
    return np.array([[m[0, 0], m[1, 0], m[0, 1]], [m[1, 0], m[2, 0], m[1, 1]], [m[0, 1], m[1, 1], m[0, 2]]])

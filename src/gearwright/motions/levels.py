"""Moments of a body made of levels about an apex, each of which a section of the unit sphere covers in part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..arrays import Array
from ..moments.body import BodyMoments, about_centroid
from ..moments.matrix import affine
from ..moments.quadrature import converged, gauss_legendre
from ..moments.sphere import level_region_moments
from ..sections.members import member_quadrature
from ..sections.sphere import SphericalSection

_DEGREE = 3 + np.add.outer([0, 1, 1, 1], [0, 1, 1, 1])
"""The power of the distance that an entry of the moment matrix about the apex grows with."""


def level_moments(section: SphericalSection, levels: float | None, start: float, finish: float) -> BodyMoments:
    """The moments between two levels (see `Radial`) where turning the section about z does not change them.

    M = ∫ n v^(n−1) K(v) dv with the moments K of what lies below the level at v = 1, n the degree of each entry; of
    a section that varies, K is its member's. Source: the divergence theorem about the apex; theory of (S2).
    """
    if not section.varies:
        (unit,), error = _unit_moments(section, levels, np.array([start]))
        return about_centroid(unit * _power_difference(start, finish), "exact", error)
    errors, evaluations = [section.moments_error], 0

    def matrix(nodes: int) -> Array:
        nonlocal evaluations
        evaluations += nodes
        x, w = gauss_legendre(nodes)
        v = (start + finish) / 2.0 + (finish - start) / 2.0 * x
        units, error = _unit_moments(section, levels, v)
        errors.append(error)
        weights = _DEGREE * (v[:, None, None] / finish) ** (_DEGREE - 1) * (w * (finish - start) / 2.0)[:, None, None]
        return np.asarray(np.sum(weights / finish * units, axis=0))

    scaled, error = converged(matrix)
    unit = affine(finish * np.eye(3), np.zeros(3))
    body = about_centroid(finish**3 * (unit @ scaled @ unit.T), "exact", error + max(errors))
    return replace(body, evaluations=evaluations)


def _unit_moments(section: SphericalSection, levels: float | None, v: Array) -> tuple[Array, float]:
    """Moments (n, 4, 4) below the level at 1 that the members at parameters (n,) cover, and their relative error."""

    def integral(nodes: int) -> Array:
        parts = [(*member_quadrature(loop, v, nodes), loop.copies) for loop in section.loops]
        return level_region_moments(parts, levels)

    return converged(integral)


def _power_difference(start: float, finish: float) -> Array:
    """finish^n − start^n (4, 4) for the degree n of each entry, as a product, in which the width keeps its digits."""
    terms = sum(np.where(k < _DEGREE, finish ** (_DEGREE - 1.0 - k) * start**k, 0.0) for k in range(5))
    return np.asarray((finish - start) * terms)

"""Signed volumes of the parts of a polyhedron's boundary: their signs are right however thin the parts are.

The fans are those of `polyhedron`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..compiled import compiled
from .kernels.pairs import Pair, two_product, two_sum

_ROUNDOFF = 2.0**-53

_TERM_ROUNDINGS = 16.0
"""Roundings in a triangle's term, of its magnitude each; the sum adds one for every triangle before it."""


def component_volumes(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, origins: Array) -> Array:
    """Signed volumes (k,), each about a point of its own (k, 3): to plain precision, but never of the wrong sign.

    labels   (f,) numbers of the faces' parts, from 0

    Where the terms cancel so far that rounding might hide the sign, they are summed again in doubled arithmetic; what
    is less than its rounding, too, is 0. No product of three lengths may overflow.
    """
    volumes, magnitudes, counts = _plain(vertices, indices, offsets, labels, origins)
    unsure = np.abs(volumes) <= (_TERM_ROUNDINGS + counts) * _ROUNDOFF * magnitudes
    if unsure.any():
        doubled = _doubled(vertices, indices, offsets, labels, origins, unsure)
        # each operation on pairs loses a few units of 2⁻¹⁰⁴
        lost = (_TERM_ROUNDINGS + counts) * 32.0 * _ROUNDOFF**2 * magnitudes
        volumes[unsure] = np.where(np.abs(doubled) > lost, doubled, 0.0)[unsure]
    return volumes


@compiled
def _plain(
    vertices: Array, indices: Indices, offsets: Indices, labels: Indices, origins: Array
) -> tuple[Array, Array, Array]:
    """Volumes (k,), the sums of the magnitudes of all products in them (k,), and how many triangles these have (k,)."""
    volumes, magnitudes, counts = np.zeros(len(origins)), np.zeros(len(origins)), np.zeros(len(origins))
    for f in range(len(labels)):
        part = labels[f]
        counts[part] += offsets[f + 1] - offsets[f] - 2
        a, o = vertices[indices[offsets[f]]], origins[part]
        px, py, pz = a[0] - o[0], a[1] - o[1], a[2] - o[2]
        b = vertices[indices[offsets[f] + 1]]
        ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        for corner in range(offsets[f] + 2, offsets[f + 1]):
            c = vertices[indices[corner]]
            vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
            yz, zy, zx, xz, xy, yx = uy * vz, uz * vy, uz * vx, ux * vz, ux * vy, uy * vx
            volumes[part] += (px * (yz - zy) + py * (zx - xz) + pz * (xy - yx)) / 6.0
            magnitudes[part] += (
                abs(px) * (abs(yz) + abs(zy)) + abs(py) * (abs(zx) + abs(xz)) + abs(pz) * (abs(xy) + abs(yx))
            ) / 6.0
            ux, uy, uz = vx, vy, vz
    return volumes, magnitudes, counts


@compiled
def _doubled(
    vertices: Array, indices: Indices, offsets: Indices, labels: Indices, origins: Array, wanted: NDArray[np.bool_]
) -> Array:
    """Volumes (k,) of the parts that are wanted (k,), in doubled arithmetic."""
    high, low = np.zeros(len(origins)), np.zeros(len(origins))
    for f in range(len(labels)):
        part = labels[f]
        if not wanted[part]:
            continue
        a = vertices[indices[offsets[f]]]
        for corner in range(offsets[f] + 1, offsets[f + 1] - 1):
            b, c = vertices[indices[corner]], vertices[indices[corner + 1]]
            for x in range(3):
                y, z = (x + 1) % 3, (x + 2) % 3
                first = _product(two_sum(b[y], -a[y]), two_sum(c[z], -a[z]))
                second = _product(two_sum(b[z], -a[z]), two_sum(c[y], -a[y]))
                normal = _sum(first, (-second[0], -second[1]))
                term = _product(two_sum(a[x], -origins[part, x]), normal)
                high[part], low[part] = _sum((high[part], low[part]), term)
    return (high + low) / 6.0


@compiled
def _sum(a: Pair, b: Pair) -> Pair:
    total, lost = two_sum(a[0], b[0])
    below, lost_below = two_sum(a[1], b[1])
    total, lost = two_sum(total, lost + below)
    total, lost = two_sum(total, lost + lost_below)
    return total, lost


@compiled
def _product(a: Pair, b: Pair) -> Pair:
    high, low = two_product(a[0], b[0])
    return two_sum(high, low + (a[0] * b[1] + a[1] * b[0]))

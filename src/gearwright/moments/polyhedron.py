"""Volume, first and second moments of a polyhedron with any planar polygon faces.

The body is a signed sum of tetrahedra over fans of its faces from an origin o. With a, b, c the
corners relative to o, d = a · (b × c) and s = a + b + c:

    V = Σ d/6,   q = Σ d s/24,   S = Σ d (aaᵀ + bbᵀ + ccᵀ + ssᵀ)/120

Three things keep this at machine precision wherever the body lies: an origin among its corners,
d from edge differences, and compensated sums. What remains is cancellation between the tetrahedra:
thin shells, bodies far apart, a heavy end on a long thin one. It is measured (`amplification`, the
sum of the terms' magnitudes over the result), and where it would cost digits the sums are done again
about the centroid in doubled arithmetic. An origin for each connected component would repair only
bodies far apart; doubled arithmetic repairs every case that float64 coordinates can express, since
they cannot express more cancellation than about 1e16.

Source: Al-Daccak 1989, eqs. (4.13)–(4.27), there by faces and edges.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Array, Indices
from .body import BodyMoments
from .indexed import Polygons, Source, Triangles, middle
from .matrix import moment_matrix, symmetric
from .summation import Sums

AMPLIFICATION_LIMIT = 8.0
"""Cancellation up to which plain arithmetic is kept: it then costs less than one digit of sixteen."""

CLOSED = 1e-9
"""Closure residual up to which a boundary counts as closed; a hole leaves its share of the area."""

_ROUNDOFF = 2.0**-53
_PLAIN = 48.0 * _ROUNDOFF
"""Relative error of a sum whose terms do not cancel: 32 additions in each lane and the roundings of a term."""

TINY = 1e-280
"""Sums below this may have lost digits to underflow: lengths are scaled first."""

_FACTORS = np.array([1 / 6] + 3 * [1 / 24] + 6 * [1 / 120])


@dataclass(frozen=True, kw_only=True, eq=False)
class PolyhedronMoments:
    """Moments of a polyhedron, and what the sums show of its boundary.

    body           moments about a point near the centroid
    area           surface area
    closure        |Σ n A| / Σ A over the faces: about 1e-17 for a closed boundary
    amplification  cancellation between and inside the terms, Σ|term| / |Σ term|: the larger of that of V and of S
    """

    body: BodyMoments
    area: float
    closure: float
    amplification: float


def polyhedron_moments(
    vertices: Array, indices: Indices, offsets: Indices, *, threads: int | None = None
) -> PolyhedronMoments:
    """Moments of the body bounded by the faces, to about 1e-16 relative at any distance from the origin.

    vertices          (n, 3); those that no face uses do not matter
    indices, offsets  the faces as in `faces`: any planar polygons, counter-clockwise seen from outside
    threads           None for as many as there are processors; one where there are few faces

    The faces must close; nothing is checked here, but `closure` shows it if they do not. A face that
    is not planar is taken as the fan from its first corner.
    Raises GeometryError if a face has fewer than three corners or names a vertex that is not there.
    """
    source: Source
    if len(indices) == 3 * (len(offsets) - 1) and np.all(np.diff(offsets) == 3):
        source = Triangles(vertices=vertices, triangles=indices.reshape(-1, 3), threads=threads)
    else:
        source = Polygons(vertices=vertices, indices=indices, offsets=offsets, threads=threads)
    origin = middle(vertices, indices)
    return settled(source, origin, source.sums(origin))


def settled(source: Source, origin: Array, found: Sums) -> PolyhedronMoments:
    """Moments from the sums in plain arithmetic about an origin; where they cancel, done again in doubled."""
    sums = found.rounded
    if not np.all(np.isfinite(sums)) or min(abs(sums[0]), sums[15]) < TINY:
        box = source.box
        scale = _scale(box)
        if scale != 1.0 and np.all(np.isfinite(box)):
            return _of_another_size(source.scaled(scale), origin * scale, 1.0 / scale)
    body, magnitudes = sums[:10] * _FACTORS, sums[14:] * _FACTORS[[0, 4]]
    amplification = _amplification(body, magnitudes)
    error_bound = _PLAIN * amplification
    if not amplification <= AMPLIFICATION_LIMIT:
        origin = _centroid_within(source.box, origin, body)
        body = source.doubled(origin).rounded[:10] * _FACTORS
        amplification = _amplification(body, magnitudes)
        error_bound = 16.0 * _ROUNDOFF * (1.0 + 64.0 * _ROUNDOFF * amplification)
    return PolyhedronMoments(
        body=BodyMoments(
            origin=origin,
            matrix=moment_matrix(body[0], body[1:4], symmetric(body[4:])),
            method="polyhedron",
            error_bound=error_bound,
        ),
        area=float(sums[13]) / 2.0,
        closure=float(np.linalg.norm(sums[10:13]) / sums[13]) if sums[13] else 0.0,
        amplification=amplification,
    )


def _scale(box: Array) -> float:
    """A power of two that makes lengths about 1: exact, and nothing overflows or vanishes."""
    _, exponent = np.frexp(np.max(box[1] - box[0]))
    return float(np.ldexp(1.0, -int(exponent)))


def _of_another_size(source: Source, origin: Array, length: float) -> PolyhedronMoments:
    """Moments of a body as large as `length` times that of the source."""
    found = settled(source, origin, source.sums(origin))
    powers = length ** np.array([[3, 4, 4, 4], *([[4, 5, 5, 5]] * 3)])
    body = replace(found.body, origin=found.body.origin * length, matrix=found.body.matrix * powers)
    return replace(found, body=body, area=found.area * length**2)


def _amplification(sums: Array, magnitudes: Array) -> float:
    """How much larger the terms are than what is left of them, in V and in the trace of the central S."""
    volume, first, spread = sums[0], sums[1:4], sums[4:7].sum()
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratios = magnitudes / np.abs([volume, spread - first @ first / volume])
    return float(np.max(np.where(np.isnan(ratios), np.inf, ratios)))


def _centroid_within(box: Array, origin: Array, sums: Array) -> Array:
    """Centroid as far as plain arithmetic knows it, kept inside the box where it knows nothing."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        centroid = origin + sums[1:4] / sums[0]
    return np.clip(np.where(np.isfinite(centroid), centroid, origin), box[0], box[1])

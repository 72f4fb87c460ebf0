"""Volume, first and second moments of a polyhedron with any planar polygon faces.

The body is a signed sum of tetrahedra over fans of its faces from an origin o. With a, b, c the
corners relative to o, d = a · (b × c) and s = a + b + c:

    V = Σ d/6,   q = Σ d s/24,   S = Σ d (aaᵀ + bbᵀ + ccᵀ + ssᵀ)/120

Three things keep this at machine precision wherever the body lies: an origin inside the bounding box,
d from edge differences, and compensated sums. What remains is cancellation between the tetrahedra:
thin shells, bodies far apart, a heavy end on a long thin one. It is measured (`amplification`, the
sum of the terms' magnitudes over the result), and where it would cost digits the sums are done again
about the centroid in doubled arithmetic. An origin for each connected component would repair only
bodies far apart; doubled arithmetic repairs every case that float64 coordinates can express, since
they cannot express more cancellation than about 1e16.

Source: Al-Daccak 1989, eqs. (4.13)–(4.27), there by faces and edges.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike, Indices
from ..errors import GeometryError, Problem
from . import compensated
from .body import BodyMoments
from .compensated import Doubled, RunningSum
from .faces import Faces, corner_lists, face_vectors, fan_triangles
from .matrix import inertia_tensor, moment_matrix

AMPLIFICATION_LIMIT = 8.0
"""Cancellation up to which plain arithmetic is kept: it then costs less than one digit of sixteen."""

CLOSED = 1e-9
"""Closure residual up to which a boundary counts as closed; a hole leaves its share of the area."""

_ROUNDOFF = 2.0**-53
_PLAIN_BLOCK = 8192
_DOUBLED_BLOCK = 2048
# rows of the sums: d, then d s, then d (…) for xx yy zz xy yz zx
_ROWS = 10
_LEFT = np.array([0, 1, 2, 0, 1, 2])
_RIGHT = np.array([0, 1, 2, 1, 2, 0])
_FACTORS = np.array([1 / 6] + 3 * [1 / 24] + 6 * [1 / 120])


@dataclass(frozen=True, kw_only=True, eq=False)
class PolyhedronMoments:
    """Moments of a polyhedron, and what the sums show of its boundary.

    body           moments about a point near the centroid
    area           surface area
    closure        |Σ n A| / Σ A over the faces: about 1e-17 for a closed boundary
    bounding_box   (2, 3) lowest and highest coordinates
    amplification  cancellation between the terms, Σ|term| / |Σ term|: the larger of that of V and of S
    """

    body: BodyMoments
    area: float
    closure: float
    bounding_box: Array
    amplification: float


def mass_properties(vertices: ArrayLike, faces: Faces, density: float = 1.0) -> tuple[float, Array, Array]:
    """Mass, centroid (3,) and inertia tensor about the centroid (3, 3): no object, no topology checks.

    vertices  (n, 3)
    faces     (m, k) integers, or lists of any lengths: any planar polygons, counter-clockwise from outside
    density   mass per cubed length unit

    Off-diagonals of the inertia are minus the products. Only the closure residual is checked: use
    Polyhedron where flipped faces and holes are to be found and named.
    Raises GeometryError if the density is not positive, or the faces do not close, turn inward, or name
    vertices that are not there.
    """
    if not 0.0 < density < np.inf:
        problem = Problem(f"density = {density!r}", "a positive number is needed: mass per cubed length unit")
        raise GeometryError("These faces have no mass", [problem])
    points = np.asarray(vertices, float)
    indices, offsets = corner_lists(faces)
    _require_corners(points, indices, offsets)
    moments = polyhedron_moments(points, indices, offsets)
    if not (moments.closure <= CLOSED and moments.body.volume > 0.0):
        raise GeometryError(
            "These faces do not bound a solid",
            [
                Problem(
                    f"closure residual {moments.closure:.2g}, volume {moments.body.volume:.6g}",
                    "a residual near 0 and a positive volume are needed; usual causes are missing faces and faces"
                    " turned inward; Polyhedron(vertices, faces).validity() names them",
                )
            ],
        )
    body = moments.body
    return density * body.volume, body.centroid, density * inertia_tensor(body.central_second)


def _require_corners(points: Array, indices: Indices, offsets: Indices) -> None:
    in_range = not len(indices) or (indices.min() >= 0 and indices.max() < len(points))
    if points.ndim != 2 or points.shape[1] != 3 or not in_range or np.any(np.diff(offsets) < 3):
        raise GeometryError(
            "These arrays are not a polyhedron",
            [
                Problem(
                    f"vertices {points.shape}, {len(offsets) - 1} faces",
                    "vertices (n, 3) and faces of at least 3 vertex numbers from 0 to n − 1 are needed;"
                    " Polyhedron(vertices, faces) says which are wrong",
                )
            ],
        )


def polyhedron_moments(vertices: Array, indices: Indices, offsets: Indices) -> PolyhedronMoments:
    """Moments of the body bounded by the faces, to about 1e-16 relative at any distance from the origin.

    vertices          (n, 3); those that no face uses do not matter
    indices, offsets  the faces as in `faces`: any planar polygons, counter-clockwise seen from outside

    The faces must close; nothing is checked here, but `closure` shows it if they do not. A face that
    is not planar is taken as the fan from its first corner.
    """
    triangles = fan_triangles(indices, offsets)
    box = bounding_box(vertices, indices)
    origin = box[0] + (box[1] - box[0]) / 2.0
    _, exponent = np.frexp(np.max(box[1] - box[0]))
    scale = float(np.ldexp(1.0, -int(exponent)))
    sums, magnitudes = _plain_sums(vertices, triangles, origin, scale)
    amplification = _amplification(sums, magnitudes)
    error_bound = 16.0 * _ROUNDOFF * amplification
    if not amplification <= AMPLIFICATION_LIMIT:
        origin = _centroid_within(box, origin, sums, scale)
        sums = _doubled_sums(vertices, triangles, origin, scale)
        amplification = _amplification(sums, magnitudes)
        error_bound = 16.0 * _ROUNDOFF * (1.0 + 64.0 * _ROUNDOFF * amplification)
    areas = face_vectors(vertices, indices, offsets)
    area = float(np.linalg.norm(areas, axis=-1).sum())
    return PolyhedronMoments(
        body=BodyMoments(
            origin=origin, matrix=_matrix(sums, 1.0 / scale), method="polyhedron", error_bound=error_bound
        ),
        area=area,
        closure=float(np.linalg.norm(compensated.compensated_sum(areas.T))) / area if area else 0.0,
        bounding_box=box,
        amplification=amplification,
    )


def bounding_box(vertices: Array, indices: Indices) -> Array:
    """Lowest and highest coordinates (2, 3) of the vertices that faces use."""
    used = np.zeros(len(vertices), dtype=bool)
    used[indices] = True
    points = vertices if used.all() else vertices[used]
    return np.stack([points.min(axis=0), points.max(axis=0)]) if len(points) else np.zeros((2, 3))


def _amplification(sums: Array, magnitudes: Array) -> float:
    """How much larger the terms are than what is left of them, in V and in the trace of the central S."""
    volume, first, spread = sums[0], sums[1:4], sums[4:7].sum()
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = magnitudes / np.abs([volume, spread - first @ first / volume])
    return float(np.max(np.where(np.isnan(ratios), np.inf, ratios)))


def _centroid_within(box: Array, origin: Array, sums: Array, scale: float) -> Array:
    """Centroid as far as plain arithmetic knows it, kept inside the box where it knows nothing."""
    with np.errstate(divide="ignore", invalid="ignore"):
        centroid = origin + sums[1:4] / sums[0] / scale
    return np.clip(np.where(np.isfinite(centroid), centroid, origin), box[0], box[1])


def _matrix(sums: Array, length: float) -> Array:
    second = np.empty((3, 3))
    second[_LEFT, _RIGHT] = second[_RIGHT, _LEFT] = sums[4:] * length**5
    return moment_matrix(sums[0] * length**3, sums[1:4] * length**4, second)


def _plain_sums(vertices: Array, triangles: Indices, origin: Array, scale: float) -> tuple[Array, Array]:
    """Sums (10,) about the origin in plain arithmetic, and the sums of magnitudes (2,) for V and tr S.

    Lengths are in units of 1/scale, a power of two: exact, and nothing overflows or vanishes.
    """
    local = np.ascontiguousarray((vertices - origin).T) * scale
    total = RunningSum((_ROWS, min(_PLAIN_BLOCK, len(triangles))))
    magnitudes = np.zeros(2)
    for start in range(0, len(triangles), _PLAIN_BLOCK):
        block = triangles[start : start + _PLAIN_BLOCK]
        a, b, c = (np.take(local, block[:, k], axis=1) for k in range(3))
        u, v, s = b - a, c - a, a + b + c
        d = np.zeros(len(block))
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            d += a[k] * (u[i] * v[j] - u[j] * v[i])
        terms = np.empty((_ROWS, len(block)))
        terms[0] = 1.0
        terms[1:4] = s
        terms[4:] = sum(p[_LEFT] * p[_RIGHT] for p in (a, b, c, s))
        magnitudes += np.abs(d).sum(), np.abs(d) @ terms[4:7].sum(axis=0)
        total.take(terms * d)
    return total.total() * _FACTORS, magnitudes * _FACTORS[[0, 4]]


def _doubled_sums(vertices: Array, triangles: Indices, origin: Array, scale: float) -> Array:
    """The same sums in doubled arithmetic: differences of coordinates are exact, the rest is to 1e-31."""
    columns = np.ascontiguousarray(vertices.T)
    total = RunningSum((_ROWS, min(_DOUBLED_BLOCK, len(triangles))))
    for start in range(0, len(triangles), _DOUBLED_BLOCK):
        block = triangles[start : start + _DOUBLED_BLOCK]
        corners = [np.take(columns, block[:, k], axis=1) for k in range(3)]
        a = _difference(corners[0], origin[:, None], scale)
        u, v = (_difference(corner, corners[0], scale) for corner in corners[1:])
        b, c = compensated.add(a, u), compensated.add(a, v)
        s = compensated.add(compensated.add(a, b), c)
        second = _squares(a)
        for p in (b, c, s):
            second = compensated.add(second, _squares(p))
        d = _triple_product(a, u, v)
        first = compensated.multiply(s, d)
        second = compensated.multiply(second, d)
        total.take(*(np.concatenate([d[k], first[k], second[k]]) for k in range(2)))
    return np.asarray(total.total() * _FACTORS)


def _difference(x: Array, y: Array, scale: float) -> Doubled:
    high, low = compensated.two_sum(x, -y)
    return high * scale, low * scale


def _squares(p: Doubled) -> Doubled:
    """xx, yy, zz, xy, yz, zx of points (3, n), as (6, n)."""
    return compensated.multiply((p[0][_LEFT], p[1][_LEFT]), (p[0][_RIGHT], p[1][_RIGHT]))


def _triple_product(a: Doubled, u: Doubled, v: Doubled) -> Doubled:
    """a · (u × v) of vectors (3, n), as (1, n)."""
    (u1, v1), (u2, v2) = (tuple((p[0][rows], p[1][rows]) for p in (u, v)) for rows in ([1, 2, 0], [2, 0, 1]))
    normal = compensated.subtract(compensated.multiply(u1, v2), compensated.multiply(u2, v1))
    x, y, z = ((part[0][k : k + 1], part[1][k : k + 1]) for part in [compensated.multiply(a, normal)] for k in range(3))
    return compensated.add(compensated.add(x, y), z)

"""Area, first and second moments of a surface of planar polygon faces, closed or open.

With the corners a, b, c of a triangle, s = a + b + c and its area A, signed against the normal of its face:

    ∫ dA = A,   ∫ r dA = A s/3,   ∫ r rᵀ dA = A (aaᵀ + bbᵀ + ccᵀ + ssᵀ)/12

over the fans of the faces: where a triangle leaves a face that is not convex, others of the opposite sign cancel it.
The sums are done twice, about the middle of the bounding box and then about the centroid, so that the central moment
is no difference of large numbers: all of its terms are positive but those of such triangles.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Indices
from .compensated import RunningSum
from .faces import face_vectors, fan_triangles, triangle_vectors
from .indexed import bounding_box
from .matrix import LEFT, RIGHT, central_second, moment_matrix, symmetric

_ROUNDOFF = 2.0**-53
_BLOCK = 8192
_ROWS = 10  # rows of the sums: A, then A s, then A (…) for xx yy zz xy yz zx
_FACTORS = np.array([1.0] + 3 * [1 / 3] + 6 * [1 / 12])


@dataclass(frozen=True, kw_only=True, eq=False)
class SurfaceMoments:
    """Moments of a surface.

    area            ∫ dA
    centroid        (3,) of the surface; the middle of the bounding box where there is no area
    central_second  (3, 3) ∫ r rᵀ dA about it
    bounding_box    (2, 3) lowest and highest coordinates
    error_bound     relative to the area, and to the norm of the central second moment
    """

    area: float
    centroid: Array
    central_second: Array
    bounding_box: Array
    error_bound: float


def surface_moments(vertices: Array, indices: Indices, offsets: Indices) -> SurfaceMoments:
    """Moments of the surface that the faces make, to about 1e-16 relative at any distance from the origin.

    vertices          (n, 3); those that no face uses do not matter
    indices, offsets  the faces as in `faces`: any planar polygons, of any orientation
    """
    triangles = fan_triangles(indices, offsets)
    box = bounding_box(vertices, indices)
    middle = box[0] + (box[1] - box[0]) / 2.0
    _, exponent = np.frexp(np.max(box[1] - box[0]))
    length = float(np.ldexp(1.0, int(exponent)))  # a power of two: exact, and nothing overflows
    scaled = (vertices - middle) / length
    # of the vertices as they stand: their differences are exact, those of rounded ones are not
    areas, uncertain = _signed_areas(vertices / length, triangles, indices, offsets)
    total, first, _ = _sums(scaled, triangles, areas)
    if not total > 0.0:
        return SurfaceMoments(
            area=0.0, centroid=middle, central_second=np.zeros((3, 3)), bounding_box=box, error_bound=0.0
        )
    centroid = middle + length * first / total
    local = (vertices - centroid) / length
    total, first, second = _sums(local, triangles, areas)
    central = central_second(moment_matrix(total, first, second))
    return SurfaceMoments(
        area=total * length**2,
        centroid=centroid + length * first / total,
        central_second=central * length**4,
        bounding_box=box,
        error_bound=_error_bound(local, triangles, uncertain, total, float(np.trace(central))),
    )


def _signed_areas(points: Array, triangles: Indices, indices: Indices, offsets: Indices) -> tuple[Array, Array]:
    """Areas (t,) of triangles against the normals of their faces, and the sizes (t,) of what makes each up."""
    vectors = triangle_vectors(points, triangles)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    uncertain = 0.5 * np.linalg.norm(b - a, axis=1) * np.linalg.norm(c - a, axis=1)
    corners = np.diff(offsets)
    if np.all(corners == 3):
        return np.linalg.norm(vectors, axis=1), uncertain
    wholes = face_vectors(points, indices, offsets)
    sizes = np.linalg.norm(wholes, axis=1)
    normals = wholes / np.where(sizes > 0.0, sizes, 1.0)[:, None]
    return np.einsum("ij,ij->i", vectors, np.repeat(normals, corners - 2, axis=0)), uncertain


def _sums(points: Array, triangles: Indices, areas: Array) -> tuple[float, Array, Array]:
    """∫ dA, ∫ r dA (3,) and ∫ r rᵀ dA (3, 3) about the origin of the points."""
    columns = np.ascontiguousarray(points.T)
    total = RunningSum((_ROWS, min(_BLOCK, len(triangles))))
    for start in range(0, len(triangles), _BLOCK):
        block = triangles[start : start + _BLOCK]
        a, b, c = (np.take(columns, block[:, k], axis=1) for k in range(3))
        s = a + b + c
        terms = np.empty((_ROWS, len(block)))
        terms[0] = 1.0
        terms[1:4] = s
        terms[4:] = sum(p[LEFT] * p[RIGHT] for p in (a, b, c, s))
        total.take(terms * areas[start : start + _BLOCK])
    sums = total.total() * _FACTORS
    return float(sums[0]), sums[1:4], symmetric(sums[4:])


def _error_bound(points: Array, triangles: Indices, uncertain: Array, area: float, spread: float) -> float:
    """Of area and central moment: every triangle's area is off by some roundings of the product of its sides."""
    squares = np.einsum("ij,ij->i", points, points)
    corners = squares[triangles].sum(axis=1)
    weights = np.array([uncertain.sum() / area, uncertain @ corners / 3.0 / spread])
    return float(16.0 * _ROUNDOFF * max(1.0, *weights))

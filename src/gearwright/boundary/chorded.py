"""The body whose section is cut into chords but whose motion is not cut at all.

It is what polyhedra with the same section points tend to as their layers become many: side faces ruled
by the chords, end faces triangulated between the same points. Its moments tell the error that comes of
the section from the error that comes of the layers.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..curves.curve import in_panels
from ..errors import GeometryError, Problem
from ..moments.body import BodyMoments, about_centroid
from ..moments.flux import flux_moments
from ..moments.matrix import patterned
from ..moments.quadrature import converged, gauss_legendre
from .boundary import Boundary
from .faces import Patch
from .sampling import Sampling, section_edges
from .tessellation import tessellate_caps

_NOTHING = 1e-12  # volume over the cube of the size
_NODES_OF_A_CHORD = 2  # along a chord r·n is linear and r rᵀ quadratic: Gauss–Legendre is exact for cubics


def chorded_moments(boundary: Boundary, sampling: Sampling, middle: Array) -> BodyMoments:
    """Moments of the body whose section has the sampling's points, swept without layers.

    middle   a point (3,) in the middle of the body, about which they are taken: on the axis where there is a pattern

    The ruled faces by flux, Gauss–Legendre with nodes along the motion increased until it settles; the
    triangles of the caps, which are planar, exactly. Raises GeometryError where the chords enclose nothing.
    """
    section = section_edges(boundary)
    turned = any(patch.pattern.order > 1 for patch in boundary.patches)
    origin = np.asarray(middle) * ([0.0, 0.0, 1.0] if turned else [1.0, 1.0, 1.0])
    caps = _triangle_flux(*tessellate_caps(boundary, sampling), origin)
    size = max(float(np.linalg.norm(edge.curve.start - origin)) for edge in boundary.edges)
    unit = np.outer([1.0, size, size, size], [1.0, size, size, size]) * size**3

    def integral(nodes: int) -> Array:
        sides = np.zeros((4, 4))
        for patch in boundary.patches:
            ruled = _along_curve if patch.sides[0].edge in section else _along_motion
            chords = [sampling.segments[patch.sides[k].edge] for k in (0, 1) if patch.sides[k].edge in section]
            sides += patterned(_strip_flux(*ruled(patch, chords[0], nodes), origin), patch.pattern.order)
        return (caps + sides) / unit

    scaled, error = converged(integral)
    if not scaled[0, 0] > _NOTHING:
        raise GeometryError(
            "Nothing is left of the solid with so few chords",
            [Problem(f"{max(sampling.segments[edge] for edge in section)} chords a section curve", "take more")],
        )
    return about_centroid(scaled * unit, "quadrature", error, origin)


def sagitta(boundary: Boundary, sampling: Sampling) -> float:
    """Largest distance between an edge of a cap and the middle of one of its chords."""
    found = [0.0]
    for edge in dict.fromkeys(use.edge for cap in boundary.caps for loop in cap.loops for use in loop.uses):
        n, curve = sampling.segments[edge], edge.curve
        points = curve.point(curve.parameter(np.arange(2 * n + 1) / (2 * n)))
        depths = points[1::2] - (points[:-1:2] + points[2::2]) / 2.0
        found.append(float(np.max(np.linalg.norm(depths, axis=-1))))
    return max(found)


def _along_curve(patch: Patch, chords: int, nodes: int) -> tuple[Array, Array]:
    """Ways (chords + 1, m, 3) of a section curve's points through the motion, and d way × weight; patch outward."""
    x, w = gauss_legendre(nodes)
    weights = np.outer(np.diff([0.0, *patch.panels, 1.0]), w / 2.0).ravel()
    u, v = np.meshgrid(np.arange(chords + 1) / chords, in_panels(patch.panels, (x + 1.0) / 2.0), indexing="ij")
    return patch.point(u, v), patch.partials(u, v)[1] * weights[:, None]


def _along_motion(patch: Patch, chords: int, nodes: int) -> tuple[Array, Array]:
    """The same of a patch whose motion goes around the caps: its curve lies at stations of the motion, from last to
    first, which keeps the outside."""
    x, w = gauss_legendre(nodes)
    v, u = np.meshgrid(np.arange(chords, -1, -1) / chords, (x + 1.0) / 2.0, indexing="ij")
    return patch.point(u, v), patch.partials(u, v)[0] * (w / 2.0)[:, None]


def _strip_flux(ways: Array, rates: Array, origin: Array) -> Array:
    """Flux (4, 4) through the strips that chords between neighbouring ways (k, m, 3) rule; rates (k, m, 3) weighted."""
    matrix = np.zeros((4, 4))
    chords = np.diff(ways, axis=0)
    for node, weight in zip(*gauss_legendre(_NODES_OF_A_CHORD), strict=True):
        s = (node + 1.0) / 2.0
        points, rate = ((1.0 - s) * a[:-1] + s * a[1:] for a in (ways - origin, rates))
        matrix += flux_moments(points.reshape(-1, 3), np.cross(chords, rate).reshape(-1, 3) * weight / 2.0)
    return matrix


def _triangle_flux(vertices: Array, triangles: Indices, origin: Array) -> Array:
    """Flux (4, 4) through triangles (m, 3): r·n is constant on each, and edge midpoints are exact for r rᵀ."""
    corners = vertices[triangles] - origin
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 6.0
    midpoints = (corners + np.roll(corners, -1, axis=1)) / 2.0
    return flux_moments(midpoints.reshape(-1, 3), np.repeat(vectors, 3, axis=0))

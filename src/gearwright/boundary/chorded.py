"""The body whose section is cut into chords but whose motion is not cut at all.

It is what polyhedra with the same section points tend to as their layers become many: side faces ruled
by the chords, end faces triangulated between the same points. Its moments tell the error that comes of
the section from the error that comes of the layers.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..curves.curve import in_panels
from ..moments.body import BodyMoments, about_centroid
from ..moments.flux import flux_moments
from ..moments.matrix import patterned
from ..moments.quadrature import converged, gauss_legendre
from .boundary import Boundary
from .faces import Patch
from .sampling import Sampling
from .tessellation import tessellate_caps

_NODES_OF_A_CHORD = 2  # along a chord r·n is linear and r rᵀ quadratic: Gauss–Legendre is exact for cubics


def chorded_moments(boundary: Boundary, sampling: Sampling, middle: Array) -> BodyMoments:
    """Moments of the body whose section has the sampling's points, swept without layers.

    middle   a point (3,) in the middle of the body, about which they are taken: on the axis where there is a pattern

    The ruled faces by flux, Gauss–Legendre with nodes along the motion increased until it settles; the
    triangles of the caps, which are planar, exactly.
    """
    turned = any(patch.pattern.order > 1 for patch in boundary.patches)
    origin = np.asarray(middle) * ([0.0, 0.0, 1.0] if turned else [1.0, 1.0, 1.0])
    caps = _triangle_flux(*tessellate_caps(boundary, sampling), origin)
    size = max(float(np.linalg.norm(edge.curve.start - origin)) for edge in boundary.edges)
    unit = np.outer([1.0, size, size, size], [1.0, size, size, size]) * size**3

    def integral(nodes: int) -> Array:
        sides = [
            patterned(_ruled_flux(patch, sampling.segments[patch.sides[0].edge], nodes, origin), patch.pattern.order)
            for patch in boundary.patches
        ]
        return (caps + np.sum(sides, axis=0)) / unit

    scaled, error = converged(integral)
    return about_centroid(scaled * unit, "quadrature", error, origin)


def sagitta(boundary: Boundary, across: int) -> float:
    """Largest distance between a profile and the middle of its chords, of which there are `across`."""
    found = [0.0]
    for profile in dict.fromkeys(patch.sides[k].edge for patch in boundary.patches for k in (0, 2)):
        curve = profile.curve
        corners = curve.point(curve.parameter(np.arange(across + 1) / across))
        between = curve.point(curve.parameter((np.arange(across) + 0.5) / across))
        found.append(float(np.max(np.linalg.norm(between - (corners[:-1] + corners[1:]) / 2.0, axis=-1))))
    return max(found)


def _ruled_flux(patch: Patch, across: int, nodes: int, origin: Array) -> Array:
    """Flux (4, 4) through the strips between the ways of neighbouring section points, of one image of a patch."""
    x, w = gauss_legendre(nodes)
    v = in_panels(patch.panels, (x + 1.0) / 2.0)
    along = np.outer(np.diff([0.0, *patch.panels, 1.0]), w / 2.0).ravel()
    u, v = np.meshgrid(np.arange(across + 1) / across, v, indexing="ij")
    ways, rates = patch.point(u, v) - origin, patch.partials(u, v)[1]
    matrix = np.zeros((4, 4))
    chords = np.diff(ways, axis=0)
    for node, weight in zip(*gauss_legendre(_NODES_OF_A_CHORD), strict=True):
        s = (node + 1.0) / 2.0
        points, rate = ((1.0 - s) * a[:-1] + s * a[1:] for a in (ways, rates))
        vectors = np.cross(chords, rate) * (along[:, None] * weight / 2.0)
        matrix += flux_moments(points.reshape(-1, 3), vectors.reshape(-1, 3))
    return matrix


def _triangle_flux(vertices: Array, triangles: Indices, origin: Array) -> Array:
    """Flux (4, 4) through triangles (m, 3): r·n is constant on each, and edge midpoints are exact for r rᵀ."""
    corners = vertices[triangles] - origin
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 6.0
    midpoints = (corners + np.roll(corners, -1, axis=1)) / 2.0
    return flux_moments(midpoints.reshape(-1, 3), np.repeat(vectors, 3, axis=0))

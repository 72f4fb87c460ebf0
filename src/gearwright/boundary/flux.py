"""Flux through a boundary: moments, area and closure of a body from its faces alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..curves.curve import in_panels
from ..moments.flux import flux_moments
from ..moments.matrix import patterned
from ..moments.quadrature import gauss_legendre
from .faces import Cap, CapLoop, Patch
from .pattern import Pattern


@dataclass(frozen=True, kw_only=True)
class Flux:
    """matrix (4, 4): moments about the origin; area_vector (3,): ∮ n dA; area: of the patches and |cap vectors|."""

    matrix: Array
    area_vector: Array
    area: float


def boundary_flux(patches: Sequence[Patch], caps: Sequence[Cap], nodes: int) -> Flux:
    """Flux by Gauss–Legendre quadrature with nodes² points a panel of a patch and `nodes` points a cap's edge."""
    matrix, vector, area = np.zeros((4, 4)), np.zeros(3), 0.0
    for patch in patches:
        points, area_vectors = patch_quadrature(patch, nodes)
        matrix += _all_images(points, area_vectors, patch.pattern)
        vector += patch.pattern.turned(area_vectors.sum(axis=0)[None]).sum(axis=(0, 1))
        area += patch.pattern.order * float(np.sum(np.linalg.norm(area_vectors, axis=1)))
    for cap in caps:
        for loop in cap.loops:
            points, tangents = loop_quadrature(loop, nodes)
            matrix += cap.surface.flux(points, tangents)
            half = np.cross(points, tangents).sum(axis=0) / 2.0
            vector += half
            area += float(np.linalg.norm(half))
    return Flux(matrix=matrix, area_vector=vector, area=area)


def loop_quadrature(loop: CapLoop, nodes: int) -> tuple[Array, Array]:
    """Points (n, 3) and weighted tangents (n, 3) all along a cap's loop, images included."""
    parts = [use.edge.curve.quadrature(nodes) for use in loop.uses]
    senses = [-1.0 if use.reverse != loop.reverse else 1.0 for use in loop.uses]
    points = np.concatenate([p for p, _ in parts])
    tangents = np.concatenate([sense * t for sense, (_, t) in zip(senses, parts, strict=True)])
    return loop.pattern.images(points).reshape(-1, 3), loop.pattern.turned(tangents).reshape(-1, 3)


def patch_quadrature(patch: Patch, nodes: int) -> tuple[Array, Array]:
    """Points (n, 3) of one image of a patch and weighted area vectors (n, 3), nodes² to each of its panels."""
    x, w = gauss_legendre(nodes)
    along, up = (x + 1.0) / 2.0, in_panels(patch.panels, (x + 1.0) / 2.0)
    u, v = (a.ravel() for a in np.meshgrid(along, up, indexing="ij"))
    widths = np.diff([0.0, *patch.panels, 1.0])
    weights = np.outer(w, np.outer(widths, w)).ravel() / 4.0
    return patch.point(u, v), patch.area_vector(u, v) * weights[:, None]


def _all_images(points: Array, area_vectors: Array, pattern: Pattern) -> Array:
    """Flux (4, 4) through all images of a sector of nodes (n, 3); about z it follows from that through one."""
    if pattern.placement is None:
        return patterned(flux_moments(points, area_vectors), pattern.order)
    return flux_moments(pattern.images(points).reshape(-1, 3), pattern.turned(area_vectors).reshape(-1, 3))

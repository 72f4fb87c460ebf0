"""Flux through a boundary: moments, area and closure of a body from its faces alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..curves.curve import chain_quadrature, in_panels
from ..moments.flux import flux_moments
from ..moments.matrix import patterned
from ..moments.quadrature import gauss_legendre
from .faces import Cap, CapLoop, Patch, alike, points_and_partials
from .pattern import Pattern

_AT_ONCE = 50_000  # nodes of patches evaluated together


@dataclass(frozen=True, kw_only=True)
class Flux:
    """matrix (4, 4): moments about the origin; area_vector (3,): ∮ n dA; area: of the patches and |cap vectors|."""

    matrix: Array
    area_vector: Array
    area: float


def boundary_flux(patches: Sequence[Patch], caps: Sequence[Cap], nodes: int) -> Flux:
    """Flux by Gauss–Legendre quadrature with nodes² points a panel of a patch and `nodes` points a cap's edge."""
    matrix, vector, area = np.zeros((4, 4)), np.zeros(3), 0.0
    for pattern, points, area_vectors in patch_quadrature(patches, nodes):
        matrix += _all_images(points, area_vectors, pattern)
        vector += pattern.turned(area_vectors.sum(axis=0)[None]).sum(axis=(0, 1))
        area += pattern.order * float(np.sum(np.linalg.norm(area_vectors, axis=1)))
    for cap in caps:
        points, tangents = cap_quadrature(cap, nodes)
        matrix += cap.surface.flux(points, tangents)
        half = np.cross(points, tangents).sum(axis=0) / 2.0
        vector += half
        area += float(np.linalg.norm(half))
    return Flux(matrix=matrix, area_vector=vector, area=area)


def cap_quadrature(cap: Cap, nodes: int) -> tuple[Array, Array]:
    """Points (n, 3) and weighted tangents (n, 3) all along the loops of a cap."""
    loops = [_loop_quadrature(loop, nodes) for loop in cap.loops]
    return np.concatenate([points for points, _ in loops]), np.concatenate([tangents for _, tangents in loops])


def _loop_quadrature(loop: CapLoop, nodes: int) -> tuple[Array, Array]:
    """Points (n, 3) and weighted tangents (n, 3) all along a cap's loop, images included."""
    curves = [use.edge.curve for use in loop.uses]
    if any(curve.panels for curve in curves):
        parts = [curve.quadrature(nodes) for curve in curves]
    else:
        parts = [chain_quadrature(curves, nodes)]
    points, tangents = (np.concatenate(part) for part in zip(*parts, strict=True))
    counts = [len(part[0]) for part in parts] if len(parts) == len(curves) else nodes
    senses = np.repeat([-1.0 if use.reverse != loop.reverse else 1.0 for use in loop.uses], counts)[:, None]
    return loop.pattern.images(points).reshape(-1, 3), loop.pattern.turned(senses * tangents).reshape(-1, 3)


def patch_quadrature(patches: Sequence[Patch], nodes: int) -> Iterator[tuple[Pattern, Array, Array]]:
    """Patterns of patches, points (n, 3) of one image and weighted area vectors (n, 3), nodes² to each panel."""
    x, w = gauss_legendre(nodes)
    for run in alike(patches):
        panels = run[0].panels
        up = in_panels(panels, (x + 1.0) / 2.0)
        u, v = (a.ravel() for a in np.meshgrid((x + 1.0) / 2.0, up, indexing="ij"))
        weights = np.outer(w, np.outer(np.diff([0.0, *panels, 1.0]), w)).ravel() / 4.0
        many = max(1, _AT_ONCE // len(u))
        for start in range(0, len(run), many):
            points, du, dv = points_and_partials(run[start : start + many], u, v)
            area_vectors = np.cross(du, dv) * weights[:, None]
            yield run[0].pattern, points.reshape(-1, 3), area_vectors.reshape(-1, 3)


def _all_images(points: Array, area_vectors: Array, pattern: Pattern) -> Array:
    """Flux (4, 4) through all images of a sector of nodes (n, 3); about z it follows from that through one."""
    if pattern.placement is None:
        return patterned(flux_moments(points, area_vectors), pattern.order)
    return flux_moments(pattern.images(points).reshape(-1, 3), pattern.turned(area_vectors).reshape(-1, 3))

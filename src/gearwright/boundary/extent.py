"""How large a boundary is: its area and its bounding box, on the true surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..curves.curve import along, in_panels
from ..moments.quadrature import converged
from .boundary import Boundary
from .faces import Cap, Patch, alike, points_and_partials
from .flux import cap_quadrature, patch_quadrature
from .outlines import winding

_GRID = 17  # samples a side of a patch in the search for its extremes
_TO_ROUNDING = {"ftol": 1e-15, "gtol": 0.0, "maxiter": 200}
_NEAR_BEST = 0.02  # of the size: a sample worth refining; a patch sagging more between samples would be a poor one
_MOST_TOPS = 16  # refined in a patch: a spring's windings reach almost equally far
_LEVEL = 1e-15  # slope, by a patch's size, that rounding leaves where there is none
_LOOP_SAMPLES = 64  # a curve, to see whether an extreme of a cap's surface lies in the cap


def surface_area(boundary: Boundary) -> float:
    """Area by Gauss–Legendre quadrature, with nodes increased until it settles."""
    return float(converged(lambda nodes: np.array(_area(boundary, nodes)))[0])


def bounding_box(boundary: Boundary) -> Array:
    """Lowest and highest coordinates (2, 3): extremes of the patches, found on a grid and refined, and of the caps."""
    candidates = [_Candidates.of(patch) for patch in boundary.patches]
    # edges between caps alone are straight
    corners = [edge.pattern.images(edge.curve.point(np.array(edge.curve.interval))) for edge in boundary.edges]
    samples = np.concatenate([points.reshape(-1, 3) for points in (*(c.points for c in candidates), *corners)])
    size = float(np.ptp(samples, axis=0).max())
    inside = np.array([point for cap in boundary.caps for point in _extremes_inside(cap)]).reshape(-1, 3)
    box = np.empty((2, 3))
    for axis in range(3):
        for row, sign in enumerate((-1.0, 1.0)):
            best = float(np.max(sign * samples[:, axis]))
            near = [c for c in candidates if np.max(sign * c.points[..., axis]) > best - _NEAR_BEST * size]
            refined = (c.refined(axis, sign, best - _NEAR_BEST * size) for c in near)
            box[row, axis] = sign * max([best, *refined, *(sign * inside[:, axis])])
    return box


def rough_diagonal(boundary: Boundary) -> float:
    """Diagonal of the bounding box to a hundredth or so: from points along edges and on patches, extremes in caps."""
    inside = [point for cap in boundary.caps for point in _extremes_inside(cap)]
    points = np.concatenate(
        [*_points_on_edges(boundary), *_points_on_patches(boundary), np.array(inside).reshape(-1, 3)]
    )
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def edge_diagonal(boundary: Boundary) -> float:
    """Diagonal of the bounding box of the edges: quicker, and smaller where faces bulge."""
    return float(np.linalg.norm(np.ptp(np.concatenate(list(_points_on_edges(boundary))), axis=0)))


def _points_on_edges(boundary: Boundary) -> Iterator[Array]:
    """Points (n, 3) along all images of the edges, those of one pattern together."""
    for _, group in groupby(boundary.edges, key=lambda edge: (id(edge.pattern), edge.curve.panels)):
        edges = list(group)
        points, _ = along([edge.curve for edge in edges], edges[0].curve.fractions(_GRID - 1))
        yield edges[0].pattern.images(points.reshape(-1, 3)).reshape(-1, 3)


def _points_on_patches(boundary: Boundary) -> Iterator[Array]:
    """Some points (n, 3) on all images of the patches."""
    quarters = np.array([0.25, 0.5, 0.75])
    for run in alike(boundary.patches):
        u, v = np.meshgrid(quarters, in_panels(run[0].panels, quarters))
        points, _, _ = points_and_partials(run, u.ravel(), v.ravel())
        yield run[0].pattern.images(points.reshape(-1, 3)).reshape(-1, 3)


def _area(boundary: Boundary, nodes: int) -> float:
    patches = (
        pattern.order * float(np.sum(np.linalg.norm(area_vectors, axis=1)))
        for pattern, _, area_vectors in patch_quadrature(boundary.patches, nodes)
    )
    caps = (abs(cap.surface.area(*cap_quadrature(cap, nodes))) for cap in boundary.caps)
    return sum(patches) + sum(caps)


@dataclass(frozen=True)
class _Candidates:
    """Samples of a patch in all its images: points (order, n, 3) at fractions (n, 2)."""

    patch: Patch
    fractions: Array
    points: Array

    @classmethod
    def of(cls, patch: Patch) -> _Candidates:
        side = np.linspace(0.0, 1.0, _GRID)
        up = in_panels(patch.panels, side[:-1], last=True)
        fractions = np.stack(np.meshgrid(side, up), axis=-1).reshape(-1, 2)
        return cls(patch, fractions, patch.pattern.images(patch.point(*fractions.T)))

    def refined(self, axis: int, sign: float, least: float) -> float:
        """Greatest sign × coordinate, by descent from the highest sample and others above `least` along the motion."""
        from scipy.optimize import minimize

        heights = sign * self.points[..., axis]
        image = int(np.unravel_index(np.argmax(heights), heights.shape)[0])
        direction = np.zeros(3)
        direction[axis] = -sign
        # the image's coordinate is the sector's along the direction turned back, and how far the image lies off
        to_image = self.patch.pattern.image(int(image))
        back, off = to_image.vectors_back(direction), float(to_image.shift @ direction)

        def height(uv: Array) -> tuple[float, Array]:
            du, dv = self.patch.partials(*uv)
            return float(self.patch.point(*uv) @ back) + off, np.array([du @ back, dv @ back])

        found = [float(heights.max())]
        starts = self.fractions[_tops(heights[image].reshape(-1, _GRID), least)]
        slopes = np.stack([partial @ back for partial in self.patch.partials(*starts.T)], axis=-1)
        for start in starts[_descends(starts, slopes, float(np.ptp(self.points)))]:
            result = minimize(
                height,
                start,
                jac=True,
                method="L-BFGS-B",
                bounds=[(0.0, 1.0)] * 2,
                options=_TO_ROUNDING,
            )
            found.append(-float(result.fun))
        return max(found)


def _descends(starts: Array, slopes: Array, size: float) -> NDArray[np.bool_]:
    """Whether from starts (n, 2) in the unit square with slopes (n, 2) any way leads down that stays in it."""
    free = np.where(starts <= 0.0, np.minimum(slopes, 0.0), np.where(starts >= 1.0, np.maximum(slopes, 0.0), slopes))
    return np.any(np.abs(free) > _LEVEL * size, axis=1)


def _tops(heights: Array, least: float) -> Indices:
    """Samples, as numbers into (rows, columns), that are highest in a row higher than its neighbours; the best few."""
    rows = heights.max(axis=1)
    around = np.concatenate([[-np.inf], rows, [-np.inf]])
    tops = np.flatnonzero((rows >= around[:-2]) & (rows >= around[2:]) & (rows >= least))
    chosen = tops[np.argsort(-rows[tops])][:_MOST_TOPS]
    return np.asarray(chosen * heights.shape[1] + heights[chosen].argmax(axis=1))


def _extremes_inside(cap: Cap) -> Iterator[Array]:
    """Points of a cap where its surface is extreme along a coordinate axis."""
    loops = [cap.surface.chart(loop.around(lambda _: _LOOP_SAMPLES)) for loop in cap.loops]
    for point in cap.surface.extremes():
        around = sum(winding(cap.surface.chart(point), loop) for loop in loops)
        if around != 0:
            yield point

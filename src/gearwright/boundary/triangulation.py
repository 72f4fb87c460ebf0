"""Triangulation of a face: its border as it is sampled, and inner points where the surface or the shape asks.

The border's points are kept exactly and none is added on it. Inner points are graded: as dense as the
border next to them, sparser inward, and on a curved surface never sparser than its chord tolerance
allows. The constrained Delaunay triangulation is pythoncdt's, in the surface's conformal chart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem
from ..surfaces.surface import Surface

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

MOST_CELLS = 2_000_000
"""Inner points of one face beyond which a tolerance is taken for a slip."""
_GRADING = 0.6  # cell size by distance from the border: neighbours then differ by less than a factor of two
_CLEARANCE = 0.6  # distance of inner points from the border, by the local spacing
_CLEAR_OF_SIDES = 0.3  # distance of inner points from the border's sides, by the size wanted there
_LONG = 1.5  # a side so many times the least spacing may have other border points nearer to its middle than its ends
_SAMPLED = 0.95  # of the tolerance, where a triangle is sampled; border sides keep 1/1.1 of it by themselves
_ROUNDS = 32  # insertions after which a triangle beyond the tolerance is refused; long cones have needed 20


@dataclass(frozen=True, kw_only=True)
class Grading:
    """How far apart points of a face's chart should lie, by where they are.

    border    (n, 2)  points of the border
    spacing   (n,)    their own spacing
    holes     loops (k, 2) inside which no points are wanted: a chart may have no end there, as around a cone's apex
    """

    surface: Surface
    tolerance: float
    border: Array
    spacing: Array
    holes: Sequence[Array] = ()

    @cached_property
    def _tree(self) -> cKDTree:
        from scipy.spatial import cKDTree

        return cKDTree(self.border)

    def size(self, points: Array) -> tuple[Array, Array]:
        """Distance between neighbours (n,) wanted at points (n, 2), and clearance (n,) from the border they have.

        The clearance is relative to the spacing of the nearest border point.
        """
        distance, nearest = self._tree.query(points)
        local = self.spacing[nearest]
        size = np.minimum(np.maximum(_GRADING * distance, local), self.surface.spacing(self.tolerance, points))
        return size, distance / local

    def points(self) -> Array:
        """Inner points (k, 2): centres of the cells of a quadtree as small as wanted, clear of the border."""
        low, high = self.border.min(axis=0), self.border.max(axis=0)
        side = float(np.max(high - low)) / 4.0
        quarter = np.array([[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]])
        cells = (low + high) / 2.0 + side * np.stack(np.meshgrid(*2 * [np.arange(4) - 1.5]), axis=-1).reshape(-1, 2)
        kept = []
        while len(cells):
            wanted, clearance = self.size(cells)
            fits = side <= wanted
            kept.append(cells[fits & (clearance > _CLEARANCE)])
            cells = self._not_in_holes(cells[~fits], side)
            cells = (cells[:, None, :] + side / 4.0 * quarter).reshape(-1, 2)
            side /= 2.0
        return np.concatenate(kept)

    def _not_in_holes(self, cells: Array, side: float) -> Array:
        """Those of square cells (n, 2), by their centres, that do not lie wholly in a hole."""
        import shapely

        for hole in self.holes:
            inside = shapely.contains_xy(shapely.Polygon(hole), cells[:, 0], cells[:, 1])
            cells = cells[~(inside & (self._tree.query(cells)[0] > side))]
        return cells


def triangulate(surface: Surface, loops: Sequence[Array], tolerance: float) -> tuple[Array, Indices]:
    """Inner points (k, 3) and triangles (m, 3) of the face that loops (n_i, 3) bound on a surface.

    Triangles index the loops' points in order, then the inner points, and turn as the loops do.
    Raises GeometryError where the loops cross.
    """
    charts = [surface.chart(loop) for loop in loops]
    inner, triangles = triangulate_chart(surface, charts, tolerance)
    return surface.point(inner), triangles


def require_possible(surface: Surface, outer: Array, tolerance: float) -> None:
    """Raises GeometryError where the tolerance needs more than MOST_CELLS points inside an outer loop (n, 2)."""
    extent = float(np.max(np.ptp(outer, axis=0)))
    needed = (extent / float(np.max(surface.spacing(tolerance, outer)))) ** 2
    if needed > MOST_CELLS:
        raise GeometryError(
            "The tolerance asks for too fine a polyhedron",
            [
                Problem(
                    f"tolerance = {tolerance:.3g}",
                    f"an end face would need more than {MOST_CELLS} points; "
                    f"try {1.05 * tolerance * needed / MOST_CELLS:.2g}, and is it in the part's length unit?",
                )
            ],
        )


def triangulate_chart(surface: Surface, loops: Sequence[Array], tolerance: float) -> tuple[Array, Indices]:
    """The same in the chart of the surface: loops (n_i, 2), inner points (k, 2)."""
    require_possible(surface, loops[0], tolerance)
    border = np.concatenate(loops)
    constraints = closed_chains([len(loop) for loop in loops])
    spacing = spacing_along(border, constraints)
    grading = Grading(surface=surface, tolerance=tolerance, border=border, spacing=spacing, holes=loops[1:])
    inner = _clear_of_sides(grading, grading.points(), constraints)
    return _refined(surface, loops, inner, tolerance)


def triangulate_sparsely(surface: Surface, loops: Sequence[Array], tolerance: float) -> tuple[Array, Indices]:
    """As `triangulate_chart`, with inner points only where the tolerance needs them: quick, and full of slivers."""
    require_possible(surface, loops[0], tolerance)
    return _refined(surface, loops, np.empty((0, 2)), tolerance)


def _refined(surface: Surface, loops: Sequence[Array], inner: Array, tolerance: float) -> tuple[Array, Indices]:
    """Inner points (k, 2) with others where triangles would be beyond the tolerance, and the triangles (m, 3)."""
    border, constraints = np.concatenate(loops), closed_chains([len(loop) for loop in loops])
    for _ in range(_ROUNDS):
        points = np.concatenate([border, inner])
        triangles = _delaunay(points, constraints)
        far = _deviation(surface, surface.point(points)[triangles]) > _SAMPLED * tolerance
        if not far.any():
            break
        inner = np.concatenate([inner, points[triangles[far]].mean(axis=1)])
    else:
        raise GeometryError(
            "An end face cannot be triangulated to this tolerance",
            [Problem(f"tolerance = {tolerance:g}", "ask for another one")],
        )
    if sum(signed_area(loop) for loop in loops) < 0.0:
        triangles = triangles[:, ::-1]
    used, triangles = _without_unused(triangles, len(border), len(points))
    return inner[used], triangles


def _clear_of_sides(grading: Grading, inner: Array, constraints: Indices) -> Array:
    """Inner points (k, 2) without those near a long side whose ends are further off than other points of the border."""
    from scipy.spatial import cKDTree

    start, step = grading.border[constraints[:, 0]], np.diff(grading.border[constraints], axis=1)[:, 0]
    lengths = np.linalg.norm(step, axis=1)
    long = np.flatnonzero(lengths > _LONG * grading.spacing.min())
    if not len(inner) or not len(long):
        return inner
    needed = _CLEAR_OF_SIDES * grading.size(inner)[0]
    clear = np.ones(len(inner), bool)
    around = cKDTree(inner).query_ball_point((start + step / 2.0)[long], lengths[long] / 2.0 + needed.max())
    for side, near in zip(long, around, strict=True):
        arms = inner[near] - start[side]
        t = np.clip(arms @ step[side] / lengths[side] ** 2, 0.0, 1.0)
        clear[near] &= np.linalg.norm(arms - t[:, None] * step[side], axis=1) > needed[near]
    return inner[clear]


def _deviation(surface: Surface, corners: Array) -> Array:
    """Greatest distance (m,) from the surface of triangles (m, 3, 3) whose corners lie on it."""
    middles = (corners + np.roll(corners, 1, axis=1)) / 2.0
    return np.maximum(surface.deviation(corners.mean(axis=1)), surface.deviation(middles).max(axis=1))


def _delaunay(points: Array, constraints: Indices) -> Indices:
    """Counter-clockwise triangles (m, 3) inside the constrained loops."""
    import pythoncdt as cdt

    triangulation = cdt.Triangulation(cdt.VertexInsertionOrder.AUTO, cdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
    vertices: Any = np.ascontiguousarray(points)  # arrays are buffers, which Python 3.11 cannot say
    edges: Any = constraints.astype(np.uintc)
    try:
        triangulation.insert_vertices(vertices)
        triangulation.insert_edges(edges)
    except RuntimeError as error:
        if type(error) is not RuntimeError:  # NotImplementedError and the like are no word about the loops
            raise
        raise GeometryError(
            "An end face cannot be triangulated",
            [Problem("its loops", "cross or touch when sampled; a finer tolerance or a thicker wall keeps them apart")],
        ) from error
    triangulation.erase_outer_triangles_and_holes()
    return triangulation.triangles_array()["vertices"].astype(np.int64)


def spacing_along(border: Array, constraints: Indices) -> Array:
    """The longer (n,) of the segments (k, 2) that meet at each point (n, 2) of a border."""
    lengths = np.linalg.norm(border[constraints[:, 1]] - border[constraints[:, 0]], axis=1)
    spacing = np.zeros(len(border))
    np.maximum.at(spacing, constraints.ravel(), np.repeat(lengths, 2))
    return spacing


def closed_chains(counts: Sequence[int]) -> Indices:
    """Segments (n, 2) of closed loops of so many points each, numbered on."""
    starts = np.cumsum([0, *counts[:-1]])
    return np.concatenate(
        [np.stack([np.arange(n), np.roll(np.arange(n), -1)], axis=1) + s for s, n in zip(starts, counts, strict=True)]
    )


def signed_area(polygon: Array) -> float:
    """Area of a polygon (n, 2), positive where it runs counter-clockwise."""
    x, y = polygon[:, 0], polygon[:, 1]
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) / 2.0)


def _without_unused(triangles: Indices, fixed: int, total: int) -> tuple[Indices, Indices]:
    """Inner points that a triangle uses, and the triangles renumbered to them."""
    seen = np.zeros(total, bool)
    seen[triangles] = True
    seen[:fixed] = True
    return np.flatnonzero(seen[fixed:]), (np.cumsum(seen) - 1)[triangles]

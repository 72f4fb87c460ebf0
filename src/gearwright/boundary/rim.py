"""Triangulation of an N-fold face: one sector of the rim, its images, and what lies inside them.

The rim reaches from the outer loop to a ring about the axis, chosen where a sector is about as wide as
the triangles should be; inside it the sectors would only be slivers. One sector is triangulated and
turned, which is N times faster and keeps the symmetry of the shape exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, Indices
from ..curves.curve import turn
from ..surfaces.surface import Surface
from .triangulation import (
    Grading,
    closed_chains,
    require_possible,
    signed_area,
    spacing_along,
    triangulate,
    triangulate_chart,
)

_WIDEST_RING = 0.9  # of the smallest radius of the outer loop, so that there is a rim at all
_DEPTHS = 64  # samples along a cut
_FEWEST_SIDES = 12  # of the ring as a polygon: its sides then stay clear of what is inside
_NARROWEST_ROOM = 1.2  # of the largest radius of the inner loops


def triangulate_pattern(
    surface: Surface, loops: Sequence[Array], tolerance: float, order: int
) -> tuple[Array, Indices]:
    """As `triangulate`, for loops (n_i, 3) of which the first, the outer one, is `order` turned periods about z.

    The surface's chart must turn with it about its own origin. Falls back on the whole face where the
    shape leaves no room for a rim.
    """
    charts = [surface.chart(loop) for loop in loops]
    require_possible(surface, charts[0], tolerance)
    rim = _Rim.of(surface, charts, tolerance, order) if order >= 3 else None
    if rim is None:
        return triangulate(surface, loops, tolerance)
    outer = len(charts[0])
    sense = 1 if signed_area(charts[0]) > 0.0 else -1
    ring, rim_points, rim_triangles = rim.triangulated(sense)
    core_loops = [ring, *charts[1:]]
    core_points, core = triangulate_chart(surface, core_loops, tolerance)
    # numbered: all loops, ring, rim points, core points
    others = sum(len(chart) for chart in charts[1:])
    start = outer + others
    rim_triangles = np.where(rim_triangles < outer, rim_triangles, rim_triangles + others)
    core_numbers = np.concatenate(
        [
            start + np.arange(len(ring)),
            outer + np.arange(others),
            start + len(ring) + len(rim_points) + np.arange(len(core_points)),
        ]
    )
    return surface.point(np.concatenate([ring, rim_points, core_points])), np.concatenate(
        [rim_triangles, core_numbers[core]]
    )


@dataclass(frozen=True)
class _Rim:
    """One sector of a face between its outer loop and a ring, in the chart.

    period      (n, 2)  one period of the outer loop, rolled to start at its smallest radius
    offset      by how many points it was rolled
    ring        radius of the ring
    divisions   segments of the ring in one sector
    """

    surface: Surface
    tolerance: float
    order: int
    outer: Array
    offset: int
    ring: float
    divisions: int

    @classmethod
    def of(cls, surface: Surface, charts: Sequence[Array], tolerance: float, order: int) -> _Rim | None:
        outer = charts[0]
        radii = np.linalg.norm(outer, axis=1)
        count = len(outer) // order
        offset = int(np.argmin(radii[:count]))
        least = float(radii[offset])
        holes = max((float(np.linalg.norm(chart, axis=1).max()) for chart in charts[1:]), default=0.0)
        grading = _grading(surface, tolerance, outer)
        trial = np.linspace(_NARROWEST_ROOM * holes, _WIDEST_RING * least, 65)[1:]
        sizes = grading.size(trial[:, None] * outer[offset] / least)[0]
        wide = 2.0 * np.pi * trial / order >= sizes
        if not wide.any() or _NARROWEST_ROOM * holes >= _WIDEST_RING * least:
            return None
        first = int(np.argmax(wide))
        divisions = int(np.ceil(max(2.0 * np.pi * trial[first] / sizes[first], _FEWEST_SIDES) / order))
        return cls(surface, tolerance, order, np.roll(outer, -offset, axis=0), offset, float(trial[first]), divisions)

    def triangulated(self, sense: int) -> tuple[Array, Array, Indices]:
        """The ring (r, 2) in the sense of the loop, other new points (k, 2), and the triangles of all sectors.

        Triangles number the outer loop's points as given, then the ring, then the new points.
        """
        step = sense * 2.0 * np.pi / self.order
        count = len(self.outer) // self.order
        period = self.outer[:count]
        start = period[0]
        direction = start / np.linalg.norm(start)
        arc = np.stack([turn(step * j / self.divisions, 2) @ direction for j in range(self.divisions)]) * self.ring
        cut = self._cut(direction)
        turned = turn(step, 2)
        border = np.concatenate([period, [turned @ start], cut @ turned.T, [turned @ arc[0]], arc[::-1], cut[::-1]])
        inner, triangles = triangulate_chart(self.surface, [border], self.tolerance)
        own = np.concatenate([cut, inner])
        numbers = self._numbers(count, len(cut), len(inner))
        points = np.concatenate([own @ turn(step * k, 2).T for k in range(self.order)])
        ring = np.concatenate([arc @ turn(step * k, 2).T for k in range(self.order)])
        return ring, points, numbers[:, triangles].reshape(-1, 3)

    def _cut(self, direction: Array) -> Array:
        """Points (k, 2) along the radius from the outer loop's start to the ring, both left out, graded."""
        grading = _grading(self.surface, self.tolerance, self.outer)
        radii = [float(np.linalg.norm(self.outer[0]))]
        # sizes wanted, sampled densest at the border, where they may change fast
        depths = (radii[0] - self.ring) * np.concatenate([[0.0], np.geomspace(1e-6, 1.0, _DEPTHS)])
        sizes = grading.size((radii[0] - depths)[:, None] * direction)[0]
        while radii[-1] > self.ring:
            radii.append(radii[-1] - float(np.interp(radii[0] - radii[-1], depths, sizes)))
        # the last step overshoots: all are shortened alike, so that none grows
        shortened = (radii[0] - self.ring) / (radii[0] - radii[-1])
        return (radii[0] - shortened * (radii[0] - np.array(radii[1:-1])))[:, None] * direction

    def _numbers(self, count: int, cuts: int, inner: int) -> Indices:
        """Numbers (order, n) of one sector's points, border then inner, in every image."""
        n, outer, ring = self.order, len(self.outer), self.order * self.divisions
        k = np.arange(n)[:, None]
        onward = (k + 1) % n
        own = outer + ring + (cuts + inner) * k
        own_onward = outer + ring + (cuts + inner) * onward
        return np.concatenate(
            [
                (k * count + np.arange(count) + self.offset) % outer,
                (onward * count + self.offset) % outer,
                own_onward + np.arange(cuts),
                outer + onward * self.divisions,
                outer + k * self.divisions + np.arange(self.divisions)[::-1],
                own + np.arange(cuts)[::-1],
                own + cuts + np.arange(inner),
            ],
            axis=1,
        )


def _grading(surface: Surface, tolerance: float, loop: Array) -> Grading:
    """Spacing wanted inside a closed loop (n, 2) alone."""
    spacing = spacing_along(loop, closed_chains([len(loop)]))
    return Grading(surface=surface, tolerance=tolerance, border=loop, spacing=spacing)

"""The boundary of a section moved between ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import gcd

import numpy as np

from ..arrays import Array
from ..curves.curve import Curve, along
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.loop import Loop
from ..sections.section import LoopedSection
from .boundary import Boundary
from .edge import Edge, EdgeUse, Profile, Rail, VaryingRail, Vertex
from .faces import Cap, CapLoop, Patch
from .pattern import ALONE, Pattern

_ON_AXIS = 1e-14  # of a point's distance from the origin: cos 90° is 6e-17


def swept_boundary(section: LoopedSection, motion: Motion, ends: Ends) -> Boundary:
    """Patches of every section curve and the two caps; faces are named "loop i.j", "start" and "finish"."""
    order = gcd(section.order, motion.rotation_order)
    loops = [_SweptLoop(f"loop {i + 1}", loop.with_copies(order), motion, ends) for i, loop in enumerate(section.loops)]
    patches = tuple(patch for loop in loops for patch in loop.patches)
    if motion.closed(ends):
        return Boundary(patches=patches, caps=())
    start = Cap(
        name="start",
        surface=motion.end_surface(ends.start),
        loops=tuple(CapLoop(uses=loop.chain(0), reverse=True) for loop in loops),
    )
    finish = Cap(
        name="finish",
        surface=motion.end_surface(ends.finish),
        loops=tuple(CapLoop(uses=loop.chain(-1)) for loop in loops),
    )
    return Boundary(patches=patches, caps=(start, finish))


@dataclass(frozen=True)
class _SweptLoop:
    """The vertices, edges and patches that one loop of a section sweeps.

    Levels are the ends of the smooth spans, junctions the points between curves; the junction after the
    last curve is the first of the next image.
    """

    name: str
    loop: Loop
    motion: Motion
    ends: Ends

    @cached_property
    def _spans(self) -> tuple[Ends, ...]:
        return self.ends.spans(self.motion.breaks(self.ends))

    @cached_property
    def _stations(self) -> tuple[float, ...]:
        return (*(span.start for span in self._spans), self._spans[-1].finish)

    @cached_property
    def _motions(self) -> tuple[Motion, ...]:
        """The motion in each smooth span, smooth up to both ends of it."""
        return tuple(self.motion.smooth_piece(span) for span in self._spans)

    @cached_property
    def _pattern(self) -> Pattern:
        return Pattern(order=self.loop.copies)

    @cached_property
    def _onward(self) -> int:
        """Turns from one period to the next."""
        return self.loop.sense if self.loop.copies > 1 else 0

    @cached_property
    def _vertices(self) -> list[list[Vertex]]:
        levels: list[list[Vertex]] = []
        for level, station in enumerate(self._stations):
            starts = _starts(self._curves[level])
            positions = self.motion.place(starts, np.full(len(starts), station))
            row = [
                levels[-1][j]
                if levels and self._stationary(start)
                else self._vertex(f"{self.name}.{j}.{level}", position)
                for j, (start, position) in enumerate(zip(starts, positions, strict=True))
            ]
            levels.append(row)
        if self.motion.closed(self.ends):
            levels[-1] = levels[0]
        return levels

    @cached_property
    def _curves(self) -> list[tuple[Curve, ...]]:
        """The curves at each level."""
        if not any(curve.varies for curve in self.loop.curves):
            return [self.loop.curves] * len(self._stations)
        return [tuple(curve.at(v) for curve in self.loop.curves) for v in self._stations]

    def _vertex(self, name: str, position: Array) -> Vertex:
        on_axis = bool(np.all(np.abs(position[:2]) <= _ON_AXIS * np.linalg.norm(position)))
        return Vertex(name=name, position=position, pattern=ALONE if on_axis else self._pattern)

    def _stationary(self, points: Array) -> bool:
        """Whether the motion leaves section points where they are, as a revolution does on its axis."""
        if not self.motion.has_still_points:
            return False
        halfway = self.ends.at(np.full(points.shape[:-1], 0.5))
        places, velocities = self.motion.place(points, halfway), self.motion.velocity(points, halfway)
        return bool(np.all(np.abs(velocities) <= _ON_AXIS * np.max(np.abs(places))))

    def _sweeps_nothing(self, curve: Curve) -> bool:
        return self.motion.has_still_points and self._stationary(curve.point(curve.parameter([0.0, 0.3, 0.7, 1.0])))

    @cached_property
    def _rails(self) -> list[list[Edge]]:
        return [
            [
                Edge(
                    name=f"rail {self.name}.{j}.{level}",
                    curve=self._rail(curve, start, self._motions[level], span),
                    start=self._vertices[level][j],
                    end=self._vertices[level + 1][j],
                    pattern=self._vertices[level][j].pattern,
                )
                for j, (curve, start) in enumerate(zip(self.loop.curves, _starts(self.loop.curves), strict=True))
            ]
            for level, span in enumerate(self._spans)
        ]

    @staticmethod
    def _rail(curve: Curve, start: Array, motion: Motion, span: Ends) -> Curve:
        if curve.varies:
            return VaryingRail(motion=motion, curve=curve, ends=span)
        return Rail(motion=motion, section_point=tuple(start.tolist()), ends=span)

    @cached_property
    def _profiles(self) -> list[list[Edge]]:
        levels: list[list[Edge]] = []
        for level, station in enumerate(self._stations):
            row = [
                levels[-1][j] if levels and self._sweeps_nothing(curve) else self._profile(j, curve, level, station)
                for j, curve in enumerate(self._curves[level])
            ]
            levels.append(row)
        if self.motion.closed(self.ends):
            levels[-1] = levels[0]
        return levels

    def _profile(self, j: int, curve: Curve, level: int, station: float) -> Edge:
        row = self._vertices[level]
        last = j + 1 == len(row)
        return Edge(
            name=f"profile {self.name}.{j}.{level}",
            curve=Profile(motion=self.motion, curve=curve, v=station, interval=curve.interval),
            start=row[j],
            end=row[0 if last else j + 1],
            end_turn=self._onward if last else 0,
            pattern=self._pattern,
        )

    @cached_property
    def patches(self) -> tuple[Patch, ...]:
        return tuple(
            self._patch(j, curve, level, span)
            for level, span in enumerate(self._spans)
            for j, curve in enumerate(self.loop.curves)
            if not self._sweeps_nothing(curve)
        )

    def _patch(self, j: int, curve: Curve, level: int, span: Ends) -> Patch:
        last = j + 1 == len(self.loop.curves)
        rails = self._rails[level]
        return Patch(
            name=f"{self.name}.{j + 1}",
            curve=curve,
            motion=self._motions[level],
            ends=span,
            sides=(
                EdgeUse(edge=self._profiles[level][j]),
                EdgeUse(edge=rails[0 if last else j + 1], turn=self._onward if last else 0),
                EdgeUse(edge=self._profiles[level + 1][j], reverse=True),
                EdgeUse(edge=rails[j], reverse=True),
            ),
            pattern=self._pattern,
            surface=self.motion.swept_surface(curve),
        )

    def chain(self, level: int) -> tuple[EdgeUse, ...]:
        """The profiles at a level, once around one period."""
        return tuple(EdgeUse(edge=edge) for edge in self._profiles[level])


def _starts(curves: Sequence[Curve]) -> Array:
    """Where curves start (n, d)."""
    return along(curves, np.zeros(1))[0][:, 0]

"""Closed loops of curves, possibly repeated by rotation."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array
from ..curves.curve import Curve, chain_quadrature, mapped, points_along, turn
from ..errors import GeometryError, Problem

CLOSURE = 1e-9
"""Largest gap between curves, relative to the loop: far above rounding, far below any drawing's accuracy."""


@dataclass(frozen=True, kw_only=True)
class Loop:
    """A chain of curves that closes after `copies` equal turns about the origin (or z axis).

    curves   one period of the loop, in order; a gear's tooth and space
    copies   number of periods; they follow one another counter-clockwise or, around a hole, clockwise

    Raises GeometryError naming every place where the chain has a gap.
    """

    curves: tuple[Curve, ...]
    copies: int = 1

    def __post_init__(self) -> None:
        if not self.curves or self.copies < 1:
            given = f"{len(self.curves)} curves, {self.copies} copies"
            raise GeometryError("This is not a loop", [Problem(given, "at least one of each is needed")])
        gaps = self._gaps()
        if gaps:
            raise GeometryError("The loop is not closed", gaps)

    @cached_property
    def sense(self) -> int:
        """+1 where the next period is the counter-clockwise image of this one, −1 where the clockwise one."""
        start, end = self.curves[0].start, self.curves[-1].end
        angle = 2.0 * np.pi / self.copies
        misses = [float(np.linalg.norm(turn(sign * angle, start.size) @ start - end)) for sign in (1, -1)]
        return 1 if misses[0] <= misses[1] else -1

    def _gaps(self) -> list[Problem]:
        dimension = self.curves[0].start.size
        points = points_along(self.curves, np.array([0.0, 0.5, 1.0]))
        size = float(np.max(np.abs(points))) or 1.0
        starts, ends = points[:, 0], points[:, 2]
        ends[-1] = turn(-self.sense * 2.0 * np.pi / self.copies, dimension) @ ends[-1]
        gaps = np.linalg.norm(np.roll(starts, -1, axis=0) - ends, axis=1)
        return [
            Problem(
                f"gap of {gap:.3g} after curve {i + 1} of {len(self.curves)} at {np.round(ends[i], 6)}",
                f"at most {CLOSURE * size:.3g} is taken as closed; let each curve start where the one before it ends",
            )
            for i, gap in enumerate(gaps)
            if not gap <= CLOSURE * size
        ]

    def quadrature(self, nodes: int) -> tuple[Array, Array]:
        """Points (n, d) and weighted tangents (n, d) of one period, `nodes` to a curve."""
        return chain_quadrature(self.curves, nodes)

    def with_copies(self, copies: int) -> Loop:
        """The same loop as fewer, longer periods; `copies` divides the present number."""
        if self.copies % copies:
            raise ValueError(f"a loop of {self.copies} periods is not {copies} longer ones")
        dimension = self.curves[0].start.size
        step = self.sense * 2.0 * np.pi / self.copies
        curves = [
            curve if k == 0 else mapped(curve, turn(k * step, dimension))
            for k in range(self.copies // copies)
            for curve in self.curves
        ]
        return Loop(curves=tuple(curves), copies=copies)

    def at(self, v: float) -> Loop:
        """The loop at the motion's parameter v; a constant one is itself."""
        curves = tuple(curve.at(v) for curve in self.curves)
        constant = all(a is b for a, b in zip(curves, self.curves, strict=True))
        return self if constant else Loop(curves=curves, copies=self.copies)

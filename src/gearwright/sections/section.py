"""The concept of a section: what a motion moves to make a solid."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from math import gcd
from typing import Self

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, Problem
from ..moments.quadrature import converged
from .crossing import crossing_problems
from .loop import Loop

_NODES = 20  # a curve: one of the numbers at which the moments are looked at anyway


@dataclass(frozen=True, kw_only=True, repr=False)
class LoopedSection(ABC):
    """A region bounded by loops: the outer one first and counter-clockwise, holes clockwise.

    A section with families among its curves varies along its motion: moments, middle and all else that takes no
    parameter are of the reference, and `at` gives the members.

    Raises GeometryError where a loop runs the wrong way, or the holes take more than there is.
    """

    loops: tuple[Loop, ...]

    def __post_init__(self) -> None:
        problems = self._sense_problems() if self.loops else [Problem("0 loops", "at least the outer one is needed")]
        if not problems and not np.sum(self._of_loops, axis=0)[0, 0] > 0.0:
            problems = [Problem(f"{len(self.loops)} loops", "the holes take more than the outer loop encloses")]
        if problems:
            raise GeometryError("The loops do not bound a section", problems)

    @cached_property
    def _of_loops(self) -> list[Array]:
        """Moments of each loop, well enough for their signs."""
        return [self._integral((loop,), _NODES) for loop in self.loops]

    def __repr__(self) -> str:
        loops = "1 loop" if len(self.loops) == 1 else f"{len(self.loops)} loops"
        curves = sum(loop.copies * len(loop.curves) for loop in self.loops)
        return f"<{type(self).__name__} of {loops}, {curves} curve{'' if curves == 1 else 's'}>"

    def _sense_problems(self) -> list[Problem]:
        measures = [float(moments[0, 0]) for moments in self._of_loops]
        return [
            Problem(
                f"loop {i + 1} "
                + ("runs clockwise" if measure < 0.0 else "runs counter-clockwise" if measure else "encloses nothing"),
                f"{'the outer loop runs counter-clockwise' if i == 0 else 'a hole runs clockwise'}; reverse its curves",
            )
            for i, measure in enumerate(measures)
            if measure == 0.0 or (measure > 0.0) != (i == 0)
        ]

    @cached_property
    def varies(self) -> bool:
        """Whether the section is another one at other parameters of its motion."""
        return any(curve.varies for loop in self.loops for curve in loop.curves)

    @property
    @abstractmethod
    def _flat_loops(self) -> tuple[Loop, ...]:
        """The loops, or an image of them in the plane that crosses itself where they do."""

    @cached_property
    def _crossings(self) -> list[Problem]:
        return crossing_problems(self._flat_loops)

    def require_simple(self) -> None:
        """Raises GeometryError where loops cross or touch themselves or each other, or holes lie outside.

        Of a section that varies this is the reference; a sweep asks it of the members.
        """
        if self._crossings:
            raise GeometryError("This is not a section", self._crossings)

    @abstractmethod
    def _integral(self, loops: tuple[Loop, ...], nodes: int) -> Array:
        """Moments of the region bounded by the loops, with so many nodes a curve."""

    @property
    def order(self) -> int:
        """Turns of 2π/order about the origin bring the section onto itself."""
        return gcd(*(loop.copies for loop in self.loops))

    @cached_property
    def _converged(self) -> tuple[Array, float]:
        return converged(
            lambda nodes: np.sum(self._of_loops, axis=0) if nodes == _NODES else self._integral(self.loops, nodes)
        )

    @property
    def moments_error(self) -> float:
        """Relative error of the moments, from the convergence of the quadrature."""
        return self._converged[1]

    def at(self, v: float) -> Self:
        """The section at the motion's parameter v; a constant one is itself."""
        loops = tuple(loop.at(v) for loop in self.loops)
        return self if all(a is b for a, b in zip(loops, self.loops, strict=True)) else type(self)(loops=loops)

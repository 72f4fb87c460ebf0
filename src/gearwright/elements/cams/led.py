"""Displacements at fixed cam angles, by the free values of the spline: what a synthesis evaluates again and again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...arrays import Array
from ...moments.quadrature import gauss_legendre
from .laws import Law
from .programme import Displacement, Step, displacement, moves_of
from .spline_law import SplineLaw, even_values, spline_basis

_NODES = 32  # of a Gauss–Legendre rule for the area, on each analytic piece


@dataclass(frozen=True, kw_only=True)
class Movement:
    """A programme whose moves follow one law, or splines with so many free values each.

    law     None for splines
    count   free values of each move, 0 with a law
    unit    what one of the programme's amounts is: radians of a degree, or 1
    """

    steps: Sequence[Step]
    unit: float
    law: Law | None
    count: int

    @property
    def values(self) -> int:
        """Number of free values of all moves."""
        return self.count * moves_of(self.steps)

    def displacement(self, values: Array) -> Displacement:
        """The displacement for free values (moves × count,)."""
        moves = moves_of(self.steps)
        if self.law is not None:
            return displacement(self.steps, [self.law] * moves, self.unit)
        laws = [SplineLaw(values=tuple(one.tolist())) for one in values.reshape(moves, self.count)]
        return displacement(self.steps, laws, self.unit)

    def even(self) -> Displacement:
        """Some displacement of it, for what does not depend on the values: where its pieces begin and end."""
        return self.displacement(np.tile(even_values(self.count), self.values // max(self.count, 1)))


@dataclass(frozen=True, kw_only=True, eq=False)
class Led:
    """Displacement and derivatives (4, n) = constant + free @ values at n cam angles, with weights for an integral."""

    constant: Array
    free: Array
    weights: Array

    def at(self, values: Array) -> Array:
        return self.constant + self.free @ values


def led(movement: Movement, angles: Sequence[Array], weights: Sequence[Array] = ()) -> Led:
    """The movement at cam angles (radians), an array of them for each of its segments."""
    constants, frees, move = [], [], 0
    for segment, here in zip(movement.even().segments, angles, strict=True):
        constant, free = segment.derivatives(here), np.zeros((4, len(here), movement.values))
        if segment.law is not None:
            if movement.law is None:
                width = segment.end - segment.start
                powers = (segment.change / width ** np.arange(4.0))[:, None]
                fixed, basis = spline_basis((here - segment.start) / width, movement.count)
                constant = powers * fixed
                constant[0] += segment.low
                free[..., move * movement.count : (move + 1) * movement.count] = powers[..., None] * basis
            move += 1
        constants.append(constant)
        frees.append(free)
    return Led(
        constant=np.concatenate(constants, axis=1),
        free=np.concatenate(frees, axis=1),
        weights=np.concatenate(weights) if weights else np.empty(0),
    )


def area_nodes(movement: Movement) -> Led:
    """Where and with which weights ½∮ p ds is taken."""
    x, w = gauss_legendre(_NODES)
    angles, weights = [], []
    for segment in movement.even().segments:
        cuts = list(pairwise(segment.cuts))
        angles.append(np.concatenate([start + (end - start) * (x + 1.0) / 2.0 for start, end in cuts]))
        weights.append(np.concatenate([w * (end - start) / 2.0 for start, end in cuts]))
    return led(movement, angles, weights)

"""N-fold repetition about an axis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from ..arrays import Array
from ..curves.curve import turn
from ..placement import Placement


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """One sector and its images under turns of 2π/order about z; order 1 repeats nothing.

    placement   where the axis is, if it is not z any more
    """

    order: int = 1
    placement: Placement | None = None

    def images(self, points: Array) -> Array:
        """The images (order, n, 3) of points (n, 3), the sector itself first."""
        return self._about_axis(points) if self.placement is None else self._turned_points(points, self.placement)

    def turned(self, vectors: Array) -> Array:
        """The images (order, n, 3) of vectors (n, 3)."""
        if self.placement is None:
            return self._about_axis(vectors)
        return self.placement.vectors(self._about_axis(self.placement.vectors_back(vectors)))

    def moved(self, placement: Placement) -> Pattern:
        """The pattern of a body put elsewhere."""
        if self.order == 1:
            return ALONE
        whole = placement if self.placement is None else placement.after(self.placement)
        return Pattern(order=self.order, placement=None if whole.keeps_axis else whole)

    def image(self, k: int) -> Placement:
        """The rigid map that makes image k of the sector."""
        turned = Placement.of(_turns(self.order)[k % self.order])
        if self.placement is None:
            return turned
        back = Placement.of(self.placement.matrix.T, -self.placement.vectors_back(self.placement.shift))
        return self.placement.after(turned.after(back))

    def _about_axis(self, vectors: Array) -> Array:
        return vectors @ np.swapaxes(_turns(self.order), 1, 2)

    def _turned_points(self, points: Array, placement: Placement) -> Array:
        images = placement.points(self._about_axis(placement.points_back(points)))
        images[0] = points  # there and back again would round
        return images


ALONE = Pattern()


@cache
def _turns(order: int) -> Array:
    """The rotations (order, 3, 3) of a pattern."""
    turns = np.stack([turn(2.0 * np.pi * k / order, 3) for k in range(order)])
    turns.flags.writeable = False
    return turns

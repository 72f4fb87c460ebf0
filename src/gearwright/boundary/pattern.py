"""N-fold repetition about z."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from ..arrays import Array
from ..curves.curve import turn


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """One sector and its images under turns of 2π/order about z; order 1 repeats nothing."""

    order: int = 1

    def images(self, points: Array) -> Array:
        """The images (order, n, 3) of points (n, 3), the sector itself first."""
        return points @ np.swapaxes(_turns(self.order), 1, 2)


ALONE = Pattern()


@cache
def _turns(order: int) -> Array:
    """The rotations (order, 3, 3) of a pattern."""
    turns = np.stack([turn(2.0 * np.pi * k / order, 3) for k in range(order)])
    turns.flags.writeable = False
    return turns

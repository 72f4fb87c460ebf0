"""How a part of a pair moves when the pinion turns: a spin about its own axis, and a slide along with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array

_STEP = 0.1
"""Degrees between the two placements that are compared: a member may then turn up to 1800 times as fast."""

_NOISE = 1e-9
"""Of a placement's entries, in degrees a degree and sizes a degree: what rounding leaves of the difference."""

Triple = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class Turning:
    """Placement at a turn of t degrees: its placement · shift by t × slide · rotation about z by t × spin degrees.

    spin    degrees about the part's own z axis for one degree of the turn
    slide   shift (3,) in the part's own frame for one degree of the turn
    """

    spin: float = 0.0
    slide: Triple = (0.0, 0.0, 0.0)

    @classmethod
    def between(cls, at_rest: Array, turned: Array, degrees: float = _STEP) -> Turning:
        """From a part's placements (4, 4) at turns 0 and of some degrees."""
        motion = np.linalg.solve(at_rest, turned)
        spin = float(np.degrees(np.arctan2(motion[1, 0], motion[0, 0]))) / degrees
        scale = float(np.abs(at_rest[:3, 3]).max()) or 1.0
        x, y, z = (float(shift) if abs(shift) > _NOISE * scale else 0.0 for shift in motion[:3, 3] / degrees)
        return cls(spin=spin if abs(spin) > _NOISE else 0.0, slide=(x, y, z))

    def most(self, extent: Array) -> float:
        """How many degrees (180 at most) the turn may go either way, until a part of that extent (3,) along its own
        axes has slid by half of its length."""
        slide = np.abs(self.slide)
        moving = slide > 0.0
        return float(min([180.0, *(0.5 * extent[moving] / slide[moving])]))


STEP = _STEP
AT_REST = Turning()

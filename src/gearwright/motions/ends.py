"""Where a motion starts and stops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..arrays import Array, ArrayLike


@dataclass(frozen=True, kw_only=True)
class Ends:
    """The parameters of a motion's two ends, the same for all section points.

    Between them v = (1 − t) start + t finish. Which surfaces they are is the motion's: planes of an extrusion; spheres,
    cones or planes of a radial sweep.
    """

    start: float
    finish: float

    def at(self, fraction: ArrayLike) -> Array:
        """Motion parameters v (...) at fractions t (...)."""
        t = np.asarray(fraction, float)
        return (1.0 - t) * self.start + t * self.finish

    @property
    def span(self) -> float:
        """dv/dt."""
        return self.finish - self.start

    def spans(self, breaks: Sequence[float]) -> tuple[Ends, ...]:
        """The ends of each smooth span, cut at a motion's breaks."""
        return tuple(Ends(start=a, finish=b) for a, b in pairwise((self.start, *breaks, self.finish)))


def between(start: float, finish: float) -> Ends:
    """Ends at two parameters."""
    return Ends(start=float(start), finish=float(finish))

"""How far a section reaches in a direction: its support function, exact to rounding."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..curves.curve import Curve, points_along

_SAMPLES = 33  # a curve; between neighbours an extreme is unique
_NEAREST = 3  # samples from which an extreme is sought: where curves join, it may lie beyond the best one


@dataclass(frozen=True, kw_only=True, eq=False)
class Support:
    """The support function h(d) = max d·p over the points p of curves.

    curves   the outer loop's
    points   (n, 2) samples of them on their convex hull
    origins  (n, 2) for each sample, the number of its curve and the fraction along it
    """

    curves: Sequence[Curve]
    points: Array
    origins: Array

    def roughly(self, directions: Array) -> Array:
        """h (...) of directions (..., 2), from the samples: for curves a little low."""
        return np.max(directions @ self.points.T, axis=-1)

    def exactly(self, direction: Array) -> tuple[float, Array]:
        """h of one direction (2,), and the point (2,) at which it is reached."""
        heights = self.points @ direction
        best = np.argsort(-heights)[:_NEAREST]
        candidates = [self._extreme(direction, *self.origins[i]) for i in best]
        point = max([self.points[best[0]], *candidates], key=lambda p: float(p @ direction))
        return float(point @ direction), point

    def _extreme(self, direction: Array, number: float, fraction: float) -> Array:
        """The point of one curve, near a sample, at which it is stationary along a direction; else the sample."""
        from scipy.optimize import brentq

        curve = self.curves[int(number)]

        def slope(f: float) -> float:
            return float(curve.derivative(curve.parameter(f)) @ direction)

        step = 1.0 / (_SAMPLES - 1)
        low, high = max(fraction - step, 0.0), min(fraction + step, 1.0)
        at = brentq(slope, low, high, xtol=1e-15) if slope(low) * slope(high) < 0.0 else fraction
        return curve.point(curve.parameter(at))


def support(curves: Sequence[Curve]) -> Support:
    """The support function of a closed chain of plane curves."""
    from scipy.spatial import ConvexHull

    fractions = np.linspace(0.0, 1.0, _SAMPLES)
    points = points_along(curves, fractions)
    origins = np.stack(np.meshgrid(np.arange(len(curves)), fractions, indexing="ij"), axis=-1).reshape(-1, 2)
    flat = points.reshape(-1, 2)
    hull = ConvexHull(flat).vertices
    return Support(curves=curves, points=flat[hull], origins=origins[hull])

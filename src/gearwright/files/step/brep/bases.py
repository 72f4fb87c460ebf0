"""Bases of splines over fractions 0…1 of a curve or of a motion, and interpolation in them.

The nodes are Greville's, the means of neighbouring knots: as many as poles, and each within its basis function, so that
there is always exactly one interpolant (Schoenberg & Whitney). The error falls with the sixth power of the span.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ....arrays import Array

DEGREE = 7
_SMOOTH = 1  # multiplicity of a knot between spans of one panel; between panels degree − 1, which leaves C¹


@dataclass(frozen=True)
class Basis:
    """B-splines over spans; one of degree 1 and a single span holds straight lines.

    breaks    ends of the spans, from 0 to 1
    panels    those at which what is interpolated is smooth but not analytic
    kinks     those at which its derivative jumps
    mirrored  whether the breaks are the same from either end: of edges that are used both ways
    """

    degree: int
    breaks: tuple[float, ...] = (0.0, 1.0)
    panels: tuple[float, ...] = ()
    kinks: tuple[float, ...] = ()
    mirrored: bool = False

    @cached_property
    def multiplicities(self) -> tuple[int, ...]:
        ends = self.degree + 1
        return (ends, *map(self._multiplicity, self.breaks[1:-1]), ends)

    def _multiplicity(self, knot: float) -> int:
        if knot in self.kinks:
            return self.degree
        return self.degree - 1 if knot in self.panels else _SMOOTH

    @cached_property
    def knots(self) -> Array:
        """All knots, repeated ones as often as they count."""
        return np.repeat(np.array(self.breaks), self.multiplicities)

    @cached_property
    def nodes(self) -> Array:
        """Fractions (n,) at which values are interpolated; the first is 0, the last 1."""
        windows = np.lib.stride_tricks.sliding_window_view(self.knots[1:-1], self.degree)
        nodes = windows.mean(axis=1)
        nodes[0], nodes[-1] = 0.0, 1.0
        return nodes

    @cached_property
    def checks(self) -> Array:
        """Fractions between the nodes, where an interpolant is farthest off."""
        steps = np.diff(self.nodes)[:, None] * np.array([0.25, 0.5, 0.75])
        return (self.nodes[:-1, None] + steps).ravel()

    def poles(self, values: Array, axis: int = 0) -> Array:
        """Poles (…, n, …) of the interpolant of values (…, n, …) at the nodes, along an axis."""
        from scipy.interpolate import make_interp_spline

        if self.degree == 1 and len(self.nodes) == 2:
            return values
        spline = make_interp_spline(self.nodes, values, k=self.degree, t=self.knots, axis=axis)
        poles = np.moveaxis(spline.c, 0, axis)
        # the ends are interpolated exactly, so that neighbours meet in the very same numbers
        for end in (0, -1):
            np.moveaxis(poles, axis, 0)[end] = np.moveaxis(values, axis, 0)[end]
        return np.asarray(poles)

    def values(self, poles: Array, fractions: Array, axis: int = 0) -> Array:
        """Values (…, k, …) of the spline of poles (…, n, …) at fractions (k,)."""
        from scipy.interpolate import BSpline

        found = BSpline(self.knots, np.moveaxis(poles, axis, 0), self.degree)(fractions)
        return np.asarray(np.moveaxis(found, 0, axis))

    @property
    def spans(self) -> int:
        return len(self.breaks) - 1

    def finer(self, too_far: Array) -> Basis:
        """The next one to try: spans are halved in which the interpolant is too far off at one of the checks (k,)."""
        if self.degree == 1:
            return replace(self, degree=DEGREE)
        breaks = np.array(self.breaks)
        bad = np.zeros(self.spans, bool)
        bad[np.clip(np.searchsorted(breaks, self.checks[too_far], side="right") - 1, 0, self.spans - 1)] = True
        if self.mirrored:
            bad |= bad[::-1]
        middles = (breaks[:-1] + breaks[1:])[bad] / 2.0
        return replace(self, breaks=tuple(np.sort(np.concatenate([breaks, middles])).tolist()))

    @property
    def narrowest(self) -> float:
        """The shortest span."""
        return float(np.diff(self.breaks).min())


COARSEST = Basis(1)
"""What straight lines at even speed need."""


def coarsest(panels: tuple[float, ...], kinks: tuple[float, ...], *, mirrored: bool) -> Basis:
    """The first basis to try for what has such panels."""
    return Basis(DEGREE if panels else 1, (0.0, *panels, 1.0), panels, kinks, mirrored)

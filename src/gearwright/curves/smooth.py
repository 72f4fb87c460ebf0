"""Functions of one variable known by their values alone, as piecewise Chebyshev series.

A callable that a person gives is sampled where it must be, until its series have converged; from then on its
values, derivatives and integrals are those of the series, to rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import chebyshev

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem

_DEGREE = 23
_TAIL = 3  # last coefficients that must be negligible
_DEEPEST = 48  # bisections: at a kink the tail falls with the width, at a jump never
_MOST_PIECES = 20_000
_NARROW = 1e-9  # of the interval: pieces narrower than this have closed in on a kink
_JUMP = 1e-9  # of the function's size: values of neighbouring pieces that differ by more where they meet
_BEND = 1e-7  # the same of their slopes, by the interval: rounding leaves some 1e-12

_NODES = np.cos(np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1))[::-1]
"""Roots of T_24: all inside, so that no piece ever looks beyond its ends."""
_TO_SERIES = np.linalg.inv(chebyshev.chebvander(_NODES, _DEGREE))


@dataclass(frozen=True, kw_only=True, eq=False)
class Smooth:
    """A function of x with m components.

    breaks        (k + 1,)     ends of the pieces
    coefficients  (k, n, m)    Chebyshev coefficients on each
    kinks         places inside at which a derivative jumps
    error         of the values, relative to the largest: what the series leave out
    evaluations   how many values of the function were taken
    """

    breaks: Array
    coefficients: Array
    kinks: tuple[float, ...] = ()
    error: float = 0.0
    evaluations: int = 0

    def value(self, x: ArrayLike) -> Array:
        """Values (..., m) at x (...)."""
        x = np.asarray(x, float)
        piece = np.clip(np.searchsorted(self.breaks, x, side="right") - 1, 0, len(self.coefficients) - 1)
        low, high = self.breaks[piece], self.breaks[piece + 1]
        local = (2.0 * x - low - high) / (high - low)
        count = self.coefficients.shape[1]
        series = chebyshev.chebvander(local.ravel(), count - 1).reshape(*local.shape, count)
        return np.asarray((series[..., None, :] @ self.coefficients[piece])[..., 0, :])

    @cached_property
    def derivative(self) -> Smooth:
        """The function's derivative."""
        scale = 2.0 / np.diff(self.breaks)[:, None, None]
        return replace(self, coefficients=scale * chebyshev.chebder(self.coefficients, axis=1))

    @cached_property
    def integral(self) -> Smooth:
        """The integral from the start, continuous from piece to piece."""
        scale = np.diff(self.breaks)[:, None, None] / 2.0
        series = scale * chebyshev.chebint(self.coefficients, lbnd=-1, axis=1)
        ends = np.cumsum(series.sum(axis=1), axis=0)  # every T_n is 1 at the end of a piece
        series[1:, 0] += ends[:-1]
        return replace(self, coefficients=series)


def smooth(
    function: Callable[[Array], Array],
    breaks: Sequence[float] | Array,
    *,
    tolerance: float,
    name: str,
    least: float = 0.0,
) -> Smooth:
    """The piecewise series of a function (n,) → (n, m) between the first and the last of the breaks.

    breaks      where pieces must end; the function may jump there
    tolerance   of the values, relative to the largest one or to `least`, whichever is larger
    name        what the function is called where it is refused

    Raises GeometryError where it is not finite, jumps, or is rougher than the tolerance asks.
    """
    found = _resolved(function, np.asarray(breaks, float), tolerance, name, least)
    narrow = _closed_in(found.breaks)
    if narrow:
        again = _resolved(function, np.unique([*breaks, *narrow]), tolerance, name, least)
        found = replace(again, evaluations=found.evaluations + again.evaluations)
    return replace(found, kinks=_kinks(found, np.asarray(breaks, float), tolerance, name, least))


def _resolved(function: Callable[[Array], Array], breaks: Array, tolerance: float, name: str, least: float) -> Smooth:
    open_, done, series = np.stack([breaks[:-1], breaks[1:]], axis=1), [], []
    scale, evaluations, error = least, 0, 0.0
    for _ in range(_DEEPEST):
        middle, half = open_.mean(axis=1)[:, None], (open_[:, 1:] - open_[:, :1]) / 2.0
        x = middle + half * _NODES
        values = _finite(np.asarray(function(x.ravel()), float), x.ravel(), name).reshape(*x.shape, -1)
        evaluations += x.size
        scale = max(scale, float(np.max(np.abs(values))))
        coefficients = _TO_SERIES @ values
        tails = np.max(np.abs(coefficients[:, -_TAIL:]), axis=(1, 2))
        good = tails <= tolerance * scale
        error = max(error, float(np.max(tails[good], initial=0.0)) / (scale or 1.0))
        done.append(open_[good])
        series.append(coefficients[good])
        rough = open_[~good]
        if not len(rough):
            break
        if len(rough) > _MOST_PIECES:
            raise _rough(name, rough, tolerance, "everywhere, about")
        centres = rough.mean(axis=1)
        open_ = np.concatenate([np.stack([rough[:, 0], centres], axis=1), np.stack([centres, rough[:, 1]], axis=1)])
    else:
        raise _rough(name, open_, tolerance, "near")
    intervals = np.concatenate(done)
    order = np.argsort(intervals[:, 0])
    return Smooth(
        breaks=np.append(intervals[order, 0], breaks[-1]),
        coefficients=np.concatenate(series)[order],
        error=error,
        evaluations=evaluations,
    )


def _finite(values: Array, x: Array, name: str) -> Array:
    bad = np.flatnonzero(~np.isfinite(values).all(axis=tuple(range(1, values.ndim))))
    if len(bad):
        at = float(x[bad[0]])
        raise GeometryError(
            f"The {name} cannot be used", [Problem(f"its value at {at:.6g}", "is not finite; it must be everywhere")]
        )
    return values


def _rough(name: str, intervals: Array, tolerance: float, where: str) -> GeometryError:
    at = float(intervals[0].mean())
    return GeometryError(
        f"The {name} cannot be used",
        [
            Problem(
                f"{where} {at:.6g}",
                f"it jumps, or is rougher than the tolerance of {tolerance:.1g} × its size lets it be; smooth it there",
            )
        ],
    )


def _closed_in(breaks: Array) -> tuple[float, ...]:
    """Where runs of narrow pieces have closed in on something, but for the ends: the middles of their narrowest."""
    start, stop, widths = breaks[0], breaks[-1], np.diff(breaks)
    narrow = np.flatnonzero(widths <= _NARROW * (stop - start))
    runs = np.split(narrow, np.flatnonzero(np.diff(narrow) > 1) + 1) if len(narrow) else []
    narrowest = [run[np.argmin(widths[run])] for run in runs]
    middles = ((breaks[i] + breaks[i + 1]) / 2.0 for i in narrowest)
    margin = 10.0 * _NARROW * (stop - start)
    return tuple(float(x) for x in middles if start + margin < x < stop - margin)


def _kinks(found: Smooth, given: Array, tolerance: float, name: str, least: float) -> tuple[float, ...]:
    """Breaks at which the derivative jumps. Raises GeometryError where the function does, but at given breaks."""
    if len(found.breaks) == 2:
        return ()
    slopes = found.derivative.coefficients
    signs = (-1.0) ** np.arange(_DEGREE + 1)
    steps, bends = (
        np.max(np.abs(np.tensordot(signs[: c.shape[1]], c[1:], (0, 1)) - c[:-1].sum(axis=1)), axis=1)
        for c in (found.coefficients, slopes)
    )
    scale = max(least, float(np.max(np.abs(found.coefficients).sum(axis=1))))
    jumps = np.flatnonzero((steps > max(_JUMP, 100.0 * tolerance) * scale) & ~np.isin(found.breaks[1:-1], given))
    if len(jumps):
        raise _rough(name, np.repeat(found.breaks[1 + jumps[:1], None], 2, axis=1), tolerance, "near")
    width = found.breaks[-1] - found.breaks[0]
    return tuple(found.breaks[1:-1][bends * width > max(_BEND, 1e4 * tolerance) * scale].tolist())

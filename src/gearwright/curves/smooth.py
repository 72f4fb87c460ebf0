"""Functions of one variable known by their values alone, as piecewise Chebyshev series.

A callable that a person gives is sampled where it must be, until its series have converged; from then on its
values, derivatives and integrals are those of the series, to rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem

_DEGREE = 23
_TAIL = 3  # last coefficients that must be negligible
_DEEPEST = 48  # bisections: at a kink the tail falls with the width, at a jump never
_MOST_PIECES = 20_000
_UNDERFLOW = float(np.finfo(float).tiny / np.finfo(float).eps)  # values below it have lost digits, and are nought
_NARROW = 1e-9  # of the interval: pieces narrower than this have closed in on a kink
_JUMP = 1e-9  # of the function's size: values of neighbouring pieces that differ by more where they meet
_BEND = 1e-7  # the same of their slopes, by the interval: rounding leaves some 1e-12

_LOOKS = 200  # places at which the whole is looked at once more
_MISS = 100.0  # tolerances by which a series may miss the function there: noise adds up over its terms

Flags = NDArray[np.bool_]

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

    breaks: Array = field(repr=False)
    coefficients: Array = field(repr=False)
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


def lowest(function: Callable[[float], float], x: Array, values: Array, most: int = 8) -> float:
    """Where a function is least: near the lowest of the samples, values at x (n,), that are below their neighbours."""
    from scipy.optimize import minimize_scalar

    around = np.concatenate([[np.inf], values, [np.inf]])
    lows = np.flatnonzero((values <= around[:-2]) & (values <= around[2:]))
    found = [float(x[np.argmin(values)])]
    for i in lows[np.argsort(values[lows])][:most]:
        low, high = x[max(i - 1, 0)], x[min(i + 1, len(x) - 1)]
        options = {"xatol": 1e-12 * (high - low)}
        found.append(float(minimize_scalar(function, bounds=(low, high), method="bounded", options=options).x))
    return min(found, key=function)


def smooth(
    function: Callable[[Array], Array],
    breaks: Sequence[float] | Array,
    *,
    tolerance: float,
    name: str,
    least: float = 0.0,
    groups: Sequence[int] = (),
) -> Smooth:
    """The piecewise series of a function (n,) → (n, m) between the first and the last of the breaks.

    breaks      where pieces must end; the function may jump there
    tolerance   of the values, relative to the largest one or to `least`, whichever is larger
    name        what the function is called where it is refused
    groups      for each component, the number of the group whose largest value it is measured by; () for one group

    A piece is accepted when its last coefficients are negligible and the series meets the function at other points,
    no farther apart than 1/200 of the whole. What is narrower and falls between them, nobody can see.
    Raises GeometryError where it is not finite, jumps, or is rougher than the tolerance asks.
    """
    asked = _Asked(function=function, tolerance=tolerance, name=name, least=least, groups=tuple(groups))
    found = _resolved(asked, np.asarray(breaks, float))
    narrow = _closed_in(found.breaks)
    if narrow:
        again = _resolved(asked, np.unique([*breaks, *narrow]))
        found = replace(again, evaluations=found.evaluations + again.evaluations)
    return replace(found, kinks=_kinks(found, np.asarray(breaks, float), tolerance, name, least))


@dataclass(frozen=True, kw_only=True)
class _Asked:
    """What `smooth` was asked for."""

    function: Callable[[Array], Array]
    tolerance: float
    name: str
    least: float
    groups: tuple[int, ...]

    def values(self, x: Array) -> Array:
        """Values (..., m) at x (...)."""
        found = np.asarray(self.function(x.ravel()), float)
        return _finite(found, x.ravel(), self.name).reshape(*x.shape, -1)

    def by_group(self, largest: Array) -> Array:
        """For each component (m,) the largest value of its group."""
        groups = np.array(self.groups or [0] * len(largest))
        return np.array([max(self.least, _UNDERFLOW, float(np.max(largest[groups == g]))) for g in groups])


def _resolved(asked: _Asked, breaks: Array) -> Smooth:
    open_, done, series = np.stack([breaks[:-1], breaks[1:]], axis=1), [], []
    largest, evaluations, error = np.zeros(1), 0, 0.0
    for _ in range(_DEEPEST):
        middle, half = open_.mean(axis=1)[:, None], (open_[:, 1:] - open_[:, :1]) / 2.0
        values = asked.values(middle + half * _NODES)
        evaluations += values[..., 0].size
        largest = np.maximum(largest, np.max(np.abs(values), axis=(0, 1)))
        scale = asked.by_group(largest)
        coefficients = _TO_SERIES @ values
        tails = np.max(np.abs(coefficients[:, -_TAIL:]) / scale, axis=(1, 2))
        good = tails <= asked.tolerance
        looks = _looks(open_[good], breaks[-1] - breaks[0])
        evaluations += looks.size
        good[good] = _met(asked, open_[good], coefficients[good], looks, scale)
        error = max(error, float(np.max(tails[good], initial=0.0)))
        done.append(open_[good])
        series.append(coefficients[good])
        rough = open_[~good]
        if not len(rough):
            break
        if len(rough) > _MOST_PIECES:
            raise _rough(asked.name, rough, asked.tolerance, "everywhere, about")
        centres = rough.mean(axis=1)
        open_ = np.concatenate([np.stack([rough[:, 0], centres], axis=1), np.stack([centres, rough[:, 1]], axis=1)])
    else:
        raise _rough(asked.name, open_, asked.tolerance, "near")
    intervals = np.concatenate(done)
    order = np.argsort(intervals[:, 0])
    return Smooth(
        breaks=np.append(intervals[order, 0], breaks[-1]),
        coefficients=np.concatenate(series)[order],
        error=error,
        evaluations=evaluations,
    )


def _looks(intervals: Array, whole: float) -> Array:
    """Further places (k, n) in each interval (k, 2), uneven ones, as close together as the widest interval needs."""
    if not len(intervals):
        return np.empty((0, 0))
    count = 2 + int(np.ceil(_LOOKS * np.max(np.diff(intervals, axis=1)) / whole))
    uneven = (np.arange(count) + 0.5 + 0.3 * np.sin(7.0 * np.arange(count))) / count
    return intervals[:, :1] + np.diff(intervals, axis=1) * uneven


def _met(asked: _Asked, intervals: Array, coefficients: Array, looks: Array, scale: Array) -> Flags:
    """Whether each interval's series (k,) meets the function at the further places."""
    if not len(intervals):
        return np.zeros(0, bool)
    local = (2.0 * looks - intervals.sum(axis=1, keepdims=True)) / np.diff(intervals, axis=1)
    series = chebyshev.chebvander(local.ravel(), _DEGREE).reshape(*local.shape, -1)
    misses = np.abs(series @ coefficients - asked.values(looks)) / scale
    return np.asarray(np.max(misses, axis=(1, 2)) <= _MISS * asked.tolerance)


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

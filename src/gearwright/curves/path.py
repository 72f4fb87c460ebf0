"""Paths in space, along which sections are swept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem
from .curve import Curve
from .smooth import Smooth, lowest, smooth
from .spline import spline_spans

_TOLERANCE = 1e-14  # of the series of a path, relative to its coordinates
_MEETING = 1e-9  # of the path's extent: ends no farther apart meet
_CORNER = 1e-6  # radians; tangents that differ by more make a corner
_STANDSTILL = 1e-7  # of the mean speed

_NEEDED = "points (n, 3) for u (n,) are needed, or one point (3,) for one u"

_BERNSTEIN_TO_CHEBYSHEV = (
    np.array([[10.0, 6.0, 6.0, 10.0], [-15.0, -3.0, 3.0, 15.0], [6.0, -6.0, -6.0, 6.0], [-1.0, 3.0, -3.0, 1.0]]) / 32.0
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Path(Curve):
    """A smooth curve in space; u runs from 0 to 1.

    series   c(u), three components, piecewise

    Raises GeometryError where the path stands still or has a corner.
    """

    series: Smooth
    interval: tuple[float, float] = (0.0, 1.0)

    def __post_init__(self) -> None:
        problems = self._standstills() or self._corners()
        if problems:
            raise GeometryError("The path cannot be used", problems)

    @property
    def panels(self) -> tuple[float, ...]:
        start, stop = self.interval
        fractions = (self.series.breaks - start) / (stop - start)
        return tuple(np.sort(fractions[(fractions > 0.0) & (fractions < 1.0)]).tolist())

    def point(self, u: ArrayLike) -> Array:
        return self.series.value(u)

    def derivative(self, u: ArrayLike) -> Array:
        return self.series.derivative.value(u)

    def second_derivative(self, u: ArrayLike) -> Array:
        """d² point / du², (..., 3)."""
        return self.series.derivative.derivative.value(u)

    def tangent(self, u: ArrayLike) -> Array:
        """Unit tangents t (..., 3)."""
        rate = self.derivative(u)
        return rate / np.linalg.norm(rate, axis=-1, keepdims=True)

    def tangent_rate(self, u: ArrayLike) -> Array:
        """dt/du (..., 3) = (c″ − t (t·c″)) / |c′|: the curvature vector times the speed."""
        rate, second = self.derivative(u), self.second_derivative(u)
        speed = np.linalg.norm(rate, axis=-1, keepdims=True)
        tangent = rate / speed
        return (second - tangent * np.sum(tangent * second, axis=-1, keepdims=True)) / speed

    @cached_property
    def closed(self) -> bool:
        """Whether the ends meet. That they meet without a corner was seen to when the path was made."""
        return self._gap() <= _MEETING * self._extent()

    @cached_property
    def length_to(self) -> Smooth:
        """Arc length from the start as a function of u."""

        def speed(u: Array) -> Array:
            return np.linalg.norm(self.derivative(u), axis=-1)[:, None]

        return smooth(speed, self.series.breaks, tolerance=_TOLERANCE, name="path's speed").integral

    @property
    def length(self) -> float:
        return float(self.length_to.value(1.0)[0])

    def _gap(self) -> float:
        return float(np.linalg.norm(self.point(1.0) - self.point(0.0)))

    def _extent(self) -> float:
        return float(np.max(np.ptp(self.point(np.linspace(0.0, 1.0, 257)), axis=0)))

    def _standstills(self) -> list[Problem]:
        u = np.unique([*np.linspace(0.0, 1.0, 1025), *self.series.breaks])
        speeds = np.linalg.norm(self.derivative(u), axis=-1)
        if speeds.mean() <= _STANDSTILL * float(np.max(np.abs(self.point(u)))):
            return [Problem("the whole path", "it stays where it is; it must lead somewhere")]
        slowest = lowest(lambda x: float(np.linalg.norm(self.derivative(x))), u, speeds)
        if np.linalg.norm(self.derivative(slowest)) > _STANDSTILL * speeds.mean():
            return []
        place = np.round(self.point(slowest), 6).tolist()
        return [
            Problem(f"u = {slowest:.6g} at {place}", "it stands still there, or turns back; let it move on at every u")
        ]

    def _corners(self) -> list[Problem]:
        inner = self.series.breaks[1:-1]
        before, after = np.nextafter(inner, 0.0), inner
        where = [*inner, 0.0] if self.closed else [*inner]
        if self.closed:
            before, after = np.append(before, 1.0), np.append(after, 0.0)
        sines = np.linalg.norm(np.cross(self.tangent(before), self.tangent(after)), axis=-1)
        cosines = np.sum(self.tangent(before) * self.tangent(after), axis=-1)
        angles = np.arctan2(sines, cosines)
        return [
            Problem(
                f"u = {where[i]:.6g} at {np.round(self.point(where[i]), 6).tolist()}",
                f"it has a corner of {np.degrees(angles[i]):.3g}° there; round it, or sweep the legs apart",
            )
            for i in np.flatnonzero(angles > _CORNER)[:3]
        ]


def path_through(points: ArrayLike) -> Path:
    """The cubic spline through points (n, 3), n ≥ 2; closed and periodic where the last point is the first again.

    Raises GeometryError, all problems together.
    """
    found = _points(points)
    size = float(np.max(np.ptp(found, axis=0)))
    closed = len(found) > 3 and float(np.linalg.norm(found[-1] - found[0])) <= _MEETING * size
    if closed:
        found = np.concatenate([found[:-1], found[:1]])
    steps = np.linalg.norm(np.diff(found, axis=0), axis=1)
    still = np.flatnonzero(steps <= _MEETING * size)
    if len(still):
        place = np.round(found[still[0]], 6).tolist()
        raise GeometryError(
            "The path cannot be used",
            [Problem(f"points {still[0]} and {still[0] + 1} at {place}", "coincide; leave one of them out")],
        )
    control = np.array([span.control for span in spline_spans(found, closed=closed)])
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    return Path(series=Smooth(breaks=knots / knots[-1], coefficients=_BERNSTEIN_TO_CHEBYSHEV @ control))


def path_of(function: Callable[[Array], ArrayLike], tolerance: float = _TOLERANCE) -> Path:
    """The path c(u), u from 0 to 1, of a function (n,) → (n, 3), or u → (3,).

    tolerance   of the function's values, relative to the largest one: what rounding leaves of them

    Raises GeometryError where it gives something else, or is not smooth.
    """
    return Path(series=smooth(_by_array(function), [0.0, 1.0], tolerance=tolerance, name="path"))


def _by_array(function: Callable[[Array], ArrayLike]) -> Callable[[Array], Array]:
    """The function for arrays (n,), one by one where it takes no arrays."""

    def one_by_one(u: Array) -> Array:
        return np.array([np.asarray(function(x), float) for x in u])

    def checked(u: Array) -> Array:
        try:
            points = one_by_one(u) if alone else np.asarray(function(u), float)
        except Exception as error:  # whatever a person's function may raise
            problem = Problem(f"path({u[0]:.6g}) or near fails: {type(error).__name__}: {error}", _NEEDED)
            raise GeometryError("The path cannot be used", [problem]) from error
        if points.shape != (len(u), 3):
            problem = Problem(f"path(u) of shape {points.shape} for {len(u)} values of u", _NEEDED)
            raise GeometryError("The path cannot be used", [problem])
        return points

    alone = False
    try:
        alone = np.shape(function(np.array([0.3, 0.6]))) != (2, 3)
    except Exception:  # noqa: BLE001  a person's function; it may take one u at a time
        alone = True
    checked(np.array([0.3, 0.6]))
    return checked


def _points(points: ArrayLike) -> Array:
    try:
        found = np.array(points, float)
    except (TypeError, ValueError) as error:
        problem = Problem("points", f"an array (n, 3) of numbers is needed ({error})")
        raise GeometryError("The path cannot be used", [problem]) from error
    if found.ndim != 2 or found.shape[1:] != (3,) or len(found) < 2:
        problem = Problem(f"points of shape {found.shape}", "at least two points (n, 3) are needed")
        raise GeometryError("The path cannot be used", [problem])
    bad = np.flatnonzero(~np.isfinite(found).all(axis=1))
    if len(bad):
        problem = Problem(f"point {bad[0]} = {found[bad[0]].tolist()}", "coordinates must be finite")
        raise GeometryError("The path cannot be used", [problem])
    return found

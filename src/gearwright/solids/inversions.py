"""Where a motion would turn a section inside out: the sign of the volume element over the whole section."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array
from ..curves.curve import along
from ..curves.smooth import lowest, smooth
from ..errors import Problem
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..sections.plane import Section
from ..sections.section import LoopedSection

_STATIONS = 72  # a piece of the series of the volume element, thrice their degree
_RESOLVED = 1e-7  # of the volume element, by its series
_MOST_DIPS = 24  # looked at closely
_FAR = 0.5  # of the greatest volume element: what stays above it comes nowhere near nought
_STILL = 1e-14  # of the mean volume element: points on an axis, to rounding
_DOUBTFUL = 0.02  # of the section's share in the volume element: more than samples on its curves can miss
_NOUGHT = 1e-12  # of the mean volume element
_EVEN = 1e-11  # of the mean volume element: rounding of what does not change along the motion
_SAME = 1e-9  # of the section's size
_SAMPLES = 8  # points a curve, where the volume element is not linear in them


def inversions(section: LoopedSection, motion: Motion, ends: Ends) -> list[Problem]:
    """What is wrong with moving the section so; empty where the volume element is positive everywhere.

    For plane sections it is linear in the section point, J = j + k·p, so that its least value at a parameter is
    j − h(−k) with the section's support function h: exact. Its minimum over the parameter is bracketed.
    """
    if not isinstance(section, Section):
        return _sampled(section, motion, ends)
    least = _Least(section, motion)
    stations = _stations(least, motion, ends.start, ends.finish)
    rough, doubt = least.roughly(stations)
    scale = float(np.mean(np.abs(rough) + doubt))
    limit = -_STILL * scale if motion.has_still_points else _NOUGHT * scale
    if np.min(rough - _DOUBTFUL * doubt) > _FAR * np.max(rough):
        return []
    steady = np.ptp(least.coefficients(stations), axis=0).max() <= _EVEN * scale  # as of a revolution or a helix
    worst = float(stations[0]) if steady else lowest(lambda v: least.exactly(v)[0], stations, rough, _MOST_DIPS)
    value, point = least.exactly(worst)
    if value > limit:
        return _pinches(section, motion, worst, _STILL * scale) if motion.has_still_points else []
    place = np.round(motion.place(point, worst), 6).tolist()
    where = f"section point {np.round(point, 6).tolist()} at {motion.station(worst)}, {place} in space"
    first, last = _range(lambda v: least.exactly(v)[0] - limit, stations, worst)
    around = f"; it is so from {motion.station(first)} to {motion.station(last)}" if first < last else ""
    return [Problem(where, motion.remedy(point, worst) + around)]


def _pinches(section: Section, motion: Motion, v: float, nought: float) -> list[Problem]:
    """Places that do not move and where the section is but a point: the body would be pinched to nothing there."""
    curves = section.loops[0].with_copies(1).curves
    points, _ = along(curves, np.linspace(0.0, 1.0, 2 * _SAMPLES + 1))
    elements: Array = motion.jacobian(points, np.full(points.shape[:2], v))
    still = np.asarray(np.abs(elements) <= nought)
    whole = np.asarray(still.all(axis=1))  # a curve along the axis
    joint = still[:, 0] & ~whole & ~np.roll(whole, 1)
    alone = still[:, 1:-1] & ~whole[:, None]
    found = [*points[joint, 0], *points[:, 1:-1][alone]]
    value, touch = _Least(section, motion).exactly(v)
    near_end = np.min(np.linalg.norm(points[still] - touch, axis=-1), initial=np.inf) <= _SAME * section.size
    if not found and not near_end and not whole.any() and value <= nought:
        found = [touch]
    return [
        Problem(
            f"section point {np.round(point, 6).tolist()}",
            "touches the axis at this one point, where the body would be pinched to nothing; keep the section clear of"
            " the axis, or let it run along it",
        )
        for point in found[:1]
    ]


class _Least:
    """The least volume element of a section at parameters of a motion."""

    def __init__(self, section: Section, motion: Motion):
        self._section = section
        self._motion = motion
        self._middle, self._size = section.middle, section.size

    def _linear(self, v: Array) -> tuple[Array, Array]:
        """J (n,) at the middle of the section, and its slopes k (n, 2)."""
        shape = (len(v), 2)
        at = [
            self._motion.jacobian(np.broadcast_to(self._middle + step, shape), v)
            for step in self._size * np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
        ]
        return at[0], np.stack([at[1] - at[0], at[2] - at[0]], axis=-1) / self._size

    def coefficients(self, v: Array) -> Array:
        """J at the middle of the section, and what the slopes make of its size (n, 3)."""
        middle, slopes = self._linear(v)
        return np.concatenate([middle[:, None], slopes * self._size], axis=1)

    def roughly(self, v: Array) -> tuple[Array, Array]:
        """Least J (n,), from samples of the section, and the section's share in it (n,)."""
        middle, slopes = self._linear(v)
        if not np.any(slopes):
            return middle, np.zeros(len(v))
        reach = self._section.support.roughly(-slopes) + slopes @ self._middle
        return middle - reach, np.linalg.norm(slopes, axis=1) * self._size

    def exactly(self, v: float) -> tuple[float, Array]:
        """Least J and the section point (2,) that has it."""
        (middle,), (slope,) = self._linear(np.array([v]))
        if not np.any(slope):
            return float(middle), self._middle
        reach, point = self._section.support.exactly(-slope)
        return float(middle - reach - slope @ self._middle), point


def _stations(least: _Least, motion: Motion, start: float, finish: float) -> Array:
    """Parameters so close together that the volume element has no dip between two of them.

    Its coefficients j and k are resolved by series; polynomials of their degree have no features narrower than that.
    """
    breaks = np.array([start, *motion.panels(start, finish), finish])
    series = smooth(least.coefficients, breaks, tolerance=_RESOLVED, name="motion's volume element")
    fractions = (
        1.0 - np.cos(np.pi * np.arange(_STATIONS) / _STATIONS)
    ) / 2.0  # denser at the ends, as its features are
    inner = series.breaks[:-1, None] + np.diff(series.breaks)[:, None] * fractions
    return np.append(inner.ravel(), finish)


def _range(excess: Callable[[float], float], stations: Array, worst: float) -> tuple[float, float]:
    """The parameters around the worst one between which the volume element is not positive."""
    from scipy.optimize import brentq

    ends = []
    for beyond in (stations[stations < worst][::-1], stations[stations > worst]):
        inside = worst
        for v in beyond:
            if excess(float(v)) > 0.0:
                inside = float(brentq(excess, inside, float(v))) if excess(inside) < 0.0 else inside
                break
            inside = float(v)
        ends.append(inside)
    return ends[0], ends[1]


def _sampled(section: LoopedSection, motion: Motion, ends: Ends) -> list[Problem]:
    """The same at points all along the section and three stations of the motion."""
    points = np.concatenate([loop.quadrature(_SAMPLES)[0] for loop in section.loops])
    problems = []
    for fraction in (0.0, 0.5, 1.0):
        stations = ends.at(np.full(len(points), fraction))
        elements = motion.jacobian(points, stations)
        worst = int(np.argmin(elements))
        if elements[worst] < 0.0:
            where = f"section point {np.round(points[worst], 6).tolist()} at parameter {stations[worst]:.6g}"
            problems.append(Problem(where, motion.remedy(points[worst], float(stations[worst]))))
    return problems

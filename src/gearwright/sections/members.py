"""The members of a section that varies along its motion: their moments, many at once, and whether they are sound.

A section whose loops hold families is named by its reference; its member at a parameter v is `section.at(v)`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array
from ..errors import GeometryError, Problem
from ..moments.boundary_integral import plane_moments
from ..moments.quadrature import converged, gauss_legendre
from .loop import Loop
from .plane import Section
from .section import LoopedSection

_AT_ONCE = 32  # members
_LOOKS = 9  # a polynomial of a lower degree cannot leave its bounds unseen at more places than it has turns


def member_moments(section: Section, v: Array) -> tuple[Array, float]:
    """Moments m[a, b] (n, 4, 4) to order 3 of the members at parameters (n,), about `section.middle`, and their error.

    The error is relative, in the unit of `section.size`.
    """
    parts = [_converged(section, block) for block in np.array_split(v, -(-len(v) // _AT_ONCE))]
    powers = np.add.outer(np.arange(4), np.arange(4))
    scaled = np.concatenate([values for values, _ in parts])
    return scaled * section.size ** (2.0 + powers), max(error for _, error in parts)


def _converged(section: Section, v: Array) -> tuple[Array, float]:
    loops = [loop if section.order > 1 else loop.with_copies(1) for loop in section.loops]

    def integral(nodes: int) -> Array:
        found = np.zeros((len(v), 4, 4))
        for loop in loops:
            points, tangents = member_quadrature(loop, v, nodes)
            found += plane_moments((points - section.middle) / section.size, tangents / section.size, loop.copies)
        return found

    return converged(integral)


def member_quadrature(loop: Loop, v: Array, nodes: int) -> tuple[Array, Array]:
    """Gauss–Legendre points and weighted tangents (n, m, d) of one period of the members at parameters (n,)."""
    x, w = gauss_legendre(nodes)
    points, tangents = [], []
    for curve in loop.curves:
        member, (a, b) = curve.at(v[:, None]), curve.interval
        u = np.broadcast_to(curve.parameter((x + 1.0) / 2.0), (len(v), nodes))
        points.append(member.point(u))
        tangents.append(member.derivative(u) * ((b - a) / 2.0 * w)[:, None])
    return np.concatenate(points, axis=1), np.concatenate(tangents, axis=1)


def looks(section: LoopedSection, start: float, finish: float) -> Array:
    """Parameters at which members are looked at: both ends, between them, and where what varies turns back."""
    even = (start + finish) / 2.0 - (finish - start) / 2.0 * np.cos(np.linspace(0.0, np.pi, _LOOKS))
    turns = [v for loop in section.loops for curve in loop.curves for v in curve.extremes(start, finish)]
    return np.unique([start, finish, *even[1:-1], *turns])


def first_unsound(section: LoopedSection, stations: Sequence[float] | Array) -> tuple[float, list[Problem]] | None:
    """The first of the parameters whose member has gaps, runs the wrong way or crosses itself, and what is wrong."""
    for v in stations:
        try:
            section.at(float(v)).require_simple()
        except GeometryError as error:
            return float(v), list(error.problems)
    return None

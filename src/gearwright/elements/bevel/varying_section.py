"""Outlines on the sphere that change from level to level, from their members at some levels."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...curves.interpolated import chebyshev_stations, interpolated
from ...errors import GeometryError, Problem
from ...sections.loop import Loop

_DEGREES = (8, 12, 16, 24, 32, 48)
_MET = 1e-12  # of the unit sphere
_FRACTIONS = np.linspace(0.0, 1.0, 9)


def varying_loop(member: Callable[[float], Loop], start: float, finish: float) -> Loop:
    """The loop whose member at every parameter between two is the one given, to 1e-12 of the sphere's radius.

    Members are interpolated by polynomials of a degree at which those halfway between the known ones are met.
    Raises GeometryError where none is, since members change their curves, or bend, on the way.
    """
    looks = start + (finish - start) * np.array([0.03, 0.21, 0.53, 0.87])
    expected = [member(float(v)) for v in looks]
    apart = np.inf
    for degree in _DEGREES:
        stations = chebyshev_stations(start, finish, degree)
        members = [member(float(v)) for v in stations]
        if not _alike([*members, *expected]):
            break
        found = _through(members, stations.tolist())
        apart = max(_apart(found, float(v), one) for v, one in zip(looks, expected, strict=True))
        if apart <= _MET:
            return found
    message = (
        "the teeth change their kind on the way"
        if not np.isfinite(apart)
        else f"the teeth do not change evenly, but to {apart:.1g} of the cone distance"
    )
    raise GeometryError(
        "The teeth cannot vary so",
        [Problem("from the inner to the outer end", f"{message}; take another dedendum or taper")],
    )


def _alike(members: list[Loop]) -> bool:
    """Whether all have the same number of curves."""
    return len({len(loop.curves) for loop in members}) == 1


def _through(members: list[Loop], stations: list[float]) -> Loop:
    return Loop(curves=interpolated([loop.curves for loop in members], stations), copies=members[0].copies)


def _apart(loop: Loop, v: float, member: Loop) -> float:
    """Greatest distance of points of the same fractions of the same curves of a loop at v and of a member."""
    return max(
        float(np.max(np.abs(a.at(v).point(a.parameter(_FRACTIONS)) - b.point(b.parameter(_FRACTIONS)))))
        for a, b in zip(loop.curves, member.curves, strict=True)
    )

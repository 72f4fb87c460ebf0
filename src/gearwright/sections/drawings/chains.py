"""Loose curves, in any order and sense, joined end to end into closed chains."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...arrays import Array, Indices
from ...curves.curve import Curve
from ...errors import GeometryError, Problem
from .listing import first_few, place
from .sheet import samples

JOINT = 5e-6
"""Ends so near, relative to the drawing's longer side, are one point.

Programs write six decimals or more, and the ends of an arc follow from its centre, radius and angles, each
rounded: about 1e-6 apart in a drawing of size 1. A gap one can see, or one left by drawing without snapping
to the end, is a hundred times wider and is refused.
"""


def joint_tolerance(curves: Sequence[Curve]) -> float:
    """The distance within which ends of these curves meet."""
    points = samples(tuple(curves), np.linspace(0.0, 1.0, 9)).reshape(-1, 2)
    return JOINT * float(np.max(np.ptp(points, axis=0)))


def long_enough(curves: Sequence[Curve], tolerance: float) -> list[Curve]:
    """The curves that reach farther than the tolerance; the others join nothing to nothing."""
    points = samples(tuple(curves), np.linspace(0.0, 1.0, 5))
    far = np.linalg.norm(points - points[:, :1], axis=2).max(axis=1) > tolerance
    return [curve for curve, keep in zip(curves, far, strict=True) if keep]


def closed_chains(curves: Sequence[Curve], tolerance: float) -> tuple[tuple[Curve, ...], ...]:
    """Closed chains of curves, each from the end of the one before it; gaps within the tolerance remain.

    Raises GeometryError naming every curve that is drawn twice; else every end that meets no other or
    more than one.
    """
    points = samples(tuple(curves), np.array([0.0, 0.5, 1.0]))
    _refuse(_twins(points, tolerance))
    ends = points[:, ::2].reshape(-1, 2)
    pairs = _pairs(ends, tolerance)
    meets = np.bincount(pairs.ravel(), minlength=len(ends))
    _refuse(_crowds(ends, pairs, meets) + _loose(ends[meets == 0], tolerance))
    partner = np.empty(len(ends), int)
    partner[pairs], partner[pairs[:, ::-1]] = pairs[:, ::-1], pairs
    return tuple(_walks(curves, partner))


def _walks(curves: Sequence[Curve], partner: Indices) -> list[tuple[Curve, ...]]:
    """Chains by walking from end to end; end 2k is the start of curve k, end 2k + 1 its end."""
    chains, seen = [], np.zeros(len(curves), bool)
    for first in range(len(curves)):
        chain, end = [], 2 * first
        while not seen[end // 2]:
            seen[end // 2] = True
            curve = curves[end // 2]
            chain.append(curve.reversed() if end % 2 else curve)
            end = int(partner[end ^ 1])
        if chain:
            chains.append(tuple(chain))
    return chains


def _pairs(points: Array, tolerance: float) -> Indices:
    """Pairs (n, 2) of points within the tolerance."""
    from scipy.spatial import cKDTree

    return cKDTree(points).query_pairs(tolerance, output_type="ndarray")


def _twins(points: Array, tolerance: float) -> list[Problem]:
    """Curves with the same ends and middle as another one, in either sense."""
    n = len(points)
    both = np.concatenate([points, points[:, ::-1]]).reshape(2 * n, 6)
    pairs = np.unique(np.sort(_pairs(both, tolerance) % n, axis=1), axis=0)
    return [
        Problem(
            f"drawn twice: the curve from {place(a)} by way of {place(m)} to {place(b)}",
            "an outline passes every place once; delete one of the two, or both if they are a line there and back",
        )
        for a, m, b in points[np.unique(pairs[pairs[:, 0] != pairs[:, 1]][:, :1])]
    ]


def _crowds(ends: Array, pairs: Indices, meets: Indices) -> list[Problem]:
    """Places where three ends or more meet, each once."""
    problems, named = [], np.zeros(len(ends), bool)
    neighbours: dict[int, list[int]] = {}
    for a, b in pairs[(meets[pairs] > 1).any(axis=1)].tolist():
        neighbours.setdefault(a, [a]).append(b)
        neighbours.setdefault(b, [b]).append(a)
    for end in np.flatnonzero(meets > 1):
        if not named[end]:
            together = neighbours[int(end)]
            named[together] = True
            problems.append(
                Problem(
                    f"{len(together)} ends of curves meet at {place(ends[end])}",
                    "an outline goes on in one way only; delete the lines that do not bound the section, or read "
                    "the outline's layer alone",
                )
            )
    return problems


def _loose(ends: Array, tolerance: float) -> list[Problem]:
    """Ends that meet no other, each with the nearest of its kind."""
    from scipy.spatial import cKDTree

    if len(ends) < 2:
        return [_gap(end, None, tolerance) for end in ends]
    distances, nearest = cKDTree(ends).query(ends, k=2)
    problems, named = [], np.zeros(len(ends), bool)
    for i in np.argsort(distances[:, 1], kind="stable"):
        if not named[i]:
            j = int(nearest[i, 1])
            named[[i, j]] = True
            problems.append(_gap(ends[i], ends[j], tolerance))
    return problems


def _gap(end: Array, other: Array | None, tolerance: float) -> Problem:
    if other is None:
        return Problem(f"open end at {place(end)}", "no other open end is left to join it to; close the outline there")
    return Problem(
        f"open ends at {place(end)} and {place(other)}, {np.linalg.norm(end - other):.3g} apart",
        f"ends within {tolerance:.3g} ({JOINT:g} of the drawing's size) are joined; close the outline there, or "
        "delete the line if it bounds nothing",
    )


def _refuse(problems: list[Problem]) -> None:
    if problems:
        raise GeometryError("The curves do not form closed loops", first_few(problems))

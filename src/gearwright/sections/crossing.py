"""Whether the loops of a section cross or touch themselves or each other, and where."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from ..arrays import Array
from ..curves.curve import points_along, turn
from ..errors import Problem
from .loop import Loop

_COARSE, _FINE = 1e-5, 1e-8  # chords' distance from their curves, relative to the section's size
_DOUBT = 4.0  # chords' distances by which loops may be nearer than their chords are, with room
_LOOK = 16  # chords by whose sagitta the number of chords is chosen
_MOST = 32_768  # chords a curve


def crossing_problems(loops: Sequence[Loop]) -> list[Problem]:
    """What keeps the loops, the outer one first, from bounding one region; empty if nothing does.

    Found on chords (straight sides are their own), coarse ones first: what seems to cross is looked at again
    with chords a thousand times closer to the curves.
    """
    fractions = np.linspace(0.0, 1.0, _LOOK + 1)
    looks = [_all_round(loop, points_along(loop.curves, fractions).reshape(-1, 2)) for loop in loops]
    size = float(np.ptp(np.concatenate(looks), axis=0).max())
    coarse = _problem([_chords(loop, _COARSE) for loop in loops], _DOUBT * _COARSE * size)
    fine = _problem([_chords(loop, _FINE) for loop in loops], _DOUBT * _FINE * size) if coarse else None
    return [fine] if fine else []


def _problem(rings: Sequence[Array], near: float) -> Problem | None:
    import shapely

    reason = shapely.is_valid_reason(shapely.Polygon(rings[0], rings[1:]))
    if reason == "Valid Geometry":
        return _touching(rings, near)
    kind, x, y = _kind_and_place(str(reason))
    loops = " and ".join(str(i + 1) for i in _at(rings, np.array([x, y])))
    messages = {
        "Self-intersection": "the outline crosses itself or a hole there",
        "Ring Self-intersection": "the outline touches itself there",
        "Hole lies outside shell": "this hole lies outside the outer loop",
        "Holes are nested": "this hole lies inside another hole",
        "Interior is disconnected": "holes touch there and cut the section in two",
    }
    return Problem(
        f"loop {loops or '1'} at ({x:.6g}, {y:.6g})",
        f"{messages.get(kind, kind)}; a section is one region, its loops clear of themselves and of each other",
    )


def _touching(rings: Sequence[Array], near: float) -> Problem | None:
    """Where two loops come as near to each other as the chords leave in doubt."""
    import shapely

    lines = np.array([shapely.LinearRing(ring) for ring in rings])
    first, second = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=near)
    pairs = np.stack([first, second], axis=1)[first < second]
    if not len(pairs):
        return None
    i, j = (int(k) for k in pairs[0])
    x, y = shapely.get_coordinates(shapely.shortest_line(lines[i], lines[j]))[0]
    return Problem(
        f"loops {i + 1} and {j + 1} at ({x:.6g}, {y:.6g})",
        "they touch there, or are too close to tell; holes keep clear of the outline and of each other",
    )


def _kind_and_place(reason: str) -> tuple[str, float, float]:
    """Of a reason such as "Self-intersection[1.5 2]"."""
    found = re.fullmatch(r"(.*?)\[(\S+) (\S+)\]", reason)
    return (found[1], float(found[2]), float(found[3])) if found else (reason, np.nan, np.nan)


def _at(rings: Sequence[Array], place: Array) -> list[int]:
    """Numbers of the rings that pass through a place, about."""
    import shapely

    distances = [shapely.Point(place).distance(shapely.LinearRing(ring)) for ring in rings]
    near = min(distances) + 1e-9 * float(np.ptp(rings[0], axis=0).max())
    return [i for i, distance in enumerate(distances) if distance <= near]


def _all_round(loop: Loop, points: Array) -> Array:
    """Points (n, 2) of one period of a loop, and after them those of its other periods in turn."""
    step = loop.sense * 2.0 * np.pi / loop.copies
    return np.concatenate([points, *(points @ turn(k * step, 2).T for k in range(1, loop.copies))])


def _chords(loop: Loop, tolerance: float) -> Array:
    """Points (n, 2) all round a loop, with chords within the tolerance × size of its curves."""
    curves = loop.curves
    looks = points_along(curves, np.linspace(0.0, 1.0, _LOOK + 1))
    size = float(np.ptp(_all_round(loop, looks.reshape(-1, 2)), axis=0).max())
    sagitta = np.linalg.norm(looks[:, 2:] - 2.0 * looks[:, 1:-1] + looks[:, :-2], axis=-1).max(axis=1) / 8.0
    wanted = _LOOK * np.sqrt(sagitta / (tolerance * size))
    counts = np.where(sagitta <= 1e-15 * size, 1.0, np.clip(2.0 ** np.ceil(np.log2(np.maximum(wanted, 1.0))), 2, _MOST))
    pieces: list[Array] = [np.empty((0, 2))] * len(curves)
    for count in np.unique(counts):
        chosen = np.flatnonzero(counts == count)
        points = points_along([curves[int(i)] for i in chosen], np.arange(count) / count)
        for i, piece in zip(chosen, points, strict=True):
            pieces[i] = piece
    return _all_round(loop, np.concatenate(pieces))

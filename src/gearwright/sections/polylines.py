"""Loops as closed polygons, within a chord tolerance."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..arrays import Array
from ..curves.curve import Curve, turn
from .loop import Loop

_LOOKED_AT = 4  # points of a chord at which it is seen how far the curve is
_MOST = 4096  # chords of a curve

Map = Callable[[Array], Array]


def closed_polyline(loop: Loop, tolerance: float) -> Array:
    """Corners (n, 2) of a plane loop, the first one again at the end; chords are within a tolerance (length)."""
    period = chords(loop.curves, tolerance)[:-1]
    turns = [turn(k * loop.sense * 2.0 * np.pi / loop.copies, 2) for k in range(loop.copies)]
    corners = np.concatenate([period @ matrix.T for matrix in turns])
    return np.concatenate([corners, corners[:1]])


def chords(curves: Sequence[Curve], tolerance: float, onto: Map | None = None) -> Array:
    """Points (n, 2) along a chain of curves, its last one included, whose chords are within a tolerance (length).

    onto   takes points (m, d) of the curves to the plane, if they are not in it
    """
    pieces = [_chords(curve, tolerance, onto) for curve in curves]
    return np.concatenate([*(piece[:-1] for piece in pieces), pieces[-1][-1:]])


def _chords(curve: Curve, tolerance: float, onto: Map | None) -> Array:
    count = 1
    while True:
        fractions = np.linspace(0.0, 1.0, _LOOKED_AT * count + 1)
        points = curve.point(curve.parameter(fractions))
        points = points if onto is None else onto(points)
        if count >= _MOST or _deviation(points) <= tolerance:
            return points[::_LOOKED_AT]
        count *= 2


def _deviation(points: Array) -> float:
    """Greatest distance of the points between every so many-th from the chord of these."""
    corners = points[::_LOOKED_AT]
    inner = np.stack([points[k:-1:_LOOKED_AT] for k in range(1, _LOOKED_AT)]) - corners[:-1]
    way = np.diff(corners, axis=0)
    along = np.clip(np.sum(inner * way, axis=-1) / np.maximum(np.sum(way**2, axis=-1), 1e-300), 0.0, 1.0)
    return float(np.max(np.linalg.norm(inner - along[..., None] * way, axis=-1)))

"""Where the borders of two bodies run along each other, but are cut into edges at other places."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Array
from .edge import Edge
from .faces import CapLoop

_SAMPLES = 33  # a curve, from which the foot of a point is searched
_STEPS = 20  # of Newton's method


def cuts_at_corners(loops: Sequence[CapLoop], others: Sequence[CapLoop], near: float) -> dict[Edge, list[float]]:
    """Fractions at which edges of loops pass through corners of other loops without a corner of their own.

    All images count; where an edge has several, its fractions are those of all of them together.
    """
    corners = [
        use.edge.pattern.images(use.edge.curve.point(use.edge.curve.parameter([0.0, 1.0])))
        for loop in others
        for use in loop.uses
    ]
    if not corners:
        return {}
    points = np.concatenate([images.reshape(-1, 3) for images in corners])
    found: dict[Edge, list[float]] = {}
    for edge in dict.fromkeys(use.edge for loop in loops for use in loop.uses):
        fractions = [f for k in range(edge.pattern.order) for f in _passing(edge, k, points, near)]
        if fractions:
            found[edge] = fractions
    return found


def _passing(edge: Edge, k: int, points: Array, near: float) -> list[float]:
    """Fractions at which image k of an edge passes within a distance of points (n, 3), but not at its ends."""
    points = edge.pattern.image(k).points_back(points) if k else points
    along = np.linspace(0.0, 1.0, _SAMPLES)
    samples = edge.curve.point(edge.curve.parameter(along))
    gap = float(np.max(np.linalg.norm(np.diff(samples, axis=0), axis=1))) + near
    close = np.all((points >= samples.min(axis=0) - gap) & (points <= samples.max(axis=0) + gap), axis=1)
    points = points[close]
    if not len(points):
        return []
    start, end = edge.curve.interval
    f = along[np.argmin(np.linalg.norm(points[:, None] - samples, axis=2), axis=1)]
    for _ in range(_STEPS):
        u = edge.curve.parameter(f)
        tangent = edge.curve.derivative(u) * (end - start)
        square = np.sum(tangent**2, axis=1)
        square = np.where(square > 0.0, square, np.inf)  # at a cusp there is no way on
        f = np.clip(f + np.sum((points - edge.curve.point(u)) * tangent, axis=1) / square, 0.0, 1.0)
    feet = edge.curve.point(edge.curve.parameter(f))
    on = np.linalg.norm(points - feet, axis=1) <= near
    for tip in samples[[0, -1]]:
        on &= np.linalg.norm(points - tip, axis=1) > near
    return sorted(f[on].tolist())

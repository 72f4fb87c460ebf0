"""Edges of two bodies that are the same curve in the same place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from .edge import Edge
from .faces import CapLoop

_FRACTIONS = np.array([0.0, 0.15, 0.3, 0.5, 0.7, 0.85, 1.0])
"""Where curves are compared: the same both ways, and equal only where they also run equally fast."""


@dataclass(frozen=True, kw_only=True, eq=False)
class EdgeMatch:
    """An edge of the second body that is one of the first, run against it or not.

    plain   whether they also agree image by image: the same pattern, the same sector, the same sense
    """

    first: Edge
    second: Edge
    reverse: bool
    plain: bool


def matches(first: Sequence[CapLoop], second: Sequence[CapLoop], near: float) -> list[EdgeMatch]:
    """The edges of loops of two bodies that coincide within a distance, image by image."""
    from scipy.spatial import cKDTree

    ours, theirs = _edges(first), _edges(second)
    images = [(edge, k, image) for edge in ours for k, image in enumerate(_images(edge))]
    if not images or not theirs:
        return []
    tree = cKDTree([image[3] for _, _, image in images])
    found = []
    for edge in theirs:
        own = _images(edge)[0]
        for i in tree.query_ball_point(own[3], near):
            mate, k, image = images[i]
            ways = [reverse for reverse in (False, True) if _apart(image[::-1] if reverse else image, own) <= near]
            if ways:
                plain = k == 0 and not ways[0] and mate.pattern == edge.pattern and mate.end_turn == edge.end_turn
                found.append(EdgeMatch(first=mate, second=edge, reverse=ways[0], plain=plain))
                break
    return found


def _edges(loops: Sequence[CapLoop]) -> list[Edge]:
    return list(dict.fromkeys(use.edge for loop in loops for use in loop.uses))


def _images(edge: Edge) -> Array:
    """Points (order, 7, 3) along all images of an edge."""
    return edge.pattern.images(edge.curve.point(edge.curve.parameter(_FRACTIONS)))


def _apart(one: Array, other: Array) -> float:
    return float(np.max(np.linalg.norm(one - other, axis=1)))

"""Which closed shells lie inside which, and whether each turns the way its depth asks for.

A shell that lies in an even number of others bounds material from outside, and must turn outward; one in an odd number
bounds a void, and must turn inward.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array, Indices
from ...moments.components import component_boxes, component_volumes, windings
from .shells import Shells

_WITNESSES = 12
"""Points of a shell that are tried, one after another, where one lies on the other shell's surface."""


class Nesting(NamedTuple):
    """Shells, how large they are and what they lie in.

    volumes   (s,) signed volumes, to plain precision; 0 of shells that are not closed
    depths    (s,) in how many others a shell lies
    parents   (s,) the innermost of those, −1 where there is none
    boxes     (s, 2, 3)
    """

    volumes: Array
    depths: Indices
    parents: Indices
    boxes: Array

    @property
    def inward(self) -> Indices:
        """Shells (k,) that turn inward and should not."""
        return np.flatnonzero((self.volumes < 0.0) & (self.depths % 2 == 0))

    @property
    def buried(self) -> Indices:
        """Shells (k,) that turn outward inside others and should not."""
        return np.flatnonzero((self.volumes > 0.0) & (self.depths % 2 == 1))

    def bodies(self) -> Indices:
        """Number of every shell's body (s,), from 0 in the order of first shells: voids belong to what they are in."""
        void = (self.volumes < 0.0) & (self.depths % 2 == 1)
        owner = np.where(void, self.parents, np.arange(len(void)))
        # a void without a body of the right sense around it stays a body of its own; chains have at most one step
        firsts = np.full(len(void), len(void))
        np.minimum.at(firsts, owner, np.arange(len(void)))
        return np.asarray(np.unique(firsts[owner], return_inverse=True)[1]).reshape(-1)


def nesting(vertices: Array, indices: Indices, offsets: Indices, shells: Shells) -> Nesting:
    """Where the shells of these faces lie."""
    labels, closed = shells
    boxes = component_boxes(vertices, indices, offsets, labels, len(closed))
    origins = boxes[:, 0] + (boxes[:, 1] - boxes[:, 0]) / 2.0
    volumes = component_volumes(vertices, indices, offsets, labels, origins)
    pairs = _boxes_in_boxes(boxes, np.flatnonzero(closed))
    pairs = pairs[_inside(vertices, indices, offsets, labels, pairs, boxes)]
    depths = np.bincount(pairs[:, 0], minlength=len(closed))
    parents = np.full(len(closed), -1)
    by_depth = pairs[np.argsort(depths[pairs[:, 1]], kind="stable")]
    parents[by_depth[:, 0]] = by_depth[:, 1]
    return Nesting(np.where(closed, volumes, 0.0), depths, parents, boxes)


def _boxes_in_boxes(boxes: Array, chosen: Indices) -> Indices:
    """Pairs (k, 2) of those chosen of boxes (n, 2, 3), the first within the second; equal ones both ways."""
    from ..box_tree import overlapping_pairs

    found = [np.empty((0, 2), np.int64)]
    if len(chosen) > 1:
        for near in overlapping_pairs(boxes[chosen]):
            for one, other in (chosen[near].T, chosen[near].T[::-1]):
                within = np.all((boxes[one, 0] >= boxes[other, 0]) & (boxes[one, 1] <= boxes[other, 1]), axis=1)
                found.append(np.stack([one, other], axis=1)[within])
    return np.concatenate(found)


def _inside(
    vertices: Array, indices: Indices, offsets: Indices, labels: Indices, pairs: Indices, boxes: Array
) -> Indices:
    """Numbers (k,) of the pairs whose first shell lies in the second.

    The winding number around one of its points decides, or around the next where that is on the surface. Where all
    are, shells of one box are the same one twice: the later counts as inside the earlier.
    """
    first_faces = np.argsort(labels, kind="stable")
    starts = np.searchsorted(labels[first_faces], np.arange(len(boxes) + 1))
    found, open_ = [np.empty(0, np.int64)], np.arange(len(pairs))
    for turn in range(_WITNESSES):
        if not len(open_):
            break
        inner, outer = pairs[open_].T
        chosen = starts[inner] + (turn * (starts[inner + 1] - starts[inner])) // _WITNESSES
        points = _witnesses(vertices, indices, offsets, first_faces[chosen], turn)
        winding, on = windings(points, outer, vertices, indices, offsets, labels)
        found.append(open_[~on & (winding % 2 == 1)])
        open_ = open_[on]
    same = np.all(boxes[pairs[open_, 0]] == boxes[pairs[open_, 1]], axis=(1, 2))
    found.append(open_[same & (pairs[open_, 0] > pairs[open_, 1])])
    return np.concatenate(found)


def _witnesses(vertices: Array, indices: Indices, offsets: Indices, faces: Indices, turn: int) -> Array:
    """A point (k, 3) of each face: a corner, or next time the middle of a triangle or of another face's first side."""
    first = vertices[indices[offsets[faces]]]
    if turn % 2 == 0:
        return first
    second, third = vertices[indices[offsets[faces] + 1]], vertices[indices[offsets[faces] + 2]]
    triangle = (np.diff(offsets)[faces] == 3)[:, None]
    return np.where(triangle, first + ((second - first) + (third - first)) / 3.0, first + (second - first) / 2.0)

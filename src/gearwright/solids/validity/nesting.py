"""Which closed shells lie inside which, and whether each turns the way its depth asks for.

A shell that lies in an even number of others bounds material from outside, and must turn outward; one in an odd number
bounds a void, and must turn inward.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array, Indices
from ...moments.components import component_boxes, component_volumes, windings
from .edges import Flags
from .shells import Shells

_WITNESSES = 12
"""Points of a shell that are tried, one after another, where one lies on the other shell's surface."""

_NO_VOLUME = 1e-14
"""A volume counts as 0 where it is less than this × the area × the diagonal: rounding error."""


class Nesting(NamedTuple):
    """Shells, how large they are and what they lie in.

    volumes   (s,) signed volumes, to plain precision; 0 of shells that are flat or not closed
    depths    (s,) in how many others a shell lies
    parents   (s,) the innermost of those, −1 where there is none
    settled   (s,) whether that is all: no shell with a hole may be around it
    boxes     (s, 2, 3)
    """

    volumes: Array
    depths: Indices
    parents: Indices
    settled: Flags
    boxes: Array

    @property
    def inward(self) -> Indices:
        """Shells (k,) that turn inward and should not."""
        return np.flatnonzero(self.settled & (self.volumes < 0.0) & (self.depths % 2 == 0))

    @property
    def buried(self) -> Indices:
        """Shells (k,) that turn outward inside others and should not."""
        return np.flatnonzero(self.settled & (self.volumes > 0.0) & (self.depths % 2 == 1))

    def bodies(self) -> Indices:
        """Number of every shell's body (s,), from 0 in the order of first shells: voids belong to what they are in."""
        # what surrounds a void is at an even depth, so it is none itself
        void = (self.volumes < 0.0) & self.settled & (self.depths % 2 == 1)
        void |= (self.volumes < 0.0) & ~self.settled & (self.volumes[self.parents] == 0.0)
        owner = np.where(void, self.parents, np.arange(len(void)))
        firsts = np.full(len(void), len(void))
        np.minimum.at(firsts, owner, np.arange(len(void)))
        return np.asarray(np.unique(firsts[owner], return_inverse=True)[1]).reshape(-1)


def nesting(vertices: Array, indices: Indices, offsets: Indices, shells: Shells, areas: Array) -> Nesting:
    """Where the shells of these faces lie, whose areas (f,) are given."""
    labels, closed, tight = shells
    boxes = component_boxes(vertices, indices, offsets, labels, len(closed))
    origins = boxes[:, 0] + (boxes[:, 1] - boxes[:, 0]) / 2.0
    volumes = component_volumes(vertices, indices, offsets, labels, origins)
    least = _NO_VOLUME * np.bincount(labels, areas) * np.linalg.norm(boxes[:, 1] - boxes[:, 0], axis=1)
    volumes[~closed | (np.abs(volumes) <= least)] = 0.0
    near = _boxes_in_boxes(boxes, tight)
    holed = near[~tight[near[:, 1]]]
    pairs = near[tight[near[:, 1]]]
    pairs = pairs[_inside(vertices, indices, offsets, labels, pairs, boxes)]
    depths = np.bincount(pairs[:, 0], minlength=len(closed))
    parents = np.full(len(closed), -1)
    parents[holed[:, 0]] = holed[:, 1]
    by_depth = pairs[np.argsort(depths[pairs[:, 1]], kind="stable")]
    parents[by_depth[:, 0]] = by_depth[:, 1]
    settled = np.ones(len(closed), bool)
    settled[holed[:, 0]] = False
    return Nesting(volumes, depths, parents, settled, boxes)


def _boxes_in_boxes(boxes: Array, tight: Flags) -> Indices:
    """Pairs (k, 2) of boxes (s, 2, 3), the first of a tight shell and within the second; equal ones both ways."""
    from ..box_tree import overlapping_pairs

    found = [np.empty((0, 2), np.int64)]
    if len(boxes) > 1 and tight.any():
        for near in overlapping_pairs(boxes):
            for pairs in (near, near[:, ::-1]):
                one, other = boxes[pairs[:, 0]], boxes[pairs[:, 1]]
                within = np.all((one[:, 0] >= other[:, 0]) & (one[:, 1] <= other[:, 1]), axis=1)
                found.append(pairs[within & tight[pairs[:, 0]]])
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

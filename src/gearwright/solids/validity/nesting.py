"""Which closed shells lie inside which, and whether each turns the way its depth asks for.

A shell that lies in an even number of others bounds material from outside, and must turn outward; one in an odd number
bounds a void, and must turn inward.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array, Indices
from ...moments.component_volumes import component_volumes
from ...moments.components import component_boxes
from ...moments.windings import SPACING
from .edges import Flags
from .insides import insides, shell_faces
from .shells import Shells

_NO_VOLUME = 2.0**-54
"""A volume counts as 0 where it is less than this × the area × the largest coordinate: thinner than the spacing of
float64 there, so that the corners' own roundings may have made it."""


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
    total = np.bincount(labels, areas, minlength=len(closed)).astype(float)
    least = _NO_VOLUME * total * np.abs(boxes).max(axis=(1, 2), initial=0.0)
    volumes[~closed | (np.abs(volumes) <= least)] = 0.0
    near = _boxes_in_boxes(boxes, tight)
    holed = near[~tight[near[:, 1]]]
    pairs = near[tight[near[:, 1]]]
    if len(pairs):
        faces = shell_faces(vertices, indices, offsets, labels, len(closed))
        inside, same = insides(faces, pairs, boxes, volumes, total)
        pairs = np.concatenate([pairs[inside], _in_turn(pairs[same], pairs[inside], volumes)])
    depths = np.bincount(pairs[:, 0], minlength=len(closed))
    parents = np.full(len(closed), -1)
    parents[holed[:, 0]] = holed[:, 1]
    by_depth = pairs[np.argsort(depths[pairs[:, 1]], kind="stable")]
    parents[by_depth[:, 0]] = by_depth[:, 1]
    settled = np.ones(len(closed), bool)
    settled[holed[:, 0]] = False
    return Nesting(volumes, depths, parents, settled, boxes)


def _boxes_in_boxes(boxes: Array, tight: Flags) -> Indices:
    """Pairs (k, 2) of shells, the first tight, its box (s, 2, 3) about within the other's; equal ones twice."""
    from ..box_tree import overlapping_pairs

    found = [np.empty((0, 2), np.int64)]
    if len(boxes) > 1 and tight.any():
        for near in overlapping_pairs(boxes):
            for pairs in (near, near[:, ::-1]):
                one, other = boxes[pairs[:, 0]], boxes[pairs[:, 1]]
                slack = SPACING * np.abs(other).max(axis=1)  # of turned bodies that are flush, each is rounded apart
                within = np.all((one[:, 0] >= other[:, 0] - slack) & (one[:, 1] <= other[:, 1] + slack), axis=1)
                found.append(pairs[within & tight[pairs[:, 0]]])
    return np.concatenate(found)


def _in_turn(same: Indices, inside: Indices, volumes: Array) -> Indices:
    """Of shells of one surface, as pairs (k, 2) both ways, those (m, 2) whose first counts as inside the second.

    inside   (j, 2) the pairs whose first lies in the second in earnest: they tell which sense must come first

    Outward and inward ones take turns, so that a body may fill a void exactly, in whatever order they are written;
    those of one sense come in the order of their numbers, those without volume last.
    """
    shells = np.unique(same)
    if not len(shells):
        return same
    depths = np.bincount(inside[:, 0], minlength=len(volumes))
    wanted = np.where(depths % 2 == 0, 1.0, -1.0)
    late = (np.sign(volumes) != wanted) + 2 * (volumes == 0.0)
    # how many of the same sense come before
    alike = same[(late[same[:, 0]] == late[same[:, 1]]) & (same[:, 1] < same[:, 0])]
    before = np.bincount(alike[:, 0], minlength=len(volumes))
    rank = np.where(volumes == 0.0, 4 * len(volumes), 2 * before + late) * len(volumes) + np.arange(len(volumes))
    return np.asarray(same[rank[same[:, 0]] > rank[same[:, 1]]])

"""Which of two shells lies in the other, whose surfaces may touch or lie flush.

Shells that do not pass through each other are one in the other, apart, or of one surface. A single point of the first
tells which, unless it is on the second's surface; then further points do, each inside another face. Where all of them
are, as of a plug in a pocket that it fills, the sides decide: points a little way inside the first shell.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array, Indices
from ...moments.windings import windings
from .edges import Flags
from .witnesses import face_points

_GROWTH = 4
"""How many times as many faces are tried each time as the time before."""

_ENOUGH = 64
"""After so many faces that lie flush, shells of one box and one volume count as one surface."""

_ALIKE = 1e-9
"""Volumes and boxes that differ by less than this × their size count as the same."""

_DEPTH = 1e-3
"""How far inside a shell the points that tell sides are, over its volume per area."""

_GOLDEN = 0.6180339887498949
"""Steps of this share of a shell's faces come everywhere soon."""


class ShellFaces(NamedTuple):
    """Faces of a polyhedron, and those of its shells one after another.

    vertices, indices, offsets, labels   the faces, and numbers of their shells
    order   (f,) faces by shells
    starts  (s + 1,) where those of each shell begin
    steps   (s,) from face to face of a shell, so that all are met once
    """

    vertices: Array
    indices: Indices
    offsets: Indices
    labels: Indices
    order: Indices
    starts: Indices
    steps: Indices


def shell_faces(vertices: Array, indices: Indices, offsets: Indices, labels: Indices, count: int) -> ShellFaces:
    """The faces of so many shells."""
    order = np.argsort(labels, kind="stable")
    starts = np.searchsorted(labels[order], np.arange(count + 1))
    return ShellFaces(vertices, indices, offsets, labels, order, starts, _steps(np.diff(starts)))


def insides(faces: ShellFaces, pairs: Indices, boxes: Array, volumes: Array, areas: Array) -> tuple[Indices, Indices]:
    """Numbers (k,) of the pairs whose first shell lies in the second, and (m,) of those of one surface.

    pairs            (p, 2) numbers of shells, the box of the first in that of the second
    boxes            (s, 2, 3) of the shells
    volumes, areas   (s,) of the shells; the volume is signed, and 0 where there is none
    """
    inner, outer = pairs.T
    alike = _alike(boxes[pairs], np.abs(volumes[pairs]))
    counts = np.diff(faces.starts)[inner]
    inside, flush = _by_points(
        faces, pairs, np.arange(len(pairs)), np.where(alike, np.minimum(counts, _ENOUGH), counts), np.zeros(len(boxes))
    )
    same, beside = flush[alike[flush]], flush[~alike[flush]]
    smaller = np.abs(volumes[inner[beside]]) < np.abs(volumes[outer[beside]])
    beside = beside[smaller & (volumes[inner[beside]] != 0.0)]
    depths = _DEPTH * volumes / np.where(areas > 0.0, areas, 1.0)
    filling, _ = _by_points(faces, pairs, beside, counts, depths)
    return np.concatenate([inside, filling]), same


def _alike(boxes: Array, volumes: Array) -> Flags:
    """Whether both of pairs have one box and one volume, given boxes (p, 2, 2, 3) and magnitudes (p, 2)."""
    size = np.abs(boxes).max(axis=(1, 2, 3), initial=0.0)
    near = np.abs(boxes[:, 0] - boxes[:, 1]).max(axis=(1, 2), initial=0.0) <= _ALIKE * size
    return np.asarray(near & (np.abs(volumes[:, 0] - volumes[:, 1]) <= _ALIKE * volumes.max(axis=1, initial=0.0)))


def _steps(counts: Indices) -> Indices:
    steps = np.maximum(1, np.round(_GOLDEN * counts).astype(np.int64))
    while len(common := np.flatnonzero(np.gcd(steps, counts) > 1)):
        steps[common] += 1
    return steps


def _by_points(
    faces: ShellFaces, pairs: Indices, open_: Indices, tries: Indices, depths: Array
) -> tuple[Indices, Indices]:
    """Of pairs, by their numbers (k,), those whose first shell lies in the second, and those left undecided.

    tries   (p,) how many faces of the first shell are tried at most
    depths  (s,) how far behind the faces of a shell its points are
    """
    inside, undecided, tried, batch = [np.empty(0, np.int64)], [np.empty(0, np.int64)], 0, 1
    while len(open_):
        more = np.minimum(tries[open_] - tried, batch)
        rows = np.repeat(np.arange(len(open_)), more)
        turn = tried + np.arange(len(rows)) - np.repeat(np.cumsum(more) - more, more)
        inner, outer = pairs[open_[rows]].T
        points = _points(faces, inner, turn, depths)
        winding, unsure = windings(points, outer, faces.vertices, faces.indices, faces.offsets, faces.labels)
        sure = np.flatnonzero(~unsure)
        decided, first = np.unique(rows[sure], return_index=True)
        inside.append(open_[decided[winding[sure[first]] % 2 == 1]])
        tried, batch, open_ = tried + batch, batch * _GROWTH, np.delete(open_, decided)
        undecided.append(open_[tries[open_] <= tried])
        open_ = open_[tries[open_] > tried]
    return np.concatenate(inside), np.concatenate(undecided)


def _points(faces: ShellFaces, shells: Indices, turn: Indices, depths: Array) -> Array:
    """Points (k, 3) of the faces that come at these turns (k,) in their shells, or behind them."""
    counts = np.diff(faces.starts)[shells]
    chosen = faces.order[faces.starts[shells] + turn * faces.steps[shells] % counts]
    points, areas = face_points(faces.vertices, faces.indices, faces.offsets, chosen)
    size = np.linalg.norm(areas, axis=1, keepdims=True)
    return np.asarray(points - depths[shells, None] * areas / np.where(size > 0.0, size, 1.0))

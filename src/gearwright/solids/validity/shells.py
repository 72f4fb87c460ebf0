"""Faces joined over edges: which belong together, which turn the other way, how many fans meet at a vertex.

A patch is what is connected over edges of exactly two faces: on it, one face's sense settles every other one's. A shell
is a patch, or patches that only close together: at an edge of more faces, patches that balance there by themselves, as
bodies that touch along it do, stay apart; the others, as cells with a wall between them, are one shell.

Source: Galler & Fisher, Comm. ACM 7 (1964) (union and find); Tarjan & van Leeuwen, J. ACM 31 (1984) (path halving).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Indices
from ...compiled import compiled
from .edges import EdgeUses, Flags


class Patches(NamedTuple):
    """Faces connected over edges of exactly two faces.

    first      (f,) first face of every face's patch
    turned     (f,) whether it turns the other way than that one
    one_sided  (f,) whether its patch cannot be turned one way throughout
    """

    first: Indices
    turned: Flags
    one_sided: Flags

    def minority(self) -> Flags:
        """Which faces (f,) turn another way than most of their patch; of halves, than its first face."""
        whole = np.bincount(self.first, minlength=len(self.first))
        turned = np.bincount(self.first, self.turned, minlength=len(self.first))
        mostly = (2 * turned > whole)[self.first]
        return np.asarray((self.turned != mostly) & ~self.one_sided)


class Shells(NamedTuple):
    """Faces that bound something together.

    labels  (f,) number of every face's shell, from 0 in the order of first faces
    closed  (s,) whether the edges of a shell are walked as often one way as the other
    tight   (s,) whether even numbers of faces meet at them, however these are turned: inside and outside are apart
    """

    labels: Indices
    closed: Flags
    tight: Flags


def patches(bounding: EdgeUses, faces: int) -> Patches:
    """Patches of so many faces."""
    return Patches(*_patches(bounding.forward, bounding.faces, bounding.starts, faces))


def shells(bounding: EdgeUses, first: Indices) -> Shells:
    """Shells of the patches whose first faces (f,) are given."""
    return Shells(*_shells(bounding.forward, bounding.faces, bounding.starts, first))


def pinched_vertices(uses: EdgeUses, count: int, indices: Indices, offsets: Indices) -> Indices:
    """Vertices (k,), of so many, round which the faces form more than one fan; `uses` of all edges."""
    return np.flatnonzero(_fans(uses.corners, uses.forward, uses.faces, uses.starts, count, indices, offsets) > 1)


@compiled
def _root(parent: Indices, item: int) -> int:
    while parent[item] != item:
        parent[item] = parent[parent[item]]
        item = parent[item]
    return item


@compiled
def _join(parent: Indices, one: int, other: int) -> None:
    """The lesser of two roots becomes the root of both."""
    one, other = _root(parent, one), _root(parent, other)
    parent[max(one, other)] = min(one, other)


@compiled
def _oriented_root(parent: Indices, turned: Flags, face: int) -> tuple[int, bool]:
    """First face of a patch so far, and whether a face turns the other way than it."""
    odd = False
    while parent[face] != face:
        above = parent[face]
        turned[face] ^= turned[above]
        parent[face] = parent[above]
        odd ^= turned[face]
        face = parent[face]
    return face, odd


@compiled
def _patches(forward: Flags, faces: Indices, starts: Indices, count: int) -> tuple[Indices, Flags, Flags]:
    parent, turned, conflict = np.arange(count), np.zeros(count, np.bool_), np.zeros(count, np.bool_)
    for edge in range(len(starts) - 1):
        use = starts[edge]
        if starts[edge + 1] - use != 2:
            continue
        one, one_turned = _oriented_root(parent, turned, faces[use])
        other, other_turned = _oriented_root(parent, turned, faces[use + 1])
        odd = one_turned ^ other_turned ^ (forward[use] == forward[use + 1])
        if one == other:
            conflict[one] |= odd
        else:
            parent[max(one, other)] = min(one, other)
            turned[max(one, other)] = odd
    for face in range(count):  # roots come before their faces
        above = parent[face]
        if above != face:
            turned[face] ^= turned[above]
            parent[face] = parent[above]
            conflict[parent[face]] |= conflict[face]
    for face in range(count):
        conflict[face] = conflict[parent[face]]
    return parent, turned, conflict


@compiled
def _shells(forward: Flags, faces: Indices, starts: Indices, first: Indices) -> tuple[Indices, Flags, Flags]:
    parent, uneven, odd = first.copy(), np.zeros(len(first), np.bool_), np.zeros(len(first), np.bool_)
    balance = np.zeros(len(first), np.int64)
    for edge in range(len(starts) - 1):
        start, stop = starts[edge], starts[edge + 1]
        if stop - start == 2:
            uneven[faces[start]] |= forward[start] == forward[start + 1]
        else:
            _join_unbalanced(parent, uneven, first[faces[start:stop]], forward[start:stop], balance)
            odd[faces[start]] |= (stop - start) % 2 == 1
    labels, shells = np.empty(len(first), np.int64), 0
    for face in range(len(first)):
        above = _root(parent, face)
        if above == face:
            labels[face] = shells
            shells += 1
        else:
            labels[face] = labels[above]
    closed, tight = np.ones(shells, np.bool_), np.ones(shells, np.bool_)
    for face in range(len(first)):
        closed[labels[face]] &= not uneven[face]
        tight[labels[face]] &= not odd[face]
    return labels, closed, tight


@compiled
def _join_unbalanced(parent: Indices, uneven: Flags, patches: Indices, forward: Flags, balance: Indices) -> None:
    """Joins the patches of an edge's uses that do not balance there; marks one where all together do not either.

    balance   (f,) zeros, and zeros again afterwards
    """
    for use in range(len(patches)):
        balance[patches[use]] += 1 if forward[use] else -1
    total, joined = 0, -1
    for use in range(len(patches)):
        patch = patches[use]
        if balance[patch]:
            total += balance[patch]
            balance[patch] = 0
            if joined >= 0:
                _join(parent, joined, patch)
            joined = patch
    if total:
        uneven[joined] = True


@compiled
def _fans(
    corners: Indices, forward: Flags, faces: Indices, starts: Indices, count: int, indices: Indices, offsets: Indices
) -> Indices:
    """How many fans the faces round each vertex form: corners there, joined over the edges there."""
    parent, used = np.arange(len(indices)), np.zeros(len(indices), np.bool_)
    for f in range(len(offsets) - 1):
        for c in range(offsets[f], offsets[f + 1]):
            after = c + 1 if c + 1 < offsets[f + 1] else offsets[f]
            if indices[c] == indices[after]:
                _join(parent, c, after)
    for edge in range(len(starts) - 1):
        low = high = -1
        for use in range(starts[edge], starts[edge + 1]):
            c = corners[use]
            after = c + 1 if c + 1 < offsets[faces[use] + 1] else offsets[faces[use]]
            used[c] = used[after] = True
            begin, end = (c, after) if forward[use] else (after, c)
            if low >= 0:
                _join(parent, low, begin)
                _join(parent, high, end)
            low, high = begin, end
    fans, seen = np.zeros(count, np.int64), np.zeros(len(indices), np.bool_)
    for c in range(len(indices)):
        if used[c] and not seen[_root(parent, c)]:
            seen[_root(parent, c)] = True
            fans[indices[c]] += 1
    return fans

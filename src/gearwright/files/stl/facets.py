"""The facets of a text STL file, read in a compiled loop over its bytes."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...compiled import compiled
from ..text.decimals import FINE, NO_NUMBER, Characters, copied, is_blank, take, word_end

FACET = ("facet", "normal", *"###", "outer", "loop", *3 * ("vertex", *"000"), "endloop", "endfacet")
"""The words of a facet; 0 stands for a coordinate, # for one of the normal, which nobody reads."""

NO_WORD, UNFINISHED = 3, 4
"""What can be wrong, besides what `decimals` finds."""

_COORDINATE, _PASSED = 0, 1
_CODES = {"0": _COORDINATE, "#": _PASSED}
_PATTERN = np.array([_CODES.get(w, int.from_bytes(w.encode()[-7:], "big") << 8 | len(w)) for w in FACET], np.int64)


@compiled
def read_facets(
    data: Characters, i: int, end: int, late: Indices, seen: Indices
) -> tuple[int, int, int, Array, Indices]:
    """The facets between two places: what is wrong first, where, at which word of FACET; coordinates and `late`."""
    points, count = np.empty(90), 0
    unread = np.empty(1), np.zeros(48, np.int64), np.zeros(3, np.int64)
    while True:
        for k in range(len(_PATTERN)):
            while i < end and (is_blank(data[i]) or data[i] == 10):
                i += 1
            if i >= end:
                return (UNFINISHED if k else FINE), i, k, copied(points, np.empty(count)), late
            wanted = _PATTERN[k]
            if wanted == _COORDINATE:
                if count == len(points):
                    points = copied(points, np.empty(2 * count))
                i, problem, late = take(data, i, points, count, late, seen)
                count += 1
            elif wanted == _PASSED:
                i, problem = _normal(data, i, unread)
            else:
                i, problem = _keyword(data, i, wanted)
            if problem != FINE:
                return problem, i, k, points, late


@compiled
def _keyword(data: Characters, i: int, wanted: int) -> tuple[int, int]:
    """Where a word ends that is the wanted one in small or capital letters."""
    start, key = i, 0
    i = word_end(data, i)
    for k in range(max(start, i - 7), i):
        key = key << 8 | (data[k] | 32)
    return (i, FINE) if key << 8 | min(i - start, 255) == wanted else (start, NO_WORD)


@compiled
def _normal(data: Characters, i: int, unread: tuple[Array, Indices, Indices]) -> tuple[int, int]:
    """Where a number ends, finite or not: facets without area have normals that are not."""
    numbers, late, seen = unread
    late[0] = 0
    problem = take(data, i, numbers, 0, late, seen)[1]
    return (i, NO_NUMBER) if problem == NO_NUMBER else (word_end(data, i), FINE)

"""Vertices and faces that text gives a line each, their parts in a stated order, in a compiled loop."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ...arrays import Array, Indices
from ...compiled import compiled
from .decimals import (
    FINE,
    NO_NUMBER,
    Characters,
    copied,
    ends_line,
    line_end,
    skip_blanks,
    take,
    whole_number,
    word_end,
)

NO_COUNT, NO_VERTEX, FEW_CORNERS, TOO_MUCH = 3, 4, 5, 6
"""What can be wrong, besides what `decimals` finds."""

PASSED, X, PASSED_LIST, CORNERS = 0, 1, 4, 5
"""Parts of a line: a word passed over, coordinates (X, X + 1, X + 2), a list passed over, a list of vertex numbers."""


class Rows(NamedTuple):
    """What lines held, and where and why reading stopped.

    problem, place     what is wrong first and where; FINE and where the lines end
    points             (3 n,) coordinates, those of `late` still to read
    indices, offsets   faces as in `moments.faces`
    """

    problem: int
    place: int
    points: Array
    late: Indices
    indices: Indices
    offsets: Indices


@compiled
def read_rows(
    data: Characters, i: int, rows: int, parts: Indices, total: int, whole_lines: bool, late: Indices, seen: Indices
) -> Rows:
    """So many lines from a place on; empty ones and comments, from # on, do not count.

    parts         what a line consists of
    total         vertices that a face can name
    whole_lines   nothing may follow the parts
    """
    has_points, has_corners = False, False
    for part in parts:
        has_points |= X <= part < X + 3
        has_corners |= part == CORNERS
    points = np.empty(3 * rows if has_points else 0)
    offsets = np.empty(rows + 1 if has_corners else 1, np.int64)
    offsets[0] = 0
    indices = np.empty(4 * rows if has_corners else 0, np.int64)
    count = 0
    for row in range(rows):
        i = _next_line(data, i)
        for part in parts:
            i = skip_blanks(data, i)
            problem, before = FINE, count
            if part == PASSED:
                problem = NO_NUMBER if ends_line(data, i) else FINE
                i = word_end(data, i)
            elif part < PASSED_LIST:
                i, problem, late = take(data, i, points, 3 * row + part - X, late, seen)
            else:
                i, problem, indices, count = _list(data, i, total, part == CORNERS, indices, count)
            if problem == FINE and part == CORNERS:
                offsets[row + 1] = count
                if count - before < 3:
                    problem = FEW_CORNERS
            if problem != FINE:
                return Rows(problem, i, points, late, indices, offsets)
        i = skip_blanks(data, i)
        if whole_lines and not ends_line(data, i):
            return Rows(TOO_MUCH, i, points, late, indices, offsets)
        i = line_end(data, i)
    return Rows(FINE, i, points, late, copied(indices, np.empty(count, np.int64)), offsets)


@compiled
def _next_line(data: Characters, i: int) -> int:
    """The first word of the next line that has any."""
    i = skip_blanks(data, i)
    while i < len(data) and ends_line(data, i):
        i = skip_blanks(data, line_end(data, i) + 1)
    return min(i, len(data))


@compiled
def _list(
    data: Characters, i: int, total: int, kept: bool, indices: Indices, count: int
) -> tuple[int, int, Indices, int]:
    """A count and as many words: vertex numbers where kept."""
    start = i
    i, size = whole_number(data, i)
    if i == start or size < 0 or i != word_end(data, i):
        return start, NO_COUNT, indices, count
    for _ in range(size):
        i = skip_blanks(data, i)
        if ends_line(data, i):
            return i, NO_VERTEX, indices, count
        if not kept:
            i = word_end(data, i)
            continue
        start = i
        i, vertex = whole_number(data, i)
        if i == start or i != word_end(data, i) or not 0 <= vertex < total:
            return start, NO_VERTEX, indices, count
        if count == len(indices):
            indices = copied(indices, np.empty(2 * count + 16, np.int64))
        indices[count] = vertex
        count += 1
    return i, FINE, indices, count


def next_place(text: bytes, place: int) -> int:
    """The first word after a place that stands in no comment, or the end of the text."""
    return int(_next_line(np.frombuffer(text, np.uint8), place))

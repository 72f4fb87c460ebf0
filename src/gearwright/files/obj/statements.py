"""The statements of an OBJ file, read in compiled loops over its bytes."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, Indices
from ...compiled import compiled
from ..text.decimals import FINE, Characters, ends_line, is_blank, line_end, skip_blanks, take, whole_number, word_end

NO_VERTEX, FEW_CORNERS, NO_STATEMENT = 3, 4, 5
"""What can be wrong, besides what `decimals` finds."""

QUIET = (
    "vt", "vn", "vp", "s", "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp",
    "lod", "shadow_obj", "trace_obj", "mg",
)  # fmt: skip
"""Statements of how a body looks."""

LEFT_OUT = (
    "p", "l", "curv", "curv2", "surf", "parm", "trim",
    "hole", "scrv", "sp", "end", "con", "cstype", "deg", "bmat", "step", "ctech",
    "stech", "bsp", "bzp", "cdc", "cdp", "res", "call", "csh",
)  # fmt: skip
"""Statements of points, lines, curves, free-form surfaces and other files."""


def _key(word: str) -> int:
    return int.from_bytes(word.encode()[-7:], "big") << 8 | len(word)


_KEYS = np.array([_key(word) for word in (*LEFT_OUT, *QUIET)], np.int64)
_V, _F, _O, _G, _VN, _VT = (_key(word) for word in ("v", "f", "o", "g", "vn", "vt"))


@compiled
def _statement(data: Characters, i: int) -> tuple[int, int]:
    """Where the word at a place ends, and its key."""
    start, key = i, 0
    end = word_end(data, i)
    for k in range(max(start, end - 7), end):
        key = key << 8 | data[k]
    return end, key << 8 | min(end - start, 255)


@compiled
def count(data: Characters) -> tuple[int, int, int, int]:
    """How many vertices, faces, words in faces, and names of objects and groups there are."""
    vertices, faces, words, names, i = 0, 0, 0, 0, 0
    while i < len(data):
        i = skip_blanks(data, i)
        if not ends_line(data, i):
            i, key = _statement(data, i)
            vertices += key == _V
            names += key in (_O, _G)
            if key == _F:
                faces += 1
                i = skip_blanks(data, i)
                while not ends_line(data, i):
                    words += 1
                    i = skip_blanks(data, word_end(data, i))
        i = line_end(data, i) + 1
    return vertices, faces, words, names


@compiled
def fill(
    data: Characters, points: Array, indices: Indices, offsets: Indices, names: Indices, late: Indices, seen: Indices,
    left_out: Indices,
) -> tuple[int, int, Indices]:  # fmt: skip
    """Reads all statements into arrays of the sizes that `count` gives: what is wrong first and where, and `late`.

    points    (3 n,)
    offsets   (f + 1,)
    names     (k, 4): 1 for objects and 0 for groups, faces before it, start and end of the rest of the line
    left_out  how often every statement of LEFT_OUT occurs
    """
    vertices, faces, corners, name, i = 0, 0, 0, 0, 0
    while i < len(data):
        i = skip_blanks(data, i)
        if ends_line(data, i):
            i = line_end(data, i) + 1
            continue
        start = i
        i, key = _statement(data, i)
        if key == _V:
            i, problem, late = _coordinates(data, i, points, 3 * vertices, late, seen)
            vertices += 1
        elif key == _F:
            i, problem, more = _corners(data, i, len(points) // 3, vertices, indices, corners)
            if problem == FINE and more - corners < 3:
                problem, i = FEW_CORNERS, start
            corners = more
            faces += 1
            offsets[faces] = corners
        elif key in (_O, _G):
            names[name, 0], names[name, 1], names[name, 2] = key == _O, faces, i
            i = line_end(data, i)
            names[name, 3] = i
            name += 1
            problem = FINE
        else:
            problem = FINE if key in (_VN, _VT) or _is_known(key, left_out) else NO_STATEMENT
            i = start if problem else i
        if problem != FINE:
            return problem, i, late
        i = line_end(data, i) + 1
    return FINE, 0, late


@compiled
def _is_known(key: int, left_out: Indices) -> bool:
    for k in range(len(_KEYS)):
        if _KEYS[k] == key:
            if k < len(left_out):
                left_out[k] += 1
            return True
    return False


@compiled
def _coordinates(
    data: Characters, i: int, points: Array, slot: int, late: Indices, seen: Indices
) -> tuple[int, int, Indices]:
    for k in range(3):
        i, problem, late = take(data, skip_blanks(data, i), points, slot + k, late, seen)
        if problem != FINE:
            return i, problem, late
    return i, FINE, late


@compiled
def _corners(data: Characters, i: int, total: int, so_far: int, indices: Indices, corner: int) -> tuple[int, int, int]:
    """The corners of a face, of which only the vertex before the first "/" counts."""
    i = skip_blanks(data, i)
    while not ends_line(data, i):
        start = i
        i, number = whole_number(data, i)
        vertex = number - 1 if number > 0 else so_far + number
        if i == start or number == 0 or not 0 <= vertex < total:
            return start, NO_VERTEX, corner
        while i < len(data) and 45 <= data[i] <= 57 and data[i] != 46:  # - / and digits
            i += 1
        if i < len(data) and not is_blank(data[i]) and data[i] != 10:
            return start, NO_VERTEX, corner
        indices[corner] = vertex
        corner += 1
        i = skip_blanks(data, i)
    return i, FINE, corner

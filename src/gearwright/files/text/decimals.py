"""Numbers in text, read in compiled loops and rounded correctly.

A decimal number of up to 2⁵³ without its point, times or over a power of ten up to 10²², takes one multiplication or
division of numbers that are exact, so its result is correctly rounded (Clinger 1990, How to read floating point
numbers accurately). Longer ones are noted with their places and read one by one afterwards (`read_late`).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array, Indices
from ...compiled import compiled

Characters = NDArray[np.uint8]
"""The bytes of a text."""

FINE, NO_NUMBER, NOT_FINITE = 0, 1, 2
"""What reading a number comes to."""

LONGEST_WORD = 64
"""Characters of a number: the 24 of double precision and some more."""

_POWERS = np.array([10.0**k for k in range(23)])
_WHOLE = 2**53
_ENOUGH = 1 << 59
"""Whole numbers in text end here: no file counts as far."""


@compiled
def is_blank(character: int) -> bool:
    """Whether a character separates words of a line."""
    return character == 32 or (9 <= character <= 13 and character != 10)


@compiled
def skip_blanks(data: Characters, i: int) -> int:
    """The next place that is no blank; perhaps the end of the line or of the data."""
    while i < len(data) and is_blank(data[i]):
        i += 1
    return i


@compiled
def word_end(data: Characters, i: int) -> int:
    """Where a word ends."""
    while i < len(data) and not is_blank(data[i]) and data[i] != 10:
        i += 1
    return i


@compiled
def line_end(data: Characters, i: int) -> int:
    """Where a line ends: its "\\n" or the end of the data."""
    while i < len(data) and data[i] != 10:
        i += 1
    return i


@compiled
def ends_line(data: Characters, i: int) -> bool:
    """Whether at a place that is no blank a line ends or a comment begins."""
    return i >= len(data) or data[i] == 10 or data[i] == 35


@compiled
def whole_number(data: Characters, i: int) -> tuple[int, int]:
    """Where an integer ends and what it is; the place itself where there is none."""
    start, negative, value = i, False, 0
    if i < len(data) and (data[i] == 45 or data[i] == 43):
        negative = data[i] == 45
        i += 1
    first = i
    while i < len(data) and 48 <= data[i] <= 57:
        value = min(10 * value + (data[i] - 48), _ENOUGH)
        i += 1
    if i == first:
        return start, 0
    return i, -value if negative else value


@compiled
def _not_finite(data: Characters, i: int) -> bool:
    """Whether a word is nan, inf or infinity, perhaps with a sign or a kind in brackets."""
    if i < len(data) and (data[i] == 45 or data[i] == 43):
        i += 1
    if i + 3 > len(data):
        return False
    a, b, c = data[i] | 32, data[i + 1] | 32, data[i + 2] | 32
    return (a == 110 and b == 97 and c == 110) or (a == 105 and b == 110 and c == 102)


@compiled
def _decimal(data: Characters, i: int) -> tuple[int, int, int, int, int, bool]:
    """Where a decimal number ends, its digits as an integer, how many from the first that is not 0, the place of
    the last as a power of ten, the last, and whether there are any."""
    mantissa, digits, fraction, last = 0, 0, 0, 0
    point = found = False
    while i < len(data):
        c = data[i]
        if 48 <= c <= 57:
            last = c - 48
            found = True
            if digits or last:
                digits += 1
            if digits <= 18:
                mantissa = 10 * mantissa + last
            if point:
                fraction += 1
        elif c == 46 and not point:
            point = True
        else:
            break
        i += 1
    place = -fraction
    if found and i < len(data) and (data[i] | 32) == 101:
        after, exponent = whole_number(data, i + 1)
        found = after > i + 1
        i = after
        place += exponent
    return i, mantissa, digits, place, last, found


@compiled
def copied(values: NDArray[Any], target: NDArray[Any]) -> NDArray[Any]:
    """The target, filled with these numbers as far as both go. An assignment of arrays takes seconds to compile."""
    for k in range(min(len(values), len(target))):
        target[k] = values[k]
    return target


@compiled
def _noted(late: Indices, slot: int, start: int, end: int) -> Indices:
    """`late` with one more word."""
    count = late[0] + 1
    if 3 * count + 3 > len(late):
        late = copied(late, np.empty(2 * len(late), np.int64))
    late[0] = count
    late[3 * count], late[3 * count + 1], late[3 * count + 2] = slot, start, end
    return late


@compiled
def take(data: Characters, i: int, numbers: Array, slot: int, late: Indices, seen: Indices) -> tuple[int, int, Indices]:
    """Reads the word at a place into numbers[slot]: where it ends, what it comes to, and `late`.

    late   (3 m,), grown as needed: slot and ends of every word still to read; in the first three only their count
    seen   what the file's numbers look like, as `rounding.Written`: most digits, finest place, the last
           digits of those with the most as bits
    """
    start = i
    negative = i < len(data) and data[i] == 45
    if i < len(data) and (data[i] == 45 or data[i] == 43):
        i += 1
    i, mantissa, digits, place, last, found = _decimal(data, i)
    if not found or i - start > LONGEST_WORD or not (i >= len(data) or is_blank(data[i]) or data[i] == 10):
        return start, NOT_FINITE if _not_finite(data, start) else NO_NUMBER, late
    if digits > seen[0]:
        seen[0], seen[2] = digits, 0
    if digits == seen[0]:
        seen[2] |= 1 << last
    seen[1] = min(seen[1], place)
    if digits > 18 or mantissa > _WHOLE or (mantissa and not -22 <= place <= 22):
        return i, FINE, _noted(late, slot, start, i)
    value = float(mantissa)
    if mantissa:
        value = value / _POWERS[-place] if place < 0 else value * _POWERS[place]
    numbers[slot] = -value if negative else value
    return i, FINE, late


def none_late() -> Indices:
    """`late` of a file of which nothing is read yet."""
    return np.zeros(48, np.int64)


def none_seen() -> Indices:
    """`seen` of a file of which nothing is read yet."""
    return np.array([0, _ENOUGH, 0])


def read_late(text: bytes, numbers: Array, late: Indices) -> int | None:
    """Fills in the numbers that are still to read. The place of the first that is not finite, None if all are."""
    rows = late[3 : 3 * late[0] + 3].reshape(-1, 3)
    if not len(rows):
        return None
    values = np.array([float(text[start:end]) for start, end in rows[:, 1:].tolist()])
    numbers[rows[:, 0]] = values
    bad = np.flatnonzero(~np.isfinite(values))
    return int(rows[bad[0], 1]) if len(bad) else None

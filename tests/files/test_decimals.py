"""Words of a text as numbers, one at a time, against Python's own `float` and `Decimal`."""

from __future__ import annotations

from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.files.text.decimals import (
    FINE,
    NO_NUMBER,
    NOT_FINITE,
    ends_line,
    is_blank,
    none_late,
    none_seen,
    read_late,
    take,
    whole_number,
)


def taken(text, place=0, seen=None):
    """What reading the word at a place comes to, where it ends, and the number, with what is read late."""
    data = text.encode()
    numbers = np.full(1, 77.0)
    end, problem, late = take(
        np.frombuffer(data, np.uint8), place, numbers, 0, none_late(), none_seen() if seen is None else seen
    )
    beyond = read_late(data, numbers, late)
    return (problem if beyond is None else NOT_FINITE), end, float(numbers[0])


decimals = st.from_regex(r"[+-]?([0-9]{1,25}(\.[0-9]{0,25})?|\.[0-9]{1,25})([eE][+-]?[0-9]{1,2})?", fullmatch=True)


@settings(max_examples=200, deadline=None)
@given(decimals, st.sampled_from(["", " ", "\n", "\t1", "\r\n", " x"]))
def test_numbers_and_what_they_look_like(text, after):
    seen = none_seen()
    assert taken(f"; {text}{after}", 2, seen) == (FINE, 2 + len(text), float(text))
    _, digits, place = Decimal(text).as_tuple()
    kept = "".join(map(str, digits)).lstrip("0")
    assert seen.tolist() == [len(kept), min(place, 1 << 59), 1 << digits[-1]]


def test_the_most_digits_the_finest_place_and_their_last_digits():
    seen = none_seen()
    for text in ("1.25", "0.0007", "-31.6", "9", "100", "4e-6"):
        taken(text, 0, seen)
    assert seen.tolist() == [3, -6, 1 << 5 | 1 << 6 | 1 << 0]
    seen = none_seen()
    for text in ("0.1", "1.23", "4.5678"):
        taken(" " * 100 + text, 100, seen)
    assert seen.tolist() == [5, -4, 1 << 8]


def test_there_is_room_for_every_number_that_is_read_late():
    words = [f"{k}.5e-{200 + k}" for k in range(100)]
    data = " ".join(words).encode()
    numbers, late, place = np.zeros(100), none_late(), 0
    for slot in range(100):
        place, _, late = take(np.frombuffer(data, np.uint8), place, numbers, slot, late, none_seen())
        place += 1
        assert late[0] == slot + 1
        assert 3 * late[0] + 3 <= len(late) <= 6 * late[0] + 48
    assert read_late(data, numbers, late) is None
    assert numbers.tolist() == [float(word) for word in words]


@pytest.mark.parametrize(
    "text", ["nan", "NaN", "-nan", "+NAN", "inf", "-Infinity", "Inf", "nan(ind)", "1e400", "-1e999999"]
)
def test_not_finite(text):
    assert taken(text)[0] == NOT_FINITE
    assert taken(f" {text} 1", 1)[0] == NOT_FINITE


@pytest.mark.parametrize(
    "text",
    ["", "-", "+", ".", "-.", "e5", "1e", "1e+", "1e-x", "1x", "1..2", "1.2.3", "--1", "+-1", "1,5", "1_0", "0x1",
     "1/2", "1#", "1:", "/", "1D5", "1d5", "1" * 65, "n", "na", "in", "-in", "nax", "nxn", "xan", "inx", "ixf", "xnf",
     "anf", "inn", "naf"],
)  # fmt: skip
def test_no_numbers(text):
    assert taken(text)[:2] == (NO_NUMBER, 0)
    assert taken(f"{text}\n1")[:2] == (NO_NUMBER, 0)


def test_numbers_of_64_characters_are_the_longest():
    text = "-0." + "12345678901234567890" * 3 + "1"
    assert len(text) == 64
    assert taken(text) == (FINE, 64, float(text))
    assert taken(text + "2")[0] == NO_NUMBER


def test_exponents_beyond_all_integers():
    assert taken("1e-99999999999999999999")[::2] == (FINE, 0.0)
    assert taken("0e99999999999999999999")[::2] == (FINE, 0.0)
    assert taken("1e99999999999999999999")[0] == NOT_FINITE


def test_the_first_that_is_not_finite_is_found():
    data = b"1e300 1e400 1e-300 1e500"
    numbers, late, place = np.zeros(4), none_late(), 0
    for slot in range(4):
        place, problem, late = take(np.frombuffer(data, np.uint8), place, numbers, slot, late, none_seen())
        assert problem == FINE
        place += 1
    assert read_late(data, numbers, late) == 6
    assert numbers.tolist() == [1e300, np.inf, 1e-300, np.inf]


@pytest.mark.parametrize(
    ("text", "end", "value"),
    [("0", 1, 0), ("-12 ", 3, -12), ("+7/", 2, 7), ("90", 2, 90), ("-", 0, 0), ("+", 0, 0), ("x", 0, 0), ("", 0, 0),
     (":", 0, 0), ("/", 0, 0), ("123456789012345678", 18, 123456789012345678),
     ("9" * 40, 40, 1 << 59), ("-" + "9" * 40, 41, -(1 << 59))],
)  # fmt: skip
def test_whole_numbers(text, end, value):
    assert whole_number(np.frombuffer(text.encode(), np.uint8), 0) == (end, value)


def test_blanks_separate_words_and_line_feeds_and_comments_end_lines():
    assert [c for c in range(256) if is_blank(c)] == [9, 11, 12, 13, 32]
    ends = [c for c in range(256) if ends_line(np.array([c], np.uint8), 0)]
    assert ends == [10, ord("#")]
    assert ends_line(np.array([65], np.uint8), 1)
    assert not ends_line(np.array([65, 10], np.uint8), 0)

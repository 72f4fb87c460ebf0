"""Parallel keys against published tables, and which bore has which."""

from itertools import pairwise

import pytest

from gearwright.elements.standards.din_6885 import LEAST_BORE, MOST_BORE, PARALLEL_KEYS, parallel_key

# Siemens, catalogue MD 31.1 (2016), p. 7/3: Ø above, up to, b, h, t₁ and the t₂ of d + t₂, all in mm
MD_31 = """
38 44 12 8 5 3.3 | 44 50 14 9 5.5 3.8 | 50 58 16 10 6 4.3 | 58 65 18 11 7 4.4 | 65 75 20 12 7.5 4.9 | 75 85 22 14 9 5.4
85 95 25 14 9 5.4 | 95 110 28 16 10 6.4 | 110 130 32 18 11 7.4 | 130 150 36 20 12 8.4 | 150 170 40 22 13 9.4
170 200 45 25 15 10.4 | 200 230 50 28 17 11.4
"""


@pytest.mark.parametrize("row", [row.strip() for row in MD_31.replace("\n", "|").split("|") if row.strip()])
def test_keys_are_those_of_a_published_table(row):
    over, up_to, *sizes = map(float, row.split())
    for bore in (over + 0.001, (over + up_to) / 2.0, up_to):
        key = parallel_key(bore)
        assert [key.width, key.height, key.shaft_depth, key.hub_depth] == sizes


def test_the_rows_follow_one_another():
    assert (LEAST_BORE, MOST_BORE) == (6.0, 500.0)
    for a, b in pairwise(PARALLEL_KEYS):
        assert a.up_to == b.over
        assert a.width < b.width
        assert a.height <= b.height
        assert a.hub_depth <= b.hub_depth


@pytest.mark.parametrize("key", PARALLEL_KEYS, ids=lambda key: f"{key.width}×{key.height}")
def test_a_key_stands_proud_of_its_shaft_and_leaves_a_little_room_above_it(key):
    """h < t₁ + t₂ < h + 0.6 mm in every row: the key bears on its sides alone."""
    assert key.hub_depth < key.height < key.shaft_depth + key.hub_depth < key.height + 0.6
    assert key.width < key.over


@pytest.mark.parametrize("bore", [0.1, 6.0, 500.001, 1e6])
def test_other_bores_have_none(bore):
    assert parallel_key(bore) is None


def test_a_bore_in_inches_is_not_above_the_limit_that_it_is():
    inches = [round(key.up_to / 25.4, 11) for key in PARALLEL_KEYS]
    assert any(25.4 * bore > key.up_to for bore, key in zip(inches, PARALLEL_KEYS, strict=True))
    assert [parallel_key(25.4 * bore) for bore in inches] == list(PARALLEL_KEYS)

"""Joining equal points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearwright.files import welding

points = st.lists(st.tuples(*3 * [st.sampled_from([0.0, -0.0, 1.0, 1.0 + 2**-23, 5e-324, -1e300])]), max_size=30)


def by_dictionary(given):
    numbers: dict[tuple[float, ...], int] = {}
    found = [numbers.setdefault(tuple(point), len(numbers)) for point in given.tolist()]
    return np.array(list(numbers)).reshape(-1, 3), found


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("colliding", [False, True])
def test_agrees_with_a_dictionary(dtype, colliding, monkeypatch):
    if colliding:
        monkeypatch.setattr(welding, "_hashes", lambda columns: np.zeros(columns.shape[1], np.uint64))

    @given(points)
    def check(listed):
        with np.errstate(over="ignore", under="ignore"):
            given_points = np.array(listed, dtype=float).reshape(-1, 3).astype(dtype)
        vertices, numbers = welding.welded(given_points)
        expected, expected_numbers = by_dictionary(given_points)
        np.testing.assert_array_equal(vertices, expected)
        assert numbers.tolist() == expected_numbers
        assert vertices.dtype == np.float64

    check()

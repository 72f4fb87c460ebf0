"""Error-free transformations against rational arithmetic."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gearwright.moments import compensated

numbers = st.floats(-1e100, 1e100, allow_subnormal=False).filter(lambda x: x == 0 or abs(x) > 1e-100)


def value(pair):
    return sum(Fraction(np.asarray(part).item()) for part in pair)


def array(x):
    return np.array([x])


@given(numbers, numbers)
def test_a_sum_with_its_error_is_exact(a, b):
    assert value(compensated.two_sum(array(a), array(b))) == Fraction(a) + Fraction(b)


@given(st.lists(numbers, max_size=40))
def test_sum_is_rounded_about_once(values):
    total = float(compensated.compensated_sum(np.array(values)))
    exact, magnitude = math.fsum(values), math.fsum(map(abs, values))
    assert abs(total - exact) <= 2.0**-52 * abs(exact) + 1e-30 * magnitude


def test_sum_keeps_what_cancellation_leaves():
    values = np.array([[1e16, 1.0, -1e16, 1e-8], [1.0, 2.0, 3.0, 4.0]])
    np.testing.assert_array_equal(compensated.compensated_sum(values), [1.00000001, 10.0])


def test_running_sum_takes_blocks_of_any_width():
    running = compensated.RunningSum((2, 3))
    running.take(np.array([[1e16, 1.0, 1.0], [1.0, 1.0, 1.0]]))
    running.take(np.array([[-1e16, 2.0], [1.0, 1.0]]), np.array([[0.5, 0.0], [0.0, 0.25]]))
    np.testing.assert_array_equal(running.total(), [4.5, 5.25])

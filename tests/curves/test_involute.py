"""The planar involute: the taut string, its function and the inverses."""

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.curves.involute import Involute, inverse_involute_function, involute_function, involute_roll


def test_the_string_is_tangent_to_the_base_circle_and_as_long_as_the_arc_it_left():
    roll = np.linspace(0.1, 3.0, 7)
    involute = Involute(base_radius=2.5, interval=(0.0, 3.0))
    foot = 2.5 * np.stack([np.cos(roll), np.sin(roll)], axis=-1)
    string = involute.point(roll) - foot
    np.testing.assert_allclose(np.linalg.norm(string, axis=1), 2.5 * roll)
    np.testing.assert_allclose(np.sum(string * foot, axis=1), 0.0, atol=1e-14)
    np.testing.assert_allclose(np.sum(string * involute.derivative(roll), axis=1), 0.0, atol=1e-14)
    assert np.all(string[:, 0] * -np.sin(roll) + string[:, 1] * np.cos(roll) < 0.0)
    np.testing.assert_array_equal(involute.start, [2.5, 0.0])


@pytest.mark.parametrize(
    ("degrees", "table"), [(14.5, 0.0055448), (20.0, 0.0149044), (25.0, 0.0299753), (30.0, 0.0537515)]
)
def test_the_involute_function_has_its_tabulated_values(degrees, table):
    assert involute_function(np.radians(degrees)) == pytest.approx(table, abs=5e-8)
    assert np.degrees(inverse_involute_function(table)) == pytest.approx(degrees, abs=1e-4)


def test_the_involute_function_is_the_azimuth_of_the_point_with_that_pressure_angle():
    angle = np.array([0.1, 0.5, 1.0])
    x, y = Involute(base_radius=3.0, interval=(0.0, 2.0)).point(np.tan(angle)).T
    np.testing.assert_allclose(np.arctan2(y, x), involute_function(angle), rtol=1e-13)
    np.testing.assert_allclose(3.0 / np.hypot(x, y), np.cos(angle), rtol=1e-14)


@given(st.floats(0.0, 5.0))
def test_the_roll_at_a_radius_reaches_it(excess):
    radius = 1.7 * (1.0 + excess)
    reached = np.linalg.norm(Involute(base_radius=1.7, interval=(0.0, 1.0)).point(involute_roll(radius, 1.7)))
    assert reached == pytest.approx(radius, rel=1e-14)


def test_the_roll_is_precise_next_to_the_base_circle():
    with mp.workdps(40):
        radius = mp.mpf(1.0 + 2.0**-40)
        assert involute_roll(1.0 + 2.0**-40, 1.0) == pytest.approx(float(mp.sqrt(radius**2 - 1)), rel=1e-15, abs=0.0)


@given(st.floats(1e-2, 1.55))
@settings(deadline=None)
def test_the_inverse_undoes_the_function(angle):
    with mp.workdps(40):
        value = float(mp.tan(angle) - mp.mpf(angle))
    assert inverse_involute_function(value) == pytest.approx(angle, rel=1e-10)


def test_the_inverse_vectorises_and_is_nought_at_the_cusp():
    values = np.array([[0.0, 0.01], [1.0, 1e3]])
    angles = inverse_involute_function(values)
    assert angles.shape == (2, 2)
    assert angles[0, 0] == 0.0
    np.testing.assert_allclose(np.tan(angles) - angles, values, rtol=1e-10)


@pytest.mark.parametrize("value", [1e-6, 1e-9, 1e-15, 1e-21, 1e-25, 1e-30])
def test_the_inverse_is_precise_near_the_cusp(value):
    with mp.workdps(60):
        guess = mp.cbrt(3 * mp.mpf(value))
        exact = float(mp.findroot(lambda a: mp.tan(a) - a - mp.mpf(value), guess))
    assert inverse_involute_function(value) == pytest.approx(exact, rel=1e-13, abs=0.0)


@pytest.mark.parametrize("value", [-1e-9, np.nan, [0.1, -0.2]])
def test_values_off_the_branch_are_refused(value):
    with pytest.raises(ValueError, match="negative"):
        inverse_involute_function(value)

"""The exact spherical involute against its geometry, multi-precision arithmetic and published values."""

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.curves.involute import Involute
from gearwright.curves.spherical_involute import (
    SphericalInvolute,
    azimuth,
    polar_angle,
    roll_at_azimuth,
    roll_at_polar_angle,
    spherical_involute_function,
)

CONES = [0.01, 0.1, 1.0, 5.0, 10.0, 20.0, 35.0, 50.0, 70.0, 85.0, 89.0, 89.9]
CONES_IN_DEGREES = st.floats(0.01, 89.9)
FRACTIONS_OF_CURVE = st.floats(0.0, 1.0)


def whole_roll(gamma):
    return np.pi / np.sin(gamma)


def whole_azimuth(gamma):
    """π/sin γ_b − π, to 1e-13 up to 89.9°."""
    return 2.0 * np.pi * np.sin(np.pi / 4.0 - gamma / 2.0) ** 2 / np.sin(gamma)


@pytest.mark.parametrize(
    ("cone", "pole_angle", "expected"),
    [(10, 20, 0.82625698), (10, 30, 2.96956669), (50, 20, 0.33745438), (50, 45, 3.89235852)],
)
def test_published_values_in_degrees(cone, pole_angle, expected):
    value = np.degrees(spherical_involute_function(np.radians(pole_angle), np.radians(cone)))
    assert value == pytest.approx(expected, abs=5.1e-9)


@pytest.mark.parametrize("cone", CONES)
class TestString:
    """A taut string unwound from the cone along a great circle."""

    def setup_method(self):
        self.fractions = np.array([1e-3, 0.02, 0.2, 0.49, 0.5, 0.51, 0.8, 0.99])

    def curve(self, cone):
        gamma = np.radians(cone)
        curve = SphericalInvolute(base_cone_angle=gamma, interval=(0.0, whole_roll(gamma)))
        beta = curve.parameter(self.fractions)
        tangent_points = np.stack(
            [np.sin(gamma) * np.cos(beta), np.sin(gamma) * np.sin(beta), np.full(8, np.cos(gamma))], axis=-1
        )
        onward = np.stack([-np.sin(beta), np.cos(beta), np.zeros(8)], axis=-1)
        return curve, beta, tangent_points, onward

    def test_points_lie_on_the_unit_sphere(self, cone):
        curve, beta, _, _ = self.curve(cone)
        np.testing.assert_allclose(np.linalg.norm(curve.point(beta), axis=1), 1.0, atol=4e-16)

    def test_it_starts_on_the_base_cone_at_azimuth_nought_and_ends_on_the_opposite_cone(self, cone):
        curve, _, _, _ = self.curve(cone)
        gamma = np.radians(cone)
        np.testing.assert_allclose(curve.start, [np.sin(gamma), 0.0, np.cos(gamma)], atol=1e-16)
        assert curve.end[2] == pytest.approx(-np.cos(gamma), abs=1e-15)

    def test_the_string_is_as_long_as_the_arc_it_left_on_the_cone(self, cone):
        curve, beta, tangent_points, _ = self.curve(cone)
        p = curve.point(beta)
        string = np.arctan2(np.linalg.norm(np.cross(p, tangent_points), axis=1), np.sum(p * tangent_points, axis=1))
        np.testing.assert_allclose(string, beta * np.sin(np.radians(cone)), atol=1e-13)

    def test_the_string_is_tangent_to_the_cone_and_points_back(self, cone):
        curve, beta, tangent_points, onward = self.curve(cone)
        p = curve.point(beta)
        string = p - np.sum(p * tangent_points, axis=1, keepdims=True) * tangent_points
        length = np.linalg.norm(string, axis=1)
        np.testing.assert_allclose(np.sum(string * onward, axis=1), -length, atol=1e-13)

    def test_the_curve_runs_at_right_angles_to_the_string(self, cone):
        curve, beta, tangent_points, _ = self.curve(cone)
        p, velocity = curve.point(beta), curve.derivative(beta)
        direction = velocity / np.linalg.norm(velocity, axis=1, keepdims=True)
        assert np.max(np.abs(np.sum(direction * p, axis=1))) < 1e-12
        assert np.max(np.abs(np.sum(direction * tangent_points, axis=1))) < 1e-12
        assert np.all(np.diff(p[:, 2]) < 0.0)

    def test_polar_angle_and_azimuth_are_those_of_the_points(self, cone):
        curve, beta, _, _ = self.curve(cone)
        gamma = np.radians(cone)
        delta, psi = polar_angle(beta, gamma), azimuth(beta, gamma)
        rebuilt = np.stack([np.sin(delta) * np.cos(psi), np.sin(delta) * np.sin(psi), np.cos(delta)], axis=-1)
        np.testing.assert_allclose(rebuilt, curve.point(beta), atol=4e-16 * np.max(beta) + 1e-15)

    def test_azimuth_grows_without_a_jump_to_the_end(self, cone):
        gamma = np.radians(cone)
        beta = np.linspace(0.0, whole_roll(gamma), 4001)
        psi = azimuth(beta, gamma)
        step = beta[1] - beta[0]
        assert psi[0] == 0.0
        assert np.all(np.diff(psi) >= 0.0)
        assert np.all(np.diff(psi) <= step * np.cos(gamma) ** 2 * 1.0001 + 1e-11)  # dψ/dβ ≤ cos²γ_b, at the equator
        assert psi[-1] == pytest.approx(whole_azimuth(gamma), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("cone", CONES)
def test_azimuth_keeps_relative_precision_from_the_cusp_to_the_end(cone):
    gamma = float(np.radians(cone))
    top = whole_roll(gamma)
    rolls = np.concatenate([np.geomspace(1e-8, top * (1.0 - 1e-15), 24), np.linspace(0.97, 1.03, 5)])
    rolls = rolls[rolls < top]
    with mp.workdps(60):
        s = mp.sin(mp.mpf(gamma))
        exact = [mp.mpf(b) - mp.atan2(mp.sin(b * s), s * mp.cos(b * s)) for b in map(mp.mpf, map(float, rolls))]
        errors = [abs(mp.mpf(float(a)) / b - 1) for a, b in zip(azimuth(rolls, gamma), exact, strict=True)]
    assert max(errors) < 3e-15


@pytest.mark.parametrize("cone", CONES)
def test_polar_angle_keeps_relative_precision(cone):
    gamma = float(np.radians(cone))
    rolls = np.concatenate([[1e-9, 1e-4], np.linspace(0.001, 0.999, 20) * whole_roll(gamma)])
    with mp.workdps(60):
        exact = [mp.acos(mp.cos(mp.mpf(gamma)) * mp.cos(mp.mpf(float(b)) * mp.sin(mp.mpf(gamma)))) for b in rolls]
        errors = [abs(mp.mpf(float(a)) / b - 1) for a, b in zip(polar_angle(rolls, gamma), exact, strict=True)]
    assert max(errors) < 2e-15


@given(cone=CONES_IN_DEGREES, fraction=FRACTIONS_OF_CURVE)
@settings(deadline=None, max_examples=200)
def test_the_roll_at_an_azimuth_brings_the_azimuth_back(cone, fraction):
    gamma = np.radians(cone)
    whole = whole_azimuth(gamma) * (1.0 - 1e-12)
    psi = fraction * whole
    roll = roll_at_azimuth(psi, gamma)
    assert 0.0 <= roll <= whole_roll(gamma) * (1.0 + 1e-15)
    rolls_error = 4e-16 * whole_roll(gamma)  # of a roll itself, at dψ/dβ ≤ 1
    assert azimuth(roll, gamma) == pytest.approx(psi, rel=1e-14, abs=rolls_error if fraction > 0.4 else 0.0)


@given(cone=CONES_IN_DEGREES, fraction=FRACTIONS_OF_CURVE)
@settings(deadline=None, max_examples=200)
def test_the_roll_at_a_polar_angle_brings_the_polar_angle_back(cone, fraction):
    gamma = np.radians(cone)
    delta = min(max(gamma + fraction * (np.pi - 2.0 * gamma), gamma), np.pi - gamma)
    roll = roll_at_polar_angle(delta, gamma)
    assert 0.0 <= roll <= whole_roll(gamma) * (1.0 + 1e-15)
    assert polar_angle(roll, gamma) == pytest.approx(delta, rel=4e-15, abs=0.0)


@given(cone=st.floats(1.0, 85.0), fraction=st.floats(0.001, 0.98))
@settings(deadline=None, max_examples=100)
def test_both_inverses_find_the_roll(cone, fraction):
    gamma = np.radians(cone)
    roll = fraction * whole_roll(gamma)
    assert roll_at_azimuth(azimuth(roll, gamma), gamma) == pytest.approx(roll, rel=1e-11)
    assert roll_at_polar_angle(polar_angle(roll, gamma), gamma) == pytest.approx(roll, rel=1e-9)


@pytest.mark.parametrize("cone", CONES)
def test_the_inverses_vectorise_from_cusp_to_end(cone):
    gamma = np.radians(cone)
    psi = whole_azimuth(gamma) * np.array([[0.0, 1e-20, 1e-6], [0.3, 0.5, 0.9]])
    rolls = roll_at_azimuth(psi, gamma)
    assert rolls.shape == (2, 3)
    assert rolls[0, 0] == 0.0
    np.testing.assert_allclose(azimuth(rolls, gamma), psi, rtol=1e-13)
    np.testing.assert_allclose(
        roll_at_polar_angle([np.pi / 2.0], gamma), [whole_roll(gamma) / 2.0], rtol=1e-15 / np.cos(gamma) + 1e-15
    )


@pytest.mark.parametrize("cone", np.arange(0.5, 90.0, 3.5))
def test_the_polar_angles_of_the_cusp_and_the_equator_have_their_rolls(cone):
    gamma = np.radians(cone)
    assert roll_at_polar_angle(gamma, gamma) == 0.0
    assert roll_at_polar_angle(np.pi / 2.0, gamma) == pytest.approx(whole_roll(gamma) / 2.0, rel=1e-13)


def test_the_ends_of_the_curve_round_trip_by_polar_angle():
    for gamma in np.radians(np.arange(0.5, 90.0, 0.5)):
        for roll in (0.0, whole_roll(gamma)):
            back = roll_at_polar_angle(polar_angle(roll, gamma), gamma)
            assert back * np.sin(gamma) == pytest.approx(roll * np.sin(gamma), abs=1e-6)


@pytest.mark.parametrize("pole_angle", [-0.5, 3.3, np.nan])
def test_an_angle_at_the_pole_off_the_curve_is_refused(pole_angle):
    with pytest.raises(ValueError, match="180"):
        spherical_involute_function(pole_angle, 0.3)


@pytest.mark.parametrize("cone", [0.0, -10.0, 90.0, 120.0, np.nan])
def test_what_is_no_cone_is_refused(cone):
    gamma = np.radians(cone)
    for call in (
        lambda: SphericalInvolute(base_cone_angle=gamma, interval=(0.0, 1.0)),
        lambda: azimuth(0.3, gamma),
        lambda: polar_angle(0.3, gamma),
        *([lambda: spherical_involute_function(0.3, gamma)] if gamma else []),
        lambda: roll_at_azimuth(0.3, gamma),
        lambda: roll_at_polar_angle(0.3, gamma),
    ):
        with pytest.raises(ValueError, match="between 0 and 90°"):
            call()


@pytest.mark.parametrize("delta", [29.9, 150.1, np.nan])
def test_a_polar_angle_off_the_curve_is_refused(delta):
    with pytest.raises(ValueError, match="30° base cone"):
        roll_at_polar_angle(np.radians([60.0, delta]), np.radians(30.0))


@pytest.mark.parametrize("psi", [-0.01, 180.01, np.nan])
def test_an_azimuth_off_the_curve_is_refused(psi):
    with pytest.raises(ValueError, match="from 0 to 180°"):  # π/sin 30° − π
        roll_at_azimuth(np.radians([60.0, psi]), np.radians(30.0))


def test_the_limit_of_a_slender_cone_is_the_planar_involute():
    roll = np.linspace(0.0, 2.5, 9)
    plane = Involute(base_radius=1.0, interval=(0.0, 2.5)).point(roll)

    def difference(gamma):
        sphere = SphericalInvolute(base_cone_angle=gamma, interval=(0.0, 2.5)).point(roll)
        return np.max(np.abs(sphere[:, :2] / np.sin(gamma) - plane))

    assert difference(1e-3) < 1e-5
    assert difference(1e-2) / difference(1e-3) == pytest.approx(100.0, rel=0.01)
    involute_function = np.tan(0.4) - 0.4
    assert spherical_involute_function(0.4, 1e-7) == pytest.approx(involute_function, rel=1e-12)

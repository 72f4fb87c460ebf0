"""Curves that a crown gear leaves on a gear, against envelopes, limits and the spherical involute."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.curves.curve import turn
from gearwright.curves.octoid import Octoid, least_turn, turn_at_polar_angle
from gearwright.curves.relieved_rolled import RelievedRolled
from gearwright.curves.rolled_involute import RolledInvolute
from gearwright.curves.spherical_involute import SphericalInvolute
from gearwright.curves.spherical_trochoid import SphericalTrochoid
from gearwright.curves.trochoid import Trochoid

CONES = [0.01, 3.0, 20.0, 38.66, 48.0, 48.5, 51.34, 75.0, 89.9, 90.0]
EVERY_CONE = pytest.mark.parametrize("cone", CONES)
A = np.radians(20.0)


def octoid(cone, a=A):
    gamma = np.radians(cone)
    return Octoid(pitch_angle=gamma, pressure_angle=a, interval=(least_turn(gamma, a), np.pi / 2.0))


def plane_in_gear(cone, crown_turn, a=A):
    """Normal of the crown gear's flank in the gear, both having turned; of a crown gear whose axis and pitch line are
    at right angles, turned clockwise about its axis by `crown_turn`, as the gear about its own by 1/sin γ of it."""
    gamma = np.radians(cone)
    axis, crown_axis = np.array([0.0, 0.0, 1.0]), np.array([-np.cos(gamma), 0.0, np.sin(gamma)])
    pitch_line = np.array([np.sin(gamma), 0.0, np.cos(gamma)])
    beside = np.cross(crown_axis, pitch_line)
    assert np.cross(axis, pitch_line) @ beside > 0.0  # both turn the same way at the pitch line
    still = np.sin(a) * crown_axis + np.cos(a) * beside
    c, s = np.cos(-crown_turn), np.sin(-crown_turn)
    turned = c * still + s * np.cross(crown_axis, still) + (1.0 - c) * (crown_axis @ still) * crown_axis
    return turn(crown_turn / np.sin(gamma), 3) @ turned


@EVERY_CONE
def test_an_octoid_is_the_envelope_of_the_crown_gear_s_plane_flank(cone):
    """Every plane touches its own point, and no point of the curve nearby is on another side of it."""
    curve = octoid(cone)
    inside = curve.parameter(np.linspace(0.03, 0.97, 15))
    for u, point, tangent in zip(inside, curve.point(inside), curve.derivative(inside), strict=True):
        normal = plane_in_gear(cone, u)
        assert normal @ point == pytest.approx(0.0, abs=2e-15)
        assert normal @ tangent == pytest.approx(0.0, abs=1e-15 / np.sin(curve.pitch_angle))


def test_the_octoid_of_a_crown_gear_is_half_a_great_circle():
    curve = octoid(90.0, 0.3)
    points = curve.point(curve.parameter(np.linspace(0.0, 1.0, 21)))
    np.testing.assert_allclose(points @ [0.0, np.cos(0.3), np.sin(0.3)], 0.0, atol=1e-15)
    np.testing.assert_allclose(points[[0, -1], 2], [np.cos(0.3), -np.cos(0.3)], atol=1e-15)
    np.testing.assert_allclose(curve.azimuth(0.7) > 0.0, np.bool_(True))


@EVERY_CONE
@pytest.mark.parametrize("a", [8.0, 20.0, 35.0])
def test_the_inner_end_is_the_first_cusp_or_where_the_great_circle_ends(cone, a):
    gamma, a = np.radians(cone), np.radians(a)
    curve = octoid(cone, a)
    speed = np.linalg.norm(curve.derivative(curve.parameter(np.linspace(0.0, 1.0, 4001)[1:-1])), axis=-1)
    end = float(np.linalg.norm(curve.derivative(curve.interval[0])))
    if curve.interval[0] > -np.pi / 2.0:
        assert end < 1e-14
        assert np.all(np.diff(speed[:100]) > 0.0)  # from nought at the cusp
    else:
        assert end > 1e-4
        assert np.sin(a) * np.tan(min(gamma, 1.57)) > 2.0 / np.sqrt(27.0) or np.cos(a) < 1.0 / np.sqrt(3.0)
    assert speed.min() > 0.0
    polar = curve.polar_angle(curve.parameter(np.linspace(0.0, 1.0, 4001)))
    assert np.all(np.diff(polar) > 0.0)


@EVERY_CONE
def test_polar_angles_and_azimuths_are_those_of_the_points(cone):
    curve = octoid(cone)
    u = curve.parameter(np.linspace(0.0, 1.0, 31))
    x, y, z = curve.point(u).T
    np.testing.assert_allclose(np.tan(curve.polar_angle(u) / 2.0), np.hypot(x, y) / (1.0 + z), rtol=1e-14)
    half = curve.azimuth(u) / 2.0
    difference = np.arctan2(y, x) / 2.0 - half
    rounding = 1e-15 * (1.0 + 1.0 / np.sin(curve.pitch_angle))  # the gear turns so much faster
    np.testing.assert_allclose(np.sin(difference) * np.cos(difference), 0.0, atol=rounding)  # whole turns
    assert curve.azimuth(0.0) == 0.0
    assert np.all(np.abs(np.diff(curve.azimuth(np.linspace(*curve.interval, 200_001)))) < 0.1)  # no jumps
    assert np.all(np.diff(curve.azimuth(u[u >= 0.0])) > 0.0)


@settings(deadline=None)
@given(cone=st.floats(0.01, 90.0), fraction=st.floats(0.0, 1.0), a=st.floats(5.0, 40.0))
def test_the_turn_at_a_polar_angle_leads_back_to_it(cone, fraction, a):
    curve = octoid(cone, np.radians(a))
    u = max(float(curve.parameter(fraction)), -1.3)  # nearer to −π/2 the turn itself is known less well, and not needed
    polar = curve.polar_angle(u)
    found = turn_at_polar_angle(polar, curve.pitch_angle, curve.pressure_angle)
    # the flatter the pressure angle, the more the polar angle moves with the last digit of the turn
    rounding = 3e-15 * (1.0 + 1.0 / np.sin(np.radians(a)))
    assert curve.polar_angle(found) == pytest.approx(float(polar), rel=rounding, abs=1e-300)
    assert curve.interval[0] <= found <= curve.interval[1]


def test_the_turn_at_the_ends_is_the_interval_s():
    for cone in CONES:
        curve = octoid(cone)
        ends = curve.polar_angle(np.array(curve.interval))
        found = turn_at_polar_angle(ends, curve.pitch_angle, A)
        np.testing.assert_allclose(found, curve.interval, atol=1e-7)  # polar angles are flat there
        assert found[0] == curve.interval[0]
        assert turn_at_polar_angle(curve.pitch_angle, curve.pitch_angle, A) == pytest.approx(0.0, abs=1e-15)


def test_polar_angles_off_the_octoid_are_refused():
    with pytest.raises(ValueError, match=r"lies between polar angles 27\.93"):
        turn_at_polar_angle(np.radians([40.0, 27.0]), np.radians(30.0), A)
    with pytest.raises(ValueError, match="and 100°"):
        turn_at_polar_angle(np.radians(100.1), np.radians(30.0), A)
    with pytest.raises(ValueError, match="a pitch cone of up to 90°"):
        Octoid(pitch_angle=1.6, pressure_angle=0.3, interval=(0.0, 1.0))
    with pytest.raises(ValueError, match="pressure angle between 0 and 90°"):
        least_turn(1.0, 0.0)


@EVERY_CONE
def test_the_rolled_involute_is_the_spherical_involute(cone):
    gamma = np.radians(cone)
    base = float(np.arcsin(np.sin(gamma) * np.cos(A)))
    at_pitch = float(np.arccos(min(np.cos(gamma) / np.cos(base), 1.0)))
    u = np.linspace(-at_pitch / np.cos(A), min(1.0, 3.0 * gamma), 15)
    roll = (at_pitch + np.cos(A) * u) / np.sin(base)
    plain = SphericalInvolute(base_cone_angle=base, interval=(0.0, 1.0)).point(roll)
    rolled = RolledInvolute(pitch_angle=gamma, pressure_angle=A, interval=(0.0, 1.0))
    at = SphericalInvolute(base_cone_angle=base, interval=(0.0, 1.0)).point(at_pitch / np.sin(base))
    back = turn(-np.arctan2(at[1], at[0]), 3)
    tolerance = 1e-14 if cone > 1.0 else 1e-10  # arccos near 1, of this test
    np.testing.assert_allclose(rolled.point(u), plain @ back.T, atol=tolerance)


@pytest.mark.parametrize("depth", [0.3, 0.0, -0.04])
def test_the_limit_of_a_slender_cone_is_the_planar_trochoid(depth):
    t = np.linspace(np.pi / 2.0, 0.4, 9)
    plane = Trochoid(pitch_radius=1.0, depth=depth, offset=0.1, half_axes=(0.08, 0.08), interval=(1.0, 0.4)).point(t)

    def difference(gamma):
        sphere = SphericalTrochoid(
            pitch_angle=gamma, depth=depth * gamma, offset=0.1 * gamma, radius=0.08 * gamma, interval=(1.0, 0.4)
        )
        return np.max(np.abs(sphere.point(t)[:, :2] / gamma - plane))

    assert difference(1e-3) < 1e-6
    assert difference(1e-2) / difference(1e-3) == pytest.approx(100.0, rel=0.01)


def test_the_limit_of_a_slender_octoid_is_the_planar_involute():
    gamma, base = 1e-4, np.cos(A)
    polar = gamma * np.array([0.95, 1.0, 1.05, 1.3])
    curve = octoid(np.degrees(gamma))
    azimuth = curve.azimuth(turn_at_polar_angle(polar, gamma, A))

    def inv(radius):
        return np.sqrt((radius / base) ** 2 - 1.0) - np.arccos(base / radius)

    np.testing.assert_allclose(azimuth, inv(polar / gamma) - inv(1.0), atol=1e-8)


@pytest.mark.parametrize(
    "curve",
    [
        octoid(40.0),
        RolledInvolute(pitch_angle=1.2, pressure_angle=A, interval=(-0.1, 0.3)),
        SphericalTrochoid(pitch_angle=0.7, depth=0.06, offset=0.02, radius=0.03, interval=(np.pi / 2.0, A)),
    ],
    ids=lambda curve: type(curve).__name__,
)
def test_bisection_finds_the_parameter_at_a_polar_angle_and_the_nearer_end_beyond(curve):
    u = curve.parameter(np.linspace(0.05, 1.0, 7))
    np.testing.assert_allclose(curve.at_polar_angle(curve.polar_angle(u)), u, atol=1e-12)
    lowest, highest = sorted(curve.interval, key=lambda end: float(curve.polar_angle(end)))
    np.testing.assert_allclose(curve.at_polar_angle([0.0, np.pi]), [lowest, highest], atol=1e-15)


@pytest.mark.parametrize("power", [1, 2])
def test_relief_moves_a_point_along_the_great_circle_normal_to_the_flank(power):
    flank = octoid(55.0)
    relieved = RelievedRolled(
        pitch_angle=flank.pitch_angle, flank=flank, amount=0.01, begin=0.1, full=0.5, power=power, interval=(0.1, 0.5)
    )
    u = np.array([0.1, 0.2, 0.3, 0.5])
    points, moved, tangents = flank.point(u), relieved.point(u), flank.derivative(u)
    amounts = 0.01 * np.array([0.0, 0.25, 0.5, 1.0]) ** power
    np.testing.assert_allclose(np.arccos(np.clip(np.sum(points * moved, axis=1), -1, 1)), amounts, atol=1e-8)
    np.testing.assert_allclose(np.sum(tangents * moved, axis=1), 0.0, atol=1e-15)
    assert np.all(relieved.azimuth(u[1:]) > flank.azimuth(u[1:]))  # into the tooth
    assert np.all(relieved.polar_angle(u[1:]) < flank.polar_angle(u[1:]))
    np.testing.assert_allclose(moved[0], points[0], atol=1e-15)


def test_a_relieved_flank_of_another_cone_is_refused():
    with pytest.raises(ValueError, match="the pitch cone of the flank"):
        RelievedRolled(
            pitch_angle=0.5, flank=octoid(55.0), amount=0.01, begin=0.1, full=0.5, power=1, interval=(0.1, 0.5)
        )

"""Recipes that exact flanks are compared with: what they are, built another way, and how far apart theory has them."""

import numpy as np
import pytest
from scipy.optimize import minimize

from gearwright.curves.involute import Involute
from gearwright.elements.bevel.comparison import normal_deviations, thesis_azimuth, tredgold_azimuth
from gearwright.elements.bevel.spherical_flank import spherical_flank

PRESSURE = np.radians(20.0)
GEAR = np.arctan2(20, 16)
MICROMETRES = 1000.0 * 20 / (2.0 * np.sin(GEAR))  # of a radian, per mm of module, at the gear's outer end


def wrapped(pitch_angle, rolls):
    """Polar angles and azimuths of the virtual gear's involute, laid around the back cone point by point."""
    back = np.tan(pitch_angle)  # slant height of the back cone at the cone distance 1
    plane = Involute(base_radius=back * np.cos(PRESSURE), interval=(0.0, 1.0)).point(rolls)
    slant, angle = np.hypot(*plane.T), np.arctan2(plane[:, 1], plane[:, 0])
    rho, z = slant * np.cos(pitch_angle), 1.0 / np.cos(pitch_angle) - slant * np.sin(pitch_angle)
    return np.arctan2(rho, z), angle / np.cos(pitch_angle)


@pytest.mark.parametrize("pitch_angle", [0.2, GEAR, 1.4])
def test_tredgolds_flank_is_the_virtual_gears_wrapped_around_the_back_cone(pitch_angle):
    polar, azimuth = wrapped(pitch_angle, np.tan(PRESSURE) + np.array([0.0, -0.1, 0.1]))
    at_pitch, azimuth = polar[0], azimuth - azimuth[0]
    assert at_pitch == pytest.approx(pitch_angle, abs=2e-15)  # tan of 80° and back
    np.testing.assert_allclose(tredgold_azimuth(polar, pitch_angle, PRESSURE), azimuth, atol=4e-15)


def test_tredgolds_flank_ends_at_the_virtual_base_circle():
    base = np.arctan(np.tan(GEAR) * (np.cos(PRESSURE) - 1.0)) + GEAR
    assert np.isfinite(tredgold_azimuth(base + 1e-9, GEAR, PRESSURE))
    with pytest.raises(ValueError, match="base circle"):
        tredgold_azimuth(base - 1e-6, GEAR, PRESSURE)


@pytest.mark.parametrize(
    ("teeth", "mate", "exact", "printed"), [(20, 16, 1.319639, 0.378330), (16, 20, 1.077398, 0.545049)]
)
def test_the_thesiss_recipe_turns_the_involute_by_what_it_misses_of_the_pitch_azimuth(teeth, mate, exact, printed):
    cone = np.arctan2(teeth, mate)
    involute = spherical_flank("involute", cone, PRESSURE)
    polar = np.linspace(involute.least_polar, cone + 0.06, 9)
    apart = np.degrees(thesis_azimuth(polar, cone, PRESSURE) - involute.azimuth_at(polar))
    np.testing.assert_allclose(apart, exact - printed, atol=1e-6)


def test_an_octoid_is_as_far_from_the_involute_as_theory_has_it():
    """Per mm of module: 0.02 to 0.3 µm half-way up, 0.4 to 2 µm at the ends; fuller at the root, thinner at the tip."""
    involute, octoid = (spherical_flank(form, GEAR, PRESSURE) for form in ("involute", "octoid"))
    polar = np.radians([48.89, 50.11, 51.340191745909905, 53.13, 54.91])
    amounts = MICROMETRES * normal_deviations(involute, polar, octoid.azimuth_at(polar))[0]
    assert 0.4 < amounts[0] < 2.0
    assert 0.02 < amounts[1] < 0.3
    assert abs(amounts[2]) < 1e-9
    assert -0.3 < amounts[3] < -0.02
    assert -2.0 < amounts[4] < -0.4


@pytest.mark.parametrize("form", ["involute", "octoid"])
def test_a_deviation_is_the_distance_from_the_flank(form):
    """The nearest point of the exact flank is looked for on the sphere, without normals."""
    exact = spherical_flank(form, GEAR, PRESSURE)
    polar = np.radians([49.5, 52.0, 54.5])
    turned = exact.azimuth_at(polar) + 1e-5
    amounts, directions = normal_deviations(exact, polar, turned)
    assert np.all(amounts < 0.0), "a flank that is turned into the tooth has less metal"
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1.0, rtol=1e-14)
    curve = exact.rolled(-0.5, 0.5)
    for amount, delta, phi in zip(amounts, polar, turned, strict=True):
        point = np.array([np.sin(delta) * np.cos(phi), np.sin(delta) * np.sin(phi), np.cos(delta)])
        start = float(exact.parameter_at(delta))
        squared = minimize(lambda u, point=point: 1e10 * np.sum((curve.point(u[0]) - point) ** 2), [start], tol=1e-12)
        assert 1e-5 * np.sqrt(squared.fun) == pytest.approx(-amount, rel=1e-4)

"""Motion laws: rest to rest, derivatives that are derivatives, and the peaks that tables print."""

from itertools import pairwise

import mpmath
import numpy as np
import pytest

from gearwright.elements.cams.laws import FIXED_LAWS
from gearwright.elements.cams.spline_law import SplineLaw, even_values, fitted_values

SPLINES = {
    "spline, 1 value": SplineLaw(values=(0.7,)),
    "spline, 8 values": SplineLaw(values=(0.0, 0.1, 0.1, 0.4, 0.6, 0.9, 0.95, 1.0)),
}
LAWS = {**FIXED_LAWS, **SPLINES}
every_law = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)

PEAKS = {
    "cycloidal": (2.0, 6.2832, 39.478),
    "harmonic": (1.5708, 4.9348, 15.503),
    "3-4-5": (1.875, 5.7735, 60.0),
    "4-5-6-7": (2.1875, 7.5132, 52.5),
    "modified-sine": (1.7596, 5.5280, 69.47),
}
"""Peak velocity, acceleration and jerk: Norton, Cam Design and Manufacturing Handbook, table 3-2, and the harmonic
law's π/2, π²/2, π³/2."""


@pytest.mark.parametrize("name", PEAKS)
def test_peaks_are_those_of_the_tables(name):
    found = np.abs(FIXED_LAWS[name].derivatives(np.linspace(0.0, 1.0, 100_001))).max(axis=1)
    np.testing.assert_allclose(found[1:], PEAKS[name], rtol=2e-4)


@every_law
def test_it_goes_from_rest_to_rest(law):
    start, end = law.derivatives(np.array([0.0, 1.0])).T
    np.testing.assert_allclose([start[0], end[0]], [0.0, 1.0], atol=2e-16)
    np.testing.assert_allclose([start[1], end[1]], 0.0, atol=1e-14)
    assert law.starts_smoothly == bool(np.allclose([start[2], end[2]], 0.0, atol=1e-12))


@every_law
def test_it_never_turns_back(law):
    assert np.diff(law.derivatives(np.linspace(0.0, 1.0, 2001))[0]).min() >= 0.0


@every_law
def test_each_derivative_is_that_of_the_one_before(law):
    """By differences of the fourth order between the places where pieces meet."""
    cuts, h = [0.0, *law.breaks, 1.0], 1e-4
    for low, high in pairwise(cuts):
        x = np.linspace(low, high, 9)[1:-1]
        near, far = (law.derivatives(x + k * h) - law.derivatives(x - k * h) for k in (1, 2))
        found = (8.0 * near - far) / (12.0 * h)
        np.testing.assert_allclose(law.derivatives(x)[1:], found[:3], rtol=1e-8, atol=1e-9)


@every_law
def test_pieces_meet_with_the_same_acceleration(law):
    for place in law.breaks:
        before, after = law.derivatives(np.array([place - 1e-12, place + 1e-12])).T
        np.testing.assert_allclose(before[:3], after[:3], atol=2e-9)


@pytest.mark.parametrize("x", [0.05, 0.125, 0.4, 0.875, 0.99])
def test_the_modified_sine_is_its_acceleration_integrated_twice(x):
    def acceleration(t):
        middle = mpmath.mpf(1) / 8 <= t <= mpmath.mpf(7) / 8
        return mpmath.sin(4 * mpmath.pi * t / 3 + mpmath.pi / 3) if middle else mpmath.sin(4 * mpmath.pi * t)

    def integral(upper):
        cuts = [0, *(c for c in (0.125, 0.875) if c < upper), upper]
        return mpmath.quad(lambda t: (upper - t) * acceleration(t), cuts)

    wanted = integral(mpmath.mpf(x)) / integral(mpmath.mpf(1))
    assert float(FIXED_LAWS["modified-sine"].derivatives(x)[0]) == pytest.approx(float(wanted), abs=1e-14)


def test_values_on_a_straight_line_give_a_straight_line_in_the_middle():
    law = SplineLaw(values=even_values(12))
    middle = law.derivatives(np.linspace(0.4, 0.6, 7))
    np.testing.assert_allclose(middle[2], 0.0, atol=1e-12)


def test_a_quintic_law_is_a_spline():
    """The 3-4-5 polynomial has the same ends, so the nearest spline is the law itself."""
    x = np.linspace(0.0, 1.0, 101)
    law = FIXED_LAWS["3-4-5"]
    found = SplineLaw(values=fitted_values(law.derivatives(x), x, 6))
    np.testing.assert_allclose(found.derivatives(x), law.derivatives(x), atol=1e-8)

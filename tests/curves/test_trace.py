"""Tooth traces: slopes, radial integrals and the sign of the hand."""

import inspect
from dataclasses import dataclass

import mpmath as mp
import numpy as np
import pytest

from gearwright.curves import trace as module
from gearwright.curves.trace import LogarithmicTrace, StraightTrace, Trace

EXAMPLES = {
    StraightTrace: [StraightTrace()],
    LogarithmicTrace: [
        LogarithmicTrace(rate=0.9, mean_distance=70.0),
        LogarithmicTrace(rate=-1.4, mean_distance=50.0),
        LogarithmicTrace(rate=0.0, mean_distance=50.0),
    ],
}
TRACES = [t for ts in EXAMPLES.values() for t in ts]
DISTANCES = np.array([41.0, 55.0, 70.0, 83.0])


def test_every_trace_has_an_example():
    found = {
        c for _, c in inspect.getmembers(module, inspect.isclass) if issubclass(c, Trace) and not inspect.isabstract(c)
    }
    assert found == set(EXAMPLES)


@pytest.mark.parametrize("trace", TRACES, ids=repr)
class TestEveryTrace:
    def test_the_slope_is_the_difference_of_turns(self, trace):
        h = 1e-2
        near = trace.turn(DISTANCES + h) - trace.turn(DISTANCES - h)
        far = trace.turn(DISTANCES + 2 * h) - trace.turn(DISTANCES - 2 * h)
        np.testing.assert_allclose(trace.slope(DISTANCES), (8.0 * near - far) / (12.0 * h), atol=1e-12)

    def test_turns_take_any_shape(self, trace):
        for function in (trace.turn, trace.slope):
            assert function(DISTANCES.reshape(2, 2)).shape == (2, 2)
            assert np.shape(function(50.0)) == ()

    def test_radial_integrals_are_those_of_fine_steps(self, trace):
        edges = np.linspace(41.0, 83.0, 2001)
        x, w = np.polynomial.legendre.leggauss(3)
        r = ((edges[:-1] + edges[1:]) / 2.0)[:, None] + np.diff(edges)[:, None] / 2.0 * x
        weights = np.diff(edges)[:, None] / 2.0 * w
        for power in (2, 3, 4):
            for harmonic in (0, 1, 2):
                angle = harmonic * trace.turn(r)
                exact = complex(np.sum(weights * r**power * np.cos(angle)), np.sum(weights * r**power * np.sin(angle)))
                value = trace.radial_integral(power, harmonic, 41.0, 83.0)
                assert abs(value - exact) < 1e-13 * 83.0 ** (power + 1)
                assert abs(trace.radial_integral(power, harmonic, 83.0, 41.0) + exact) < 1e-13 * 83.0 ** (power + 1)


@pytest.mark.parametrize("rate", [0.0, 0.9, -1.4])
@pytest.mark.parametrize("width", [1e-9, 1e-3, 1.0, 40.0])
def test_a_thin_shell_keeps_every_digit(rate, width):
    trace = LogarithmicTrace(rate=rate, mean_distance=50.0) if rate else StraightTrace()
    start, stop = 50.0, 50.0 + width
    for power, harmonic in ((2, 0), (3, 1), (4, 2)):
        with mp.workdps(50):
            a, b, k = mp.mpf(start), mp.mpf(stop), mp.mpf(rate)
            phase = mp.exp(-1j * harmonic * k * mp.log(50))
            exponent = power + 1 + 1j * harmonic * k
            exact = complex(phase * (b**exponent - a**exponent) / exponent)
        value = trace.radial_integral(power, harmonic, start, stop)
        assert abs(value - exact) < 2e-14 * abs(exact)


def test_a_sweep_may_start_at_the_apex():
    trace = LogarithmicTrace(rate=0.9, mean_distance=50.0)
    assert StraightTrace().radial_integral(2, 1, 0.0, 3.0) == pytest.approx(9.0)
    near = trace.radial_integral(3, 2, 1e-5, 60.0)
    assert abs(trace.radial_integral(3, 2, 0.0, 60.0) - near) < 1e-12 * abs(near)


@dataclass(frozen=True, kw_only=True)
class Numerical(Trace):
    """A logarithmic trace that does not know its closed form."""

    exact: LogarithmicTrace

    def turn(self, distance):
        return self.exact.turn(distance)

    def slope(self, distance):
        return self.exact.slope(distance)


def test_a_trace_without_a_closed_form_integrates_by_quadrature():
    exact = LogarithmicTrace(rate=2.6, mean_distance=50.0)
    for power, harmonic in ((2, 0), (3, 1), (4, 2)):
        closed = exact.radial_integral(power, harmonic, 12.0, 60.0)
        assert abs(Numerical(exact=exact).radial_integral(power, harmonic, 12.0, 60.0) - closed) < 1e-13 * abs(closed)


def test_the_spiral_angle_is_the_same_all_along():
    pitch_angle, spiral_angle = np.radians(40.0), np.radians(35.0)
    trace = LogarithmicTrace(rate=np.tan(spiral_angle) / np.sin(pitch_angle), mean_distance=50.0)
    assert trace.turn(50.0) == 0.0
    for r in (30.0, 50.0, 80.0):
        h = 1e-5
        turned = trace.turn(r + h) - trace.turn(r - h)
        assert np.arctan(turned * r * np.sin(pitch_angle) / (2.0 * h)) == pytest.approx(spiral_angle, rel=1e-8)


@pytest.mark.parametrize(("rate", "hand"), [(0.8, 1.0), (-0.8, -1.0)])
def test_a_positive_turn_is_a_right_hand_screw(rate, hand):
    trace = LogarithmicTrace(rate=rate, mean_distance=50.0)

    def tooth(r):
        w, polar = float(trace.turn(r)), 0.6
        return r * np.array([np.sin(polar) * np.cos(w), np.sin(polar) * np.sin(w), np.cos(polar)])

    h = 0.5
    p = [tooth(50.0 + k * h) for k in (-2, -1, 0, 1, 2)]
    first, second = (p[3] - p[1]) / (2 * h), (p[3] - 2 * p[2] + p[1]) / h**2
    third = (p[4] - 2 * p[3] + 2 * p[1] - p[0]) / (2 * h**3)
    assert np.sign(np.dot(np.cross(first, second), third)) == hand  # torsion

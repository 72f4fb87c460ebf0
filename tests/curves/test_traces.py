"""Laws of all tooth traces: slopes, spiral angles, radial integrals, hands and reach."""

import inspect
import pkgutil
from dataclasses import dataclass, replace
from importlib import import_module

import mpmath as mp
import numpy as np
import pytest

import gearwright.curves.traces
from gearwright.curves.traces.circular import CircularTrace
from gearwright.curves.traces.epicycloid import EpicycloidTrace
from gearwright.curves.traces.involute import InvoluteTrace
from gearwright.curves.traces.logarithmic import LogarithmicTrace
from gearwright.curves.traces.skew import SkewTrace
from gearwright.curves.traces.straight import StraightTrace
from gearwright.curves.traces.trace import SpiralTrace, Trace

MEAN = {"ratio": 1.3, "mean_distance": 70.0, "mean_spiral_angle": np.radians(35.0)}
LEFT = {"ratio": -2.1, "mean_distance": 50.0, "mean_spiral_angle": np.radians(20.0)}
EXAMPLES = {
    StraightTrace: [StraightTrace()],
    SkewTrace: [SkewTrace(**{**MEAN, "mean_spiral_angle": 0.3}), SkewTrace(**LEFT)],
    LogarithmicTrace: [
        LogarithmicTrace(**MEAN),
        LogarithmicTrace(**LEFT),
        LogarithmicTrace(ratio=1.0, mean_distance=50.0, mean_spiral_angle=0.0),
    ],
    CircularTrace: [
        CircularTrace(**MEAN, cutter_radius=90.0),
        CircularTrace(**MEAN, cutter_radius=40.0),
        CircularTrace(**{**LEFT, "mean_distance": 60.0, "mean_spiral_angle": 0.0}, cutter_radius=45.0),
    ],
    InvoluteTrace: [
        InvoluteTrace(ratio=1.3, mean_distance=50.0, mean_spiral_angle=0.7),
        InvoluteTrace(ratio=-1.0, mean_distance=50.0, mean_spiral_angle=1.1),
    ],
    EpicycloidTrace: [
        EpicycloidTrace(**MEAN, cutter_radius=90.0, blade_groups=5, crown_teeth=33.4),
        EpicycloidTrace(**LEFT, cutter_radius=60.0, blade_groups=3, crown_teeth=50.0),
        EpicycloidTrace(
            **{**LEFT, "mean_distance": 60.0, "mean_spiral_angle": 0.0},
            cutter_radius=70.0,
            blade_groups=17,
            crown_teeth=60.0,
        ),
    ],
}
TRACES = [t for ts in EXAMPLES.values() for t in ts]
SPIRALS = [t for t in TRACES if isinstance(t, SpiralTrace)]
DISTANCES = np.array([41.0, 55.0, 70.0, 83.0])

every_trace = pytest.mark.parametrize("trace", TRACES, ids=repr)
every_spiral = pytest.mark.parametrize("trace", SPIRALS, ids=repr)


def test_every_trace_has_an_example():
    names = [name for _, name, _ in pkgutil.iter_modules(gearwright.curves.traces.__path__)]
    modules = [import_module(f"gearwright.curves.traces.{name}") for name in names]
    classes = {c for module in modules for _, c in inspect.getmembers(module, inspect.isclass)}
    assert {c for c in classes if issubclass(c, Trace) and not inspect.isabstract(c)} == set(EXAMPLES)


def _difference(function, r, h=1e-2):
    """Derivative by central differences of the sixth order."""
    weights = {1: 45.0, 2: -9.0, 3: 1.0}
    return sum(c * (function(r + k * h) - function(r - k * h)) for k, c in weights.items()) / (60.0 * h)


@every_trace
class TestEveryTrace:
    def test_the_slope_is_the_difference_of_turns(self, trace):
        np.testing.assert_allclose(trace.slope(DISTANCES), _difference(trace.turn, DISTANCES), atol=1e-12)

    def test_the_spiral_angle_is_that_between_trace_and_radius(self, trace):
        """r dθ/dr = tan β."""
        steepness = DISTANCES * _difference(trace.crown_angle, DISTANCES)
        np.testing.assert_allclose(np.tan(trace.spiral_angle(DISTANCES)), steepness, rtol=0.0, atol=1e-11)

    def test_turns_take_any_shape(self, trace):
        for function in (trace.turn, trace.slope, trace.crown_angle, trace.spiral_angle):
            assert function(DISTANCES.reshape(2, 2)).shape == (2, 2)
            assert np.shape(function(50.0)) == ()

    def test_it_reaches_as_far_as_it_says(self, trace):
        least, greatest = trace.reach
        assert least < 41.0
        assert greatest > 83.0
        ends = np.array([least, min(greatest, 1e6)])
        if least > 0.0:
            assert np.all(np.isfinite(trace.turn(ends)))
            with pytest.raises(ValueError, match="beyond its reach"):
                trace.turn(least * (1.0 - 1e-9))
        if np.isfinite(greatest):
            with pytest.raises(ValueError, match="beyond its reach"):
                trace.turn(greatest * (1.0 + 1e-9))

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


@every_spiral
class TestEverySpiral:
    def test_the_spiral_angle_at_the_mean_cone_distance_is_the_one_asked_for(self, trace):
        assert trace.turn(trace.mean_distance) == 0.0
        assert abs(trace.spiral_angle(trace.mean_distance) - trace.mean_spiral_angle) <= 3e-16

    def test_the_other_hand_turns_the_other_way(self, trace):
        other = replace(trace, ratio=-trace.ratio)
        np.testing.assert_array_equal(other.turn(DISTANCES), -trace.turn(DISTANCES))
        np.testing.assert_array_equal(other.slope(DISTANCES), -trace.slope(DISTANCES))
        np.testing.assert_array_equal(other.crown_angle(DISTANCES), trace.crown_angle(DISTANCES))

    def test_positive_ratios_turn_outward_with_the_spiral_angle(self, trace):
        """Right hand: the outer half of the tooth is turned counter-clockwise about +z."""
        if trace.mean_spiral_angle > 0.0:
            outer = trace.turn(1.02 * trace.mean_distance)
            assert np.sign(outer) == np.sign(trace.ratio)
            assert outer == pytest.approx(
                0.02 * trace.ratio * np.tan(trace.mean_spiral_angle), rel=0.1, abs=0.1 * abs(outer)
            )

    def test_all_lengths_scale_together(self, trace):
        lengths = {"mean_distance": 25.4 * trace.mean_distance}
        if hasattr(trace, "cutter_radius"):
            lengths["cutter_radius"] = 25.4 * trace.cutter_radius
        larger = replace(trace, **lengths)
        np.testing.assert_allclose(larger.turn(25.4 * DISTANCES), trace.turn(DISTANCES), rtol=1e-14, atol=1e-16)

    def test_nothing_cancels_near_the_mean_cone_distance(self, trace):
        """θ = ∫ tan β dr/r to every digit, in fifty digits, for steps down to 1e-12; a zerol trace is flat there."""
        if trace.mean_spiral_angle == 0.0:
            return
        for step in (1e-12, 1e-9, 1e-6, 1e-3, -1e-4, -1e-10):
            r = trace.mean_distance * (1.0 + step)
            assert trace.crown_angle(r) == pytest.approx(float(_exact_angle(trace, r)), rel=2e-14)


def _exact_angle(trace, r):
    """θ(r) in fifty digits, by quadrature of tan β/r with sin β, or tan β, as the textbooks have it."""
    with mp.workdps(50):
        mean, angle, end = mp.mpf(trace.mean_distance), mp.mpf(trace.mean_spiral_angle), mp.mpf(float(r))
        radius = mp.mpf(getattr(trace, "cutter_radius", 1.0))
        if isinstance(trace, EpicycloidTrace):
            return _exact_epicycloid(trace, mean, angle, radius, end)
        square = mean**2 + radius**2 - 2 * mean * radius * mp.sin(angle)
        sines = {
            SkewTrace: lambda q: mean * mp.sin(angle) / q,
            LogarithmicTrace: lambda q: mp.sin(angle),
            CircularTrace: lambda q: (q**2 + radius**2 - square) / (2 * q * radius),
            InvoluteTrace: lambda q: mp.sqrt(1 - (mean * mp.cos(angle) / q) ** 2),
        }
        sine = sines[type(trace)]
        return mp.quad(lambda q: mp.tan(mp.asin(sine(q))) / q, [mean, end])


def _exact_epicycloid(trace, mean, angle, radius, end):
    """θ(r) of E(t) = S e^{it} + r_c e^{i((1 + z_p/z₀)t + c)}, t solved for from |E| = r."""
    rolling = mp.mpf(trace.crown_teeth) / trace.blade_groups
    module = 2 * mean * mp.cos(angle) / mp.mpf(trace.crown_teeth)
    lead = mp.asin(trace.blade_groups * module / (2 * radius))
    centre = mp.sqrt(mean**2 + radius**2 - 2 * mean * radius * mp.sin(angle - lead))
    phase = -mp.acos((mean**2 - centre**2 - radius**2) / (2 * centre * radius))

    def point(t):
        return centre * mp.expj(t) + radius * mp.expj((1 + rolling) * t + phase)

    guess = (end - mean) / (radius * mp.cos(angle - lead)) / rolling
    t = mp.findroot(lambda s: abs(point(s)) - end, (guess, guess * mp.mpf("1.01")))
    return mp.arg(point(t) / point(mp.mpf(0)))


@pytest.mark.parametrize("rate", [0.0, 0.9, -1.4])
@pytest.mark.parametrize("width", [1e-9, 1e-3, 1.0, 40.0])
def test_a_thin_shell_keeps_every_digit(rate, width):
    trace = _logarithmic(rate) if rate else StraightTrace()
    start, stop = 50.0, 50.0 + width
    for power, harmonic in ((2, 0), (3, 1), (4, 2)):
        with mp.workdps(50):
            a, b, k = mp.mpf(start), mp.mpf(stop), mp.mpf(rate)
            phase = mp.exp(-1j * harmonic * k * mp.log(50))
            exponent = power + 1 + 1j * harmonic * k
            exact = complex(phase * (b**exponent - a**exponent) / exponent)
        value = trace.radial_integral(power, harmonic, start, stop)
        assert abs(value - exact) < 2e-14 * abs(exact)


def _logarithmic(rate):
    return LogarithmicTrace(ratio=np.sign(rate), mean_distance=50.0, mean_spiral_angle=float(np.arctan(abs(rate))))


def test_a_sweep_may_start_at_the_apex():
    trace = _logarithmic(0.9)
    assert StraightTrace().radial_integral(2, 1, 0.0, 3.0) == pytest.approx(9.0)
    near = trace.radial_integral(3, 2, 1e-5, 60.0)
    assert abs(trace.radial_integral(3, 2, 0.0, 60.0) - near) < 1e-12 * abs(near)


@dataclass(frozen=True, kw_only=True)
class Numerical(SpiralTrace):
    """A logarithmic trace that does not know its closed form."""

    reach = (0.0, np.inf)

    def crown_angle(self, distance):
        return np.tan(self.mean_spiral_angle) * np.log(distance / self.mean_distance)

    def spiral_angle(self, distance):
        return np.full(np.shape(distance), self.mean_spiral_angle)


@pytest.mark.parametrize("rate", [2.6, 30.0])
def test_a_trace_without_a_closed_form_integrates_by_quadrature(rate):
    exact = _logarithmic(rate)
    blind = Numerical(ratio=1.0, mean_distance=50.0, mean_spiral_angle=exact.mean_spiral_angle)
    for power, harmonic in ((2, 0), (3, 1), (4, 2)):
        closed = exact.radial_integral(power, harmonic, 12.0, 60.0)
        scale = abs(exact.radial_integral(power, 0, 12.0, 60.0))
        assert abs(blind.radial_integral(power, harmonic, 12.0, 60.0) - closed) < 1e-13 * scale


def test_integrals_from_the_very_end_of_a_reach_converge():
    """β is 90° there; by the substitution r² = p² + t² along the skew line everything is smooth."""
    trace = SkewTrace(ratio=1.0, mean_distance=50.0, mean_spiral_angle=0.6)
    least = trace.reach[0]
    mean = 50.0 * np.cos(0.6)
    x, w = np.polynomial.legendre.leggauss(60)
    t = (x + 1.0) / 2.0 * np.sqrt(60.0**2 - least**2)
    r = np.hypot(least, t)
    turned = np.arctan2(t, least) - np.arctan2(mean, least)
    exact = np.sum(w / 2.0 * np.sqrt(60.0**2 - least**2) * t / r * r**3 * np.exp(1j * turned))
    assert abs(trace.radial_integral(3, 1, least, 60.0) - exact) < 1e-10 * abs(exact)


@pytest.mark.parametrize(("rate", "hand"), [(0.8, 1.0), (-0.8, -1.0)])
def test_a_positive_turn_is_a_right_hand_screw(rate, hand):
    trace = _logarithmic(rate)

    def tooth(r):
        w, polar = float(trace.turn(r)), 0.6
        return r * np.array([np.sin(polar) * np.cos(w), np.sin(polar) * np.sin(w), np.cos(polar)])

    h = 0.5
    p = [tooth(50.0 + k * h) for k in (-2, -1, 0, 1, 2)]
    first, second = (p[3] - p[1]) / (2 * h), (p[3] - 2 * p[2] + p[1]) / h**2
    third = (p[4] - 2 * p[3] + 2 * p[1] - p[0]) / (2 * h**3)
    assert np.sign(np.dot(np.cross(first, second), third)) == hand  # torsion


@pytest.mark.parametrize(
    ("trace", "wrong", "message"),
    [
        (SkewTrace, {"mean_distance": 0.0}, "greater than 0"),
        (SkewTrace, {"mean_spiral_angle": -0.1}, "the hand is"),
        (LogarithmicTrace, {"mean_spiral_angle": np.pi / 2}, "less than 90°"),
        (InvoluteTrace, {"mean_spiral_angle": 0.0}, "begins there"),
        (CircularTrace, {"cutter_radius": 0.0}, "greater than 0"),
        (EpicycloidTrace, {"cutter_radius": 3.0, "blade_groups": 5, "crown_teeth": 33.4}, "more than 8.58"),
    ],
)
def test_what_is_no_trace_is_refused(trace, wrong, message):
    with pytest.raises(ValueError, match=message):
        _ = trace(**{**MEAN, **wrong}).reach

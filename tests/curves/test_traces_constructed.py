"""Tooth traces are the plane curves they are named after, drawn on the crown gear; and those of a published example."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.curves.traces.circular import CircularTrace
from gearwright.curves.traces.epicycloid import EpicycloidTrace
from gearwright.curves.traces.involute import InvoluteTrace
from gearwright.curves.traces.logarithmic import LogarithmicTrace
from gearwright.curves.traces.skew import SkewTrace

MEAN, WIDTH = 81.273, 25.4
SHAPE = {"ratio": 1.0, "mean_distance": MEAN, "mean_spiral_angle": np.radians(35.0)}
CIRCULAR = CircularTrace(**SHAPE, cutter_radius=114.3)
EPICYCLOID = EpicycloidTrace(**SHAPE, cutter_radius=114.3, blade_groups=13, crown_teeth=42.7)
ENDS = MEAN + np.array([-0.5, 0.5]) * WIDTH
FACE = np.linspace(*ENDS, 41)


def drawn(trace, r):
    """Points (...) of the crown plane as complex numbers, the mean point on the real axis."""
    return r * np.exp(1j * trace.crown_angle(r))


class TestPublished:
    """A face of 25.4 at a mean cone distance of 81.273, spiral angle 35°, cutter radius 114.3."""

    def test_spiral_angles_at_inner_and_outer_end(self):
        assert np.degrees(CIRCULAR.spiral_angle(ENDS)) == pytest.approx([33.94556, 36.84579], abs=5e-6)
        assert np.degrees(InvoluteTrace(**SHAPE).spiral_angle(ENDS)) == pytest.approx([13.86517, 44.89125], abs=1e-5)

    def test_crown_angles_of_the_arc(self):
        assert CIRCULAR.crown_angle(ENDS) == pytest.approx([-0.116250, 0.104910], abs=5e-7)


@pytest.mark.parametrize("radius", [40.0, 60.0, 114.3, 1e4])
@pytest.mark.parametrize("angle", [0.0, 20.0, 35.0, 60.0])
def test_a_circular_trace_lies_on_a_circle_of_the_cutter_s_radius(radius, angle):
    """Its centre is to the left of one who goes outward, so that the spiral angle of a right hand grows."""
    beta = np.radians(angle)
    trace = CircularTrace(ratio=1.0, mean_distance=MEAN, mean_spiral_angle=beta, cutter_radius=radius)
    centre = MEAN + radius * 1j * np.exp(1j * beta)
    r = np.linspace(max(trace.reach[0], ENDS[0]), min(trace.reach[1], ENDS[1]), 41)
    np.testing.assert_allclose(np.abs(drawn(trace, r) - centre), radius, rtol=1e-13)


@pytest.mark.parametrize("radius", [40.0, 114.3])
def test_a_circular_trace_reaches_the_nearest_and_farthest_points_of_its_circle(radius):
    trace = CircularTrace(**{**SHAPE, "mean_spiral_angle": 0.2}, cutter_radius=radius)
    circle = MEAN + radius * 1j * np.exp(0.2j) + radius * np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 400_001))
    assert trace.reach == pytest.approx([np.abs(circle).min(), np.abs(circle).max()], rel=1e-8)


def test_a_zerol_trace_touches_the_radius():
    trace = CircularTrace(**{**SHAPE, "mean_spiral_angle": 0.0}, cutter_radius=60.0)
    angles = np.degrees(trace.spiral_angle(np.array([ENDS[0], MEAN, ENDS[1]])))
    assert angles[0] < -5.0
    assert angles[1] == 0.0
    assert angles[2] > 5.0
    offsets = trace.crown_angle(MEAN * (1.0 + np.array([-1e-3, 1e-3])))
    assert offsets == pytest.approx(0.5e-6 * MEAN / 60.0, rel=3e-3)  # a circle rises by half the square over r_c


def test_an_endless_cutter_cuts_skew_teeth():
    for radius, error in ((1e5, 1e-3), (1e8, 1e-6), (1e12, 1e-10)):
        wide = replace(CIRCULAR, cutter_radius=radius)
        assert np.abs(wide.crown_angle(FACE) - SkewTrace(**SHAPE).crown_angle(FACE)).max() < error


def test_skew_teeth_are_straight_and_tangent_to_a_circle():
    points = drawn(SkewTrace(**SHAPE), FACE)
    heading = np.exp(1j * np.radians(35.0))
    np.testing.assert_allclose(((points - MEAN) / heading).imag, 0.0, atol=1e-13 * MEAN)
    assert np.all(np.diff((points / heading).real) > 0.0)
    distance = np.abs((points[1:] * np.conj(points[:-1])).imag / np.abs(np.diff(points)))
    np.testing.assert_allclose(distance, MEAN * np.sin(np.radians(35.0)), rtol=1e-12)


def test_an_involute_s_normals_touch_its_base_circle():
    """And the length of the normal is the arc unwound."""
    trace = InvoluteTrace(**SHAPE)
    base, h = MEAN * np.cos(np.radians(35.0)), 1e-3
    points = drawn(trace, FACE)
    tangent = drawn(trace, FACE + h) - drawn(trace, FACE - h)
    normal = 1j * tangent / np.abs(tangent)
    np.testing.assert_allclose(np.abs((points * np.conj(normal)).imag), base, rtol=1e-8)
    touching = points - (points * np.conj(normal)).real * normal
    length = np.abs(points - touching)
    unwound = base * np.diff(np.unwrap(np.angle(touching)))
    np.testing.assert_allclose(np.diff(length), unwound, rtol=1e-6)


def test_an_epicycloid_is_drawn_by_a_blade_on_a_rolling_circle():
    """A circle of radius S z₀/(z_p + z₀) rolls outside one of S z_p/(z_p + z₀); the blade is r_c from its centre."""
    beta, share = np.radians(35.0), 13 / 42.7
    lead = np.arcsin(share * MEAN * np.cos(beta) / 114.3)
    centre = MEAN + 114.3 * 1j * np.exp(1j * (beta - lead))
    turned = np.linspace(-0.5, 0.5, 20_001)  # of the rolling circle's centre about the apex
    fixed, rolling = np.abs(centre) / (1.0 + share), np.abs(centre) * share / (1.0 + share)
    assert fixed + rolling == pytest.approx(np.abs(centre))
    spun = turned + turned * fixed / rolling  # the arcs rolled off are alike
    points = centre * np.exp(1j * turned) + (MEAN - centre) * np.exp(1j * spun)
    r = np.abs(points)
    inside = (r > ENDS[0]) & (r < ENDS[1]) & (np.abs(spun) < 0.5)
    assert np.count_nonzero(inside) > 50
    np.testing.assert_allclose(EPICYCLOID.crown_angle(r[inside]), np.angle(points[inside]), atol=1e-13)
    assert EPICYCLOID.reach == pytest.approx([abs(np.abs(centre) - 114.3), np.abs(centre) + 114.3], rel=1e-13)


def test_one_blade_group_on_endless_teeth_cuts_the_circle():
    """The lead angle falls with z₀/z_p, and with it the difference."""
    for teeth, error in ((1e3, 1e-2), (1e6, 1e-5), (1e9, 1e-8)):
        slow = replace(EPICYCLOID, blade_groups=1, crown_teeth=teeth)
        assert np.abs(slow.crown_angle(FACE) - CIRCULAR.crown_angle(FACE)).max() < error


def test_spiral_angles_differ_along_the_face_as_each_trace_has_it():
    """Constant on the logarithmic spiral, falling on a skew line, growing on the others."""
    along = {
        kind: np.degrees(trace.spiral_angle(FACE))
        for kind, trace in (
            ("skew", SkewTrace(**SHAPE)),
            ("logarithmic", LogarithmicTrace(**SHAPE)),
            ("circular", CIRCULAR),
            ("epicycloid", EPICYCLOID),
            ("involute", InvoluteTrace(**SHAPE)),
        )
    }
    assert np.ptp(along["logarithmic"]) == 0.0
    assert np.all(np.diff(along["skew"]) < 0.0)
    for kind in ("circular", "epicycloid", "involute"):
        assert np.all(np.diff(along[kind]) > 0.0)

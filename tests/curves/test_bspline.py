import numpy as np
import pytest
from scipy.interpolate import BSpline

from gearwright.curves.bezier import Bezier
from gearwright.curves.bspline import bspline_spans
from gearwright.curves.curve import along
from gearwright.curves.elliptic_arc import EllipticArc
from gearwright.curves.rational_bezier import RationalBezier, flat_arc

FRACTIONS = np.linspace(0.0, 1.0, 9)


def spline(degree, seed, *, clamped):
    """Knots, some of them double, control points and weights of a B-spline of three coordinates."""
    rng = np.random.default_rng(seed)
    n = degree + 6
    knots = np.cumsum(rng.uniform(0.2, 1.0, n + degree + 1))
    knots[degree + 3] = knots[degree + 2]
    if clamped:
        knots[: degree + 1], knots[n:] = knots[degree], knots[n]
    return knots, rng.normal(size=(n, 3)), rng.uniform(0.4, 2.0, n)


@pytest.mark.parametrize("clamped", [True, False])
@pytest.mark.parametrize("rational", [True, False])
@pytest.mark.parametrize("degree", [2, 3, 5])
def test_the_spans_are_the_spline(degree, rational, clamped):
    knots, control, weights = spline(degree, 3 * degree, clamped=clamped)
    w = weights if rational else np.ones(len(weights))
    homogeneous = BSpline(knots, np.column_stack([control * w[:, None], w]), degree)
    spans = bspline_spans(degree, knots, control, weights if rational else None)
    breaks = np.unique(knots[degree : len(control) + 1])
    assert len(spans) == len(breaks) - 1 == 5
    points, tangents = along(spans, FRACTIONS)
    for s, t, p, dp in zip(breaks, breaks[1:], points, tangents, strict=False):
        u = s + (t - s) * FRACTIONS[1:-1]
        value, slope = homogeneous(u), homogeneous(u, 1)
        expected = value[:, :3] / value[:, 3:]
        np.testing.assert_allclose(p[1:-1], expected, atol=1e-13)
        expected_slope = (slope[:, :3] - expected * slope[:, 3:]) / value[:, 3:]
        np.testing.assert_allclose(dp[1:-1], (t - s) * expected_slope, atol=1e-12)


@pytest.mark.parametrize("weights", [None, np.full(9, 2.5)])
def test_equal_weights_are_a_polynomial(weights):
    knots, control, _ = spline(3, 8, clamped=True)
    assert all(type(span) is Bezier for span in bspline_spans(3, knots, control, weights))


def test_a_rational_parabola_is_a_quarter_circle():
    quarter = RationalBezier(control=((2.0, 0.0), (2.0, 2.0), (0.0, 2.0)), weights=(1.0, np.sqrt(0.5), 1.0))
    radii = np.linalg.norm(quarter.point(FRACTIONS), axis=1)
    np.testing.assert_allclose(radii, 2.0, rtol=1e-15)
    np.testing.assert_allclose(
        np.sum(quarter.point(FRACTIONS) * quarter.derivative(FRACTIONS), axis=1), 0.0, atol=1e-14
    )


def test_an_elliptic_arc_of_any_vectors_is_the_image_of_the_unit_circle():
    arc = EllipticArc(centre=(3.0, 1.0), a=(2.0, 0.5), b=(-1.0, 1.5), interval=(0.0, 6.0))
    inverse = np.linalg.inv(np.array([[2.0, -1.0], [0.5, 1.5]]))
    on_circle = (arc.point(arc.parameter(FRACTIONS)) - [3.0, 1.0]) @ inverse.T
    np.testing.assert_allclose(np.arctan2(*on_circle.T[::-1]) % (2.0 * np.pi), 6.0 * FRACTIONS, atol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(on_circle, axis=1), 1.0, atol=1e-15)


@pytest.mark.parametrize("angle", [0.039, -0.02, 1e-6, 1.2])
def test_a_flat_arc_is_the_circle_s(angle):
    start, end = np.array([1.0, 2.0]), np.array([4.0, -1.0])
    arc = flat_arc(start, end, angle)
    np.testing.assert_array_equal([arc.start, arc.end], [start, end])
    chord = end - start
    radius = np.linalg.norm(chord) / (2.0 * abs(np.sin(angle / 2.0)))
    left = np.array([-chord[1], chord[0]]) / np.linalg.norm(chord)
    centre = (start + end) / 2.0 + np.sign(angle) * left * radius * np.cos(angle / 2.0)
    distances = np.linalg.norm(arc.point(np.linspace(0.0, 1.0, 11)) - centre, axis=1)
    np.testing.assert_allclose(distances, radius, rtol=1e-14)

"""Cubic splines through points: interpolation, smoothness, reproduction of cubics, order of convergence."""

import numpy as np
import pytest

from gearwright.curves.curve import along
from gearwright.curves.spline import cubic_spline, spline_spans

POINTS = np.array([[0.0, 0.0], [2.0, 0.3], [3.1, 2.0], [1.2, 3.5], [-0.8, 1.9], [0.0, 0.0]])


@pytest.mark.parametrize("closed", [True, False])
def test_it_runs_through_the_points_to_the_last_digit(closed):
    ends, _ = along(spline_spans(POINTS, closed=closed), np.array([0.0, 1.0]))
    np.testing.assert_array_equal(ends[:, 0], POINTS[:-1])
    np.testing.assert_array_equal(ends[:, 1], POINTS[1:])


@pytest.mark.parametrize("closed", [True, False])
def test_slope_and_curvature_run_on_from_span_to_span(closed):
    knots, _ = cubic_spline(POINTS, closed=closed)
    widths = np.diff(knots)[:, None]
    h = 1e-4
    spans = spline_spans(POINTS, closed=closed)
    _, tangents = along(spans, np.array([0.0, 1.0, h, 1.0 - h]))
    start, end = tangents[:, 0] / widths, tangents[:, 1] / widths
    bend_start = (tangents[:, 2] / widths - start) / (h * widths)
    bend_end = (end - tangents[:, 3] / widths) / (h * widths)
    joints = slice(None) if closed else slice(None, -1)
    np.testing.assert_allclose(end[joints], np.roll(start, -1, axis=0)[joints], atol=1e-12)
    np.testing.assert_allclose(bend_end[joints], np.roll(bend_start, -1, axis=0)[joints], atol=1e-2)


def test_an_open_spline_through_points_of_a_straight_cubic_is_that_cubic():
    """Along a line, equal steps: the parameter is the distance, and a cubic height is reproduced."""
    x = np.linspace(0.0, 3.0, 7)
    knots, slopes = cubic_spline(np.stack([x, np.zeros(7), np.zeros(7)], axis=-1), closed=False)
    np.testing.assert_allclose(slopes, np.tile([1.0, 0.0, 0.0], (7, 1)), atol=1e-14)
    np.testing.assert_allclose(knots, x, atol=1e-15)


def test_a_closed_spline_through_points_of_a_circle_nears_it_with_the_fourth_order():
    def miss(n):
        angles = np.linspace(0.0, 2.0 * np.pi, n + 1)
        points = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        points[-1] = points[0]
        middle, _ = along(spline_spans(points, closed=True), np.array([0.5]))
        return np.max(np.abs(np.linalg.norm(middle, axis=-1) - 1.0))

    orders = np.log2([miss(16) / miss(32), miss(32) / miss(64)])
    np.testing.assert_allclose(orders, 4.0, atol=0.1)

"""Plane moments from a boundary, and integrals whose nodes are increased until they settle."""

import numpy as np
import pytest

from gearwright.moments.boundary_integral import moment_matrix_2d, plane_moments
from gearwright.moments.quadrature import converged

POWERS = [(a, b) for a in range(4) for b in range(4 - a)]


def egg(n, period=2.0 * np.pi):
    """Points, weighted tangents, angles and radii, by the trapezoidal rule.

    r = 2 + cos t + 0.3 sin 3t, or one period of r = 2 + 0.4 cos kt + 0.2 sin 2kt.
    """
    k = round(2.0 * np.pi / period)
    t = (np.arange(n) + 0.5) * period / n
    if k == 1:
        r, dr = 2.0 + np.cos(t) + 0.3 * np.sin(3 * t), -np.sin(t) + 0.9 * np.cos(3 * t)
    else:
        r = 2.0 + 0.4 * np.cos(k * t) + 0.2 * np.sin(2 * k * t)
        dr = -0.4 * k * np.sin(k * t) + 0.4 * k * np.cos(2 * k * t)
    points = r[:, None] * np.stack([np.cos(t), np.sin(t)], axis=-1)
    tangents = dr[:, None] * np.stack([np.cos(t), np.sin(t)], axis=-1)
    tangents += r[:, None] * np.stack([-np.sin(t), np.cos(t)], axis=-1)
    return points, tangents * period / n, t, r


def brute(t, r, step):
    """m[a, b] over polar rings: ∫∫ ρ^(a+b+1) cos^a sin^b dρ dt with Gauss points in ρ."""
    x, w = np.polynomial.legendre.leggauss(8)
    rho = np.outer(r, (x + 1.0) / 2.0)
    weight = np.outer(r, w / 2.0) * rho * step
    moments = np.zeros((4, 4))
    for a, b in POWERS:
        moments[a, b] = np.sum(weight * (rho * np.cos(t)[:, None]) ** a * (rho * np.sin(t)[:, None]) ** b)
    return moments


def test_moments_of_an_egg_are_those_of_brute_force():
    points, tangents, t, r = egg(200)
    np.testing.assert_allclose(plane_moments(points, tangents), brute(t, r, 2.0 * np.pi / 200), atol=1e-12)


@pytest.mark.parametrize("order", [2, 3, 4, 5])
def test_one_period_stands_for_all(order):
    points, tangents, _, _ = egg(240, 2.0 * np.pi / order)
    whole = [
        np.array([[c, -s], [s, c]]) for c, s in ((np.cos(a), np.sin(a)) for a in 2 * np.pi / order * np.arange(order))
    ]
    all_points, all_tangents = (np.concatenate([x @ m.T for m in whole]) for x in (points, tangents))
    expected = plane_moments(all_points, all_tangents)
    np.testing.assert_allclose(plane_moments(points, tangents, order=order), expected, atol=1e-12)
    polar = np.hypot(*all_points.T)
    np.testing.assert_allclose(
        expected, brute(np.arctan2(all_points[:, 1], all_points[:, 0]), polar, 2 * np.pi / order / 240), atol=1e-12
    )


def test_the_other_sense_is_negative():
    points, tangents, _, _ = egg(50)
    np.testing.assert_allclose(
        plane_moments(points[::-1], -tangents[::-1]), -plane_moments(points, tangents), atol=1e-13
    )


def test_the_matrix_takes_its_entries_by_powers():
    m = np.arange(16.0).reshape(4, 4)
    np.testing.assert_array_equal(moment_matrix_2d(m), [[0, 4, 1], [4, 8, 5], [1, 5, 2]])


class TestConverged:
    def test_it_stops_when_the_integral_has_settled(self):
        asked = []

        def integral(nodes):
            asked.append(nodes)
            return np.array([[3.0, 2.0 ** (-4.0 * nodes)]])

        value, error = converged(integral)
        assert len(asked) == 3
        assert asked == sorted(asked)
        np.testing.assert_allclose(value, [[3.0, 0.0]], atol=1e-15)
        assert 0.0 < error < 4e-15

    def test_the_change_of_one_that_does_not_settle_is_its_error(self):
        value, error = converged(lambda nodes: np.array([4.0, 1.0 / nodes]))
        assert value[1] == pytest.approx(1.0 / 224.0)
        assert error == pytest.approx((1.0 / 160.0 - 1.0 / 224.0) / 4.0)

    def test_every_entry_counts(self):
        for entry in range(3):
            moving = np.zeros(3)
            moving[entry] = 1.0
            _, error = converged(lambda nodes, m=moving: np.array([1.0, 1.0, 1.0]) + m / nodes)
            assert error > 1e-4

    def test_an_integral_of_nothing_is_nought(self):
        value, error = converged(lambda nodes: np.zeros((2, 2)))
        assert not value.any()
        assert error < 1e-15

    def test_what_is_no_number_has_no_small_error(self):
        _, error = converged(lambda nodes: np.array([np.nan, 1.0]))
        assert not error < 1.0

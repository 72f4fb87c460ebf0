"""Polygon moments against exact rational integration of triangles, and their laws."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearwright.moments.polygon import polygon_moments


def exact(loops):
    """∫ x^a y^b over triangles (0, p, q), expanded in barycentric coordinates: ∫ λ^i μ^j = i! j! / (i+j+2)! × 2A."""
    result = {(a, b): Fraction(0) for a in range(4) for b in range(4 - a)}
    for loop in loops:
        points = [(Fraction(float(x)), Fraction(float(y))) for x, y in loop]
        for p, q in zip(points, points[1:] + points[:1], strict=True):
            cross = p[0] * q[1] - p[1] * q[0]
            for a, b in result:
                # polynomial (p0 λ + q0 μ)^a (p1 λ + q1 μ)^b as coefficients of λ^i μ^j, i + j = a + b
                poly = [Fraction(1)]
                for u, v in [(p[0], q[0])] * a + [(p[1], q[1])] * b:
                    poly = [u * x + v * y for x, y in zip([*poly, 0], [0, *poly], strict=True)]
                n = a + b
                weights = [Fraction(factorial(n - j) * factorial(j), factorial(n + 2)) for j in range(n + 1)]
                result[a, b] += cross * sum(w * c for w, c in zip(weights, poly, strict=True))
    return result


SQUARE = np.array([[0.0, 0], [2, 0], [2, 3], [0, 3]])
HOLE = np.array([[0.5, 1.0], [0.7, 2.0], [1.1, 1.3]])  # clockwise
STAR = np.array([[np.cos(t) * r, np.sin(t) * r] for t, r in zip(np.linspace(0, 6, 13), [1, 0.3] * 7, strict=False)])


@pytest.mark.parametrize("loops", [[SQUARE], [SQUARE, HOLE], [STAR], [STAR + 3.0, HOLE]])
def test_agrees_with_rational_integration(loops):
    moments = polygon_moments(loops)
    expected = exact(loops)
    for (a, b), value in expected.items():
        assert moments[a, b] == pytest.approx(float(value), rel=1e-14, abs=1e-15)
    assert all(moments[a, b] == 0 for a in range(4) for b in range(4) if a + b > 3)


def test_rectangle_by_hand():
    moments = polygon_moments([SQUARE])
    assert moments[0, 0] == pytest.approx(6.0, rel=1e-15)
    assert moments[1, 0] == pytest.approx(6.0, rel=1e-15)
    assert moments[2, 1] == pytest.approx(8 / 3 * 9 / 2, rel=1e-15)
    assert moments[0, 3] == pytest.approx(2 * 81 / 4, rel=1e-15)


@pytest.mark.parametrize("offset", [1e3, 1e6, 1e8])
def test_far_from_the_origin_every_moment_keeps_its_digits(offset):
    loops = [SQUARE + offset, HOLE + offset]
    moments = polygon_moments(loops)
    for (a, b), value in exact(loops).items():
        assert abs(moments[a, b] / float(value) - 1) < 2e-15


@given(st.floats(-50, 50), st.floats(-50, 50), st.floats(0, 6.3))
def test_area_and_polar_moment_do_not_depend_on_place_and_turn(x, y, angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])

    def central(loops):
        m = polygon_moments(loops)
        return m[0, 0], m[2, 0] + m[0, 2] - (m[1, 0] ** 2 + m[0, 1] ** 2) / m[0, 0]

    moved = central([loop @ turn.T + [x, y] for loop in (SQUARE, HOLE)])
    np.testing.assert_allclose(moved, central([SQUARE, HOLE]), rtol=1e-10)


def test_a_reversed_loop_counts_negative():
    np.testing.assert_allclose(polygon_moments([STAR[::-1]]), -polygon_moments([STAR]), atol=1e-16)


def test_no_loops_have_no_moments_and_other_shapes_are_refused():
    assert not polygon_moments([]).any()
    with pytest.raises(ValueError, match=r"\(n, 2\)"):
        polygon_moments([np.zeros((4, 3))])

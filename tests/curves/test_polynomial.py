"""Polynomials of a motion's parameter."""

import numpy as np
import pytest

from gearwright.curves.polynomial import Polynomial, parabola

CUBIC = Polynomial(coefficients=(1.5, -2.0, 0.25, 0.5), centre=10.0)


def test_values_and_derivatives_are_those_of_the_written_polynomial():
    v = np.array([[9.0, 10.0, 12.0], [8.0, 11.0, 10.5]])
    x = v - 10.0
    np.testing.assert_allclose(CUBIC.value(v), 1.5 - 2.0 * x + x**2 / 4.0 + x**3 / 2.0, rtol=1e-15)
    np.testing.assert_allclose(CUBIC.derivative(v), -2.0 + x / 2.0 + 1.5 * x**2, rtol=1e-15)
    assert CUBIC.value(12.0) == pytest.approx(2.5)


def test_the_opposite_polynomial_has_opposite_values():
    np.testing.assert_array_equal((-CUBIC).value([7.0, 12.5]), -CUBIC.value([7.0, 12.5]))


def test_a_constant_is_one():
    constant = Polynomial(coefficients=(0.4,))
    np.testing.assert_array_equal(constant.value([1.0, 2.0]), [0.4, 0.4])
    np.testing.assert_array_equal(constant.derivative([1.0, 2.0]), [0.0, 0.0])
    assert constant.extremes(-5.0, 5.0) == ()


def test_extremes_lie_between_the_ends():
    product = Polynomial(coefficients=(0.0, 12.0, -9.0, 2.0), centre=3.0)  # derivative 6 (x − 1)(x − 2)
    assert product.extremes(0.0, 9.0) == pytest.approx((4.0, 5.0))
    assert product.extremes(4.5, 9.0) == pytest.approx((5.0,))
    assert product.extremes(0.0, 4.5) == pytest.approx((4.0,))
    assert product.extremes(5.5, 9.0) == ()
    assert Polynomial(coefficients=(0.0, 1.0, 0.0, 1.0)).extremes(-9.0, 9.0) == ()  # 1 + 3 x² has no real root
    assert Polynomial(coefficients=(0.0, 0.0, 1.0)).extremes(-1.0, 1.0) == (0.0,)


def test_the_parabola_of_crowning():
    crowning = parabola(0.02, 5.0, 25.0)
    np.testing.assert_allclose(crowning.value([5.0, 10.0, 15.0, 25.0]), [0.02, 0.005, 0.0, 0.02], rtol=1e-15)
    assert crowning.extremes(5.0, 25.0) == (15.0,)

"""Piecewise series of functions known by their values: values, derivatives, integrals, kinks, refusals."""

import numpy as np
import pytest

from gearwright.curves.smooth import smooth
from gearwright.errors import GeometryError

X = np.linspace(0.003, 2.997, 211)


def wave(x):
    return np.stack([np.cos(9.0 * x), np.exp(-x), x], axis=-1)


def test_values_derivatives_and_integrals_are_the_function_s():
    found = smooth(wave, [0.0, 3.0], tolerance=1e-14, name="wave")
    np.testing.assert_allclose(found.value(X), wave(X), atol=1e-13)
    rates = np.stack([-9.0 * np.sin(9.0 * X), -np.exp(-X), np.ones_like(X)], axis=-1)
    np.testing.assert_allclose(found.derivative.value(X), rates, atol=1e-10)
    sums = np.stack([np.sin(9.0 * X) / 9.0, 1.0 - np.exp(-X), X**2 / 2.0], axis=-1)
    np.testing.assert_allclose(found.integral.value(X), sums, atol=1e-14)
    assert found.kinks == ()
    assert 0.0 < found.error < 1e-14
    assert found.evaluations > 24


def test_scalars_and_shapes():
    found = smooth(wave, [0.0, 3.0], tolerance=1e-14, name="wave")
    assert found.value(1.0).shape == (3,)
    assert found.value(np.ones((2, 5))).shape == (2, 5, 3)


@pytest.mark.parametrize("kink", [0.3, 1.0 / 3.0, 1.5, 2.25, 2.9])
def test_kinks_are_found_and_no_piece_straddles_one(kink):
    found = smooth(lambda x: np.abs(x - kink)[:, None] + np.sin(x)[:, None], [0.0, 3.0], tolerance=1e-14, name="f")
    assert found.kinks == pytest.approx([kink], abs=1e-9)
    np.testing.assert_allclose(found.value(X)[:, 0], np.abs(X - kink) + np.sin(X), atol=1e-10)
    assert len(found.breaks) < 60


def test_a_break_that_is_given_needs_no_search():
    found = smooth(lambda x: np.abs(x - 1.0)[:, None], [0.0, 1.0, 3.0], tolerance=1e-14, name="f")
    assert len(found.breaks) == 3
    assert found.kinks == (1.0,)


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (lambda x: np.sign(x - 1.3)[:, None], "near 1.3: it jumps"),
        (lambda x: np.sign(x - 1.5)[:, None], "near 1.5: it jumps"),
        (lambda x: np.where(x > 2.0, np.nan, x)[:, None], "is not finite"),
        (lambda x: np.random.default_rng(0).normal(size=(len(x), 1)), "rougher than the tolerance"),
    ],
)
def test_what_is_not_smooth_is_refused_with_the_place(function, words):
    with pytest.raises(GeometryError, match=words) as caught:
        smooth(function, [0.0, 3.0], tolerance=1e-14, name="profile")
    assert "The profile cannot be used" in str(caught.value)


def test_noise_below_the_tolerance_is_accepted():
    noise = np.random.default_rng(1)
    found = smooth(
        lambda x: np.sin(x)[:, None] + 1e-8 * noise.normal(size=(len(x), 1)), [0.0, 3.0], tolerance=1e-6, name="f"
    )
    np.testing.assert_allclose(found.value(X)[:, 0], np.sin(X), atol=1e-6)
    assert found.error < 1e-6


@pytest.mark.parametrize("place", [0.37, 1.234, 2.9])
@pytest.mark.parametrize("width", [0.02, 0.05])
def test_a_narrow_feature_between_the_first_nodes_is_not_lost(place, width):
    def bump(x):
        return 1.0 + 5.0 * np.exp(-(((x - place) / width) ** 2))[:, None]

    found = smooth(bump, [0.0, 3.0], tolerance=1e-14, name="f")
    np.testing.assert_allclose(found.integral.value(3.0), 3.0 + 5.0 * width * np.sqrt(np.pi), rtol=1e-3)
    np.testing.assert_allclose(found.value(X), bump(X), atol=1e-12)


def test_components_are_measured_by_their_group():
    """A large offset leaves the small ones their digits."""

    def mixed(x):
        return np.stack([1.0 + 0.5 * np.sin(20.0 * x), np.full_like(x, 1e10)], axis=-1)

    apart = smooth(mixed, [0.0, 3.0], tolerance=1e-14, name="f", groups=(0, 1))
    np.testing.assert_allclose(apart.value(X)[:, 0], mixed(X)[:, 0], atol=1e-13)

"""Moments of swept solids from their sections against brute-force quadrature in space and closed forms."""

import numpy as np
import pytest

from gearwright.moments.sweep import _harmonic_integrals, radial_sweep, revolution_sweep, straight_sweep

X, W = np.polynomial.legendre.leggauss(24)


def patch():
    """Points (n, 2) and weights (n,) of an asymmetric region of the plane, x > 0: a bent quadrilateral."""
    s, t = (g.ravel() for g in np.meshgrid((X + 1) / 2, (X + 1) / 2, indexing="ij"))
    points = np.stack([2.0 + s + 0.3 * s * t + 0.2 * t**2, -1.0 + 1.5 * t - 0.4 * s + 0.3 * s**2], axis=-1)
    ds = np.stack([1.0 + 0.3 * t, -0.4 + 0.6 * s], axis=-1)
    dt = np.stack([0.3 * s + 0.4 * t, np.full_like(s, 1.5)], axis=-1)
    return points, (ds[:, 0] * dt[:, 1] - ds[:, 1] * dt[:, 0]) * np.outer(W, W).ravel() / 4.0


def spherical_patch():
    """Points (n, 3) and weights (n,) of an asymmetric region of the unit sphere."""
    points, weights = patch()
    polar, azimuth = 0.35 * points[:, 0], 0.6 * points[:, 1]
    normals = np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)
    return normals, weights * 0.35 * 0.6 * np.sin(polar)


def section_moments():
    points, weights = patch()
    x, y = points.T
    return np.array([[np.sum(weights * x**a * y**b) if a + b <= 3 else 0.0 for b in range(4)] for a in range(4)])


def in_space(points, weights):
    h = np.column_stack([np.ones(len(points)), points])
    return np.einsum("n,ni,nj->ij", weights, h, h)


def along(start, stop, n=40):
    x, w = np.polynomial.legendre.leggauss(n)
    return (start + stop) / 2.0 + (stop - start) / 2.0 * x, w * (stop - start) / 2.0


def test_a_straight_sweep_about_its_middle():
    points, weights = patch()
    z, wz = along(-0.85, 0.85)
    space = np.column_stack([np.repeat(points, len(z), axis=0), np.tile(z, len(points))])
    expected = in_space(space, np.outer(weights, wz).ravel())
    np.testing.assert_allclose(straight_sweep(section_moments(), 1.7), expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(
    ("start", "stop"), [(0.0, 0.4), (0.3, 2.9), (-2.0, 3.0), (1.0, 1.0 + 2.0 * np.pi), (-6.28, 0.0)]
)
def test_a_revolution_through_part_of_a_turn(start, stop):
    points, weights = patch()
    phi, wphi = along(start, stop)
    rho = np.repeat(points[:, 0], len(phi))
    turned = np.tile(phi, len(points))
    space = np.column_stack([rho * np.cos(turned), rho * np.sin(turned), np.repeat(points[:, 1], len(phi))])
    expected = in_space(space, np.outer(weights, wphi).ravel() * rho)
    result = revolution_sweep(section_moments(), start, stop)
    np.testing.assert_allclose(result, expected, atol=1e-12 * np.max(expected))
    if stop - start > 6.2831:
        assert result[0, 1] == result[0, 2] == result[1, 2] == result[1, 3] == result[2, 3] == 0.0


def test_a_torus():
    major, minor = 5.0, 1.3
    area, bend = np.pi * minor**2, np.pi * minor**4 / 4.0
    section = np.zeros((4, 4))
    section[0, 0], section[1, 0], section[2, 0] = area, area * major, area * major**2 + bend
    section[3, 0], section[0, 2], section[1, 2] = area * major**3 + 3.0 * major * bend, bend, bend * major
    matrix = revolution_sweep(section, 0.0, 2.0 * np.pi)
    volume = 2.0 * np.pi**2 * major * minor**2
    assert matrix[0, 0] == pytest.approx(volume, rel=1e-14)
    assert matrix[1, 1] + matrix[2, 2] == pytest.approx(volume * (major**2 + 0.75 * minor**2), rel=1e-14)
    assert matrix[3, 3] == pytest.approx(volume * minor**2 / 4.0, rel=1e-14)


@pytest.mark.parametrize("turn", [lambda r: 0.0 * r, lambda r: 1.3 * np.log(r / 2.5), lambda r: 0.4 - 0.3 * r**2])
def test_a_radial_sweep_that_turns(turn):
    normals, weights = spherical_patch()
    r, wr = along(1.8, 3.1)
    w = turn(r)

    def radial_integral(power, harmonic):
        return complex(np.sum(wr * r**power * np.cos(harmonic * w)), np.sum(wr * r**power * np.sin(harmonic * w)))

    expected = np.zeros((4, 4))
    for distance, angle, weight in zip(r, w, wr, strict=True):
        c, s = np.cos(angle), np.sin(angle)
        turned = normals @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        expected += in_space(distance * turned, weights * weight * distance**2)
    result = radial_sweep(in_space(normals, weights), radial_integral)
    np.testing.assert_allclose(result, expected, atol=1e-12 * np.max(expected))
    np.testing.assert_array_equal(result, result.T)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.7, 2.0, 2.999, 3.0, 3.001, 5.0, 12.0, 300.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_harmonic_integrals_keep_every_digit(angle, sign):
    """∫ s^k e^{i angle s} ds against quadrature in fifty digits."""
    import mpmath

    angle *= sign
    with mpmath.workdps(50):
        cuts = mpmath.linspace(-1, 1, 2 + int(abs(angle)))
        for k, found in enumerate(_harmonic_integrals(angle)):
            exact = complex(mpmath.quad(lambda s, k=k: s**k * mpmath.expj(angle * s), cuts))
            assert abs(found - exact) < 4e-16

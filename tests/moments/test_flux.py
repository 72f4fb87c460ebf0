"""Flux through spheres and boxes away from the origin gives their moments."""

import numpy as np
import pytest

from gearwright.moments.flux import flux_moments

CENTRE = np.array([0.7, -1.3, 2.1])


def test_a_sphere():
    radius, (x, w) = 1.9, np.polynomial.legendre.leggauss(12)
    azimuth = np.arange(24) * 2.0 * np.pi / 24
    u, phi = (g.ravel() for g in np.meshgrid(x, azimuth, indexing="ij"))
    normals = np.stack([np.sqrt(1 - u**2) * np.cos(phi), np.sqrt(1 - u**2) * np.sin(phi), u], axis=-1)
    weights = np.repeat(w, 24) * 2.0 * np.pi / 24 * radius**2
    volume = 4.0 / 3.0 * np.pi * radius**3
    matrix = flux_moments(CENTRE + radius * normals, normals * weights[:, None])
    assert matrix[0, 0] == pytest.approx(volume, rel=1e-14)
    np.testing.assert_allclose(matrix[0, 1:], volume * CENTRE, rtol=1e-13)
    np.testing.assert_allclose(
        matrix[1:, 1:], volume * (np.outer(CENTRE, CENTRE) + radius**2 / 5.0 * np.eye(3)), rtol=1e-13
    )


def test_a_box():
    sides, (x, w) = np.array([1.0, 2.5, 0.6]), np.polynomial.legendre.leggauss(3)
    points, areas = [], []
    for axis in range(3):
        a, b = [k for k in range(3) if k != axis]
        s, t = (g.ravel() for g in np.meshgrid(x, x, indexing="ij"))
        for sign in (-1.0, 1.0):
            face = np.zeros((9, 3))
            face[:, axis], face[:, a], face[:, b] = sign, s, t
            normal = np.zeros((9, 3))
            normal[:, axis] = sign * np.outer(w, w).ravel() * sides[a] * sides[b] / 4.0
            points.append(CENTRE + face * sides / 2.0)
            areas.append(normal)
    matrix = flux_moments(np.concatenate(points), np.concatenate(areas))
    volume = sides.prod()
    expected = np.outer([1.0, *CENTRE], [1.0, *CENTRE]) * volume
    expected[1:, 1:] += np.diag(sides**2) * volume / 12.0
    np.testing.assert_allclose(matrix, expected, rtol=1e-13)

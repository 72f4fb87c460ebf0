"""Moments of regions of the unit sphere against spherical triangles and sums of turned parts."""

import numpy as np
import pytest

from gearwright.moments.sphere import region_moments


def great_arc(a, b, nodes=40):
    """Points and weighted tangents of the great circle's arc from a to b."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    across = b - np.dot(a, b) * a
    across /= np.linalg.norm(across)
    angle = np.arccos(np.dot(a, b))
    t = angle * (x + 1.0) / 2.0
    points = np.outer(np.cos(t), a) + np.outer(np.sin(t), across)
    tangents = np.outer(-np.sin(t), a) + np.outer(np.cos(t), across)
    return points, tangents * (w * angle / 2.0)[:, None]


def boundary(corners, nodes=40):
    arcs = [great_arc(a, b, nodes) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    return tuple(np.concatenate(part) for part in zip(*arcs, strict=True))


def unit(*vectors):
    return [np.array(v) / np.linalg.norm(v) for v in vectors]


TRIANGLE = unit([1.0, 0.2, 0.9], [0.1, 1.3, 0.4], [0.3, 0.5, 1.5])
BELOW = unit([1.0, 0.2, -0.9], [0.1, 1.3, -1.4], [0.3, 0.5, 0.5])


def excess(corners):
    """Girard: the solid angle is the sum of the angles less π."""
    total = -np.pi
    for i in range(3):
        p, q, r = (corners[(i + k) % 3] for k in range(3))
        u, v = q - np.dot(p, q) * p, r - np.dot(p, r) * p
        total += np.arccos(np.dot(u, v) / np.linalg.norm(u) / np.linalg.norm(v))
    return total


def brute(corners, n=60):
    """Σ h hᵀ dΩ over the flat triangle seen from the centre: dΩ = d·dA/r³, by Gauss points."""
    a, b, c = corners
    x, w = np.polynomial.legendre.leggauss(n)
    s, t = ((g.ravel() + 1.0) / 2.0 for g in np.meshgrid(x, x, indexing="ij"))
    flat = a + np.outer(s, b - a) + np.outer(s * t, c - b)
    area = np.linalg.det(np.stack(corners))
    weight = np.outer(w, w).ravel() / 4.0 * s * area / np.linalg.norm(flat, axis=1) ** 3
    h = np.column_stack([np.ones(n * n), flat / np.linalg.norm(flat, axis=1)[:, None]])
    return np.einsum("n,ni,nj->ij", weight, h, h)


@pytest.mark.parametrize("corners", [TRIANGLE, BELOW], ids=["above", "across the equator"])
def test_a_spherical_triangle(corners):
    matrix = region_moments(*boundary(corners))
    assert np.linalg.det(np.stack(corners)) > 0.0
    assert matrix[0, 0] == pytest.approx(excess(corners), rel=1e-13)
    np.testing.assert_allclose(matrix, brute(corners), atol=1e-12)
    np.testing.assert_array_equal(matrix, matrix.T)


def test_the_first_moment_of_a_triangle_is_half_its_sides_along_their_poles():
    matrix, expected = region_moments(*boundary(TRIANGLE)), np.zeros(3)
    for a, b in zip(TRIANGLE, [*TRIANGLE[1:], TRIANGLE[0]], strict=True):
        pole = np.cross(a, b)
        expected += np.arccos(np.dot(a, b)) * pole / np.linalg.norm(pole) / 2.0
    np.testing.assert_allclose(matrix[0, 1:], expected, rtol=1e-13)


def test_the_other_sense_is_negative():
    points, tangents = boundary(TRIANGLE)
    np.testing.assert_allclose(region_moments(points, -tangents), -region_moments(points, tangents))


@pytest.mark.parametrize("order", [2, 3, 5])
def test_one_part_of_the_boundary_stands_for_all(order):
    """A star about +z, of which one point's two arcs are given."""
    step = 2.0 * np.pi / order
    turns = [
        np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]]) for a in step * np.arange(order)
    ]
    tip, notch = unit([1.0, 0.0, 0.6], [0.3 * np.cos(0.6 * step), 0.3 * np.sin(0.6 * step), 1.0])
    arcs = [great_arc(tip, notch), great_arc(notch, turns[1] @ tip)]
    points, tangents = (np.concatenate(part) for part in zip(*arcs, strict=True))
    expected = region_moments(*(np.concatenate([part @ r.T for r in turns]) for part in (points, tangents)))
    np.testing.assert_allclose(region_moments(points, tangents, order=order), expected, atol=1e-12)
    pole = np.array([0.0, 0.0, 1.0])
    corners = [r @ p for r in turns for p in (tip, notch)]
    pieces = [brute([pole, p, q]) for p, q in zip(corners, [*corners[1:], corners[0]], strict=True)]
    np.testing.assert_allclose(expected, np.sum(pieces, axis=0), atol=1e-11)

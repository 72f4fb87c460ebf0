"""The moment matrix against tetrahedra and triangles in rational arithmetic, and explicit sums of turned bodies."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.moments.matrix import (
    affine,
    central_second,
    inertia_tensor,
    moment_matrix,
    patterned,
    shifted,
    transformed,
)

COORDINATE = st.integers(-9, 9)


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    minors = ([r[:j] + r[j + 1 :] for r in rows[1:]] for j in range(len(rows)))
    return sum((-1) ** j * rows[0][j] * determinant(m) for j, m in enumerate(minors))


def simplex_moments(corners):
    """Exact moments of a tetrahedron or triangle: ∫ λ_i λ_j is (1 + [i = j]) V d!/(d + 2)!, with h = Σ λ_i h_i."""
    d = len(corners) - 1
    volume = abs(determinant([[b - a for a, b in zip(corners[0], c, strict=True)] for c in corners[1:]]))
    volume = Fraction(volume) / (6 if d == 3 else 2)
    h = [[Fraction(1), *c] for c in corners]
    total = [[Fraction(0)] * (d + 1) for _ in range(d + 1)]
    for i, p in enumerate(h):
        for j, q in enumerate(h):
            share = volume * (2 if i == j else 1) / ((d + 1) * (d + 2))
            for a in range(d + 1):
                for b in range(d + 1):
                    total[a][b] += share * p[a] * q[b]
    return total


def floats(matrix):
    return np.array([[float(x) for x in row] for row in matrix])


def image(corners, linear, translation):
    return [
        [sum(a * x for a, x in zip(row, c, strict=True)) + t for row, t in zip(linear, translation, strict=True)]
        for c in corners
    ]


@pytest.mark.parametrize("d", [2, 3])
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_an_affine_map_carries_the_moments(d, data):
    vector = st.lists(COORDINATE, min_size=d, max_size=d)
    corners = data.draw(st.lists(vector, min_size=d + 1, max_size=d + 1))
    linear = data.draw(st.lists(vector, min_size=d, max_size=d))
    translation = data.draw(vector)
    exact = floats(simplex_moments(image(corners, linear, translation)))
    before = floats(simplex_moments(corners))
    bound = 1e-13 * (np.abs(exact).max() + np.abs(before).max() * 1e6)
    np.testing.assert_allclose(transformed(before, linear, translation), exact, atol=bound, rtol=1e-11)


def test_a_mirror_image_has_positive_volume_and_opposite_products():
    corners = [[0, 0, 0], [3, 1, 0], [1, 4, 1], [0, 1, 5]]
    before = floats(simplex_moments(corners))
    after = transformed(before, np.diag([1.0, -1.0, 1.0]))
    assert after[0, 0] == before[0, 0] > 0.0
    np.testing.assert_allclose(after[1, 2], -before[1, 2])
    np.testing.assert_allclose(after[1, 3], before[1, 3])


def test_a_shift_is_that_of_the_corners():
    corners = [[1, 0, 2], [3, 1, 0], [1, 4, 1], [0, 1, 5]]
    moved = [[x + 7, y - 2, z + 3] for x, y, z in corners]
    np.testing.assert_allclose(
        shifted(floats(simplex_moments(corners)), [7, -2, 3]), floats(simplex_moments(moved)), rtol=1e-14
    )
    plane = [[1, 0], [3, 1], [2, 5]]
    moved = [[x + 7, y - 2] for x, y in plane]
    np.testing.assert_allclose(
        shifted(floats(simplex_moments(plane)), [7, -2]), floats(simplex_moments(moved)), rtol=1e-14
    )


def test_a_plane_region_is_placed_in_space_by_a_rectangular_map():
    placed = affine([[1.0, 0.0], [0.0, 0.0], [0.0, 2.0]], [5.0, 6.0, 7.0])
    np.testing.assert_array_equal(placed @ [1.0, 10.0, 20.0], [1.0, 15.0, 6.0, 47.0])


def test_stacks_of_matrices_are_carried_together():
    a = floats(simplex_moments([[1, 0, 2], [3, 1, 0], [1, 4, 1], [0, 1, 5]]))
    b = floats(simplex_moments([[0, 0, 0], [3, 1, 0], [1, 4, 1], [0, 1, 5]]))
    linear = [[1.0, 0.2, 0.0], [0.0, 2.0, 0.5], [0.3, 0.0, -1.0]]
    both = transformed(np.stack([a, b]), linear, [1.0, 2.0, 3.0])
    np.testing.assert_allclose(both[1], transformed(b, linear, [1.0, 2.0, 3.0]))
    np.testing.assert_allclose(central_second(np.stack([a, b]))[0], central_second(a))
    stacked = moment_matrix([1.0, 2.0], np.ones((2, 3)), np.zeros((2, 3, 3)))
    assert stacked.shape == (2, 4, 4)
    assert stacked[1, 0, 0] == 2.0


@pytest.mark.parametrize("function", [lambda m: patterned(m, 3), lambda m: inertia_tensor(m[..., 1:, 1:])])
def test_every_function_takes_stacks(function):
    rng = np.random.default_rng(3)
    stack = rng.normal(size=(3, 4, 4))
    together = function(stack)
    for one, alone in zip(together, stack, strict=True):
        np.testing.assert_allclose(one, function(alone))


def test_a_stack_of_maps_carries_a_stack_of_bodies():
    rng = np.random.default_rng(3)
    stack, maps = rng.normal(size=(4, 4, 4)), rng.normal(size=(4, 3, 3))
    together = transformed(stack, maps)
    for one, body, linear in zip(together, stack, maps, strict=True):
        np.testing.assert_allclose(one, transformed(body, linear))


@pytest.mark.parametrize("order", range(1, 8))
@pytest.mark.parametrize("d", [2, 3])
def test_a_pattern_is_the_sum_of_its_turned_copies(order, d):
    corners = [[1, 0, 2], [3, 1, 0], [1, 4, 1], [0, 1, 5]]
    body = floats(simplex_moments([c[:d] for c in corners[: d + 1]]))
    expected = np.zeros_like(body)
    for k in range(order):
        c, s = np.cos(2.0 * np.pi * k / order), np.sin(2.0 * np.pi * k / order)
        turned = np.array(
            [[x * c - y * s, x * s + y * c, *rest] for x, y, *rest in (c_[:d] for c_ in corners[: d + 1])]
        )
        h = np.column_stack([np.ones(d + 1), turned])
        weights = (np.ones((d + 1, d + 1)) + np.eye(d + 1)) / ((d + 1) * (d + 2)) * body[0, 0]
        expected += h.T @ weights @ h
    result = patterned(body, order)
    np.testing.assert_allclose(result, expected, atol=1e-12 * np.abs(expected).max())
    if order >= 2:
        assert not result[0, 1:3].any()
        assert not result[1:3, 3:].any()
    if order >= 3:
        assert result[1, 2] == result[2, 1] == 0.0
        assert result[1, 1] == result[2, 2]


def test_the_central_second_moment_is_that_about_the_centroid():
    corners = [[3, 0, 6], [9, 3, 0], [3, 12, 3], [1, 1, 3]]
    centroid = [Fraction(sum(c[k] for c in corners), 4) for k in range(3)]
    centred = [[Fraction(x) - m for x, m in zip(c, centroid, strict=True)] for c in corners]
    exact = floats(simplex_moments(centred))[1:, 1:]
    np.testing.assert_allclose(central_second(floats(simplex_moments(corners))), exact, rtol=1e-12)


def test_the_inertia_tensor_gives_angular_momentum():
    rng = np.random.default_rng(5)
    points, masses = rng.normal(size=(6, 3)), rng.uniform(0.5, 2.0, 6)
    second = np.einsum("n,ni,nj->ij", masses, points, points)
    for omega in (np.array([0.3, -1.2, 0.7]), np.array([0.0, 0.0, 1.0])):
        momentum = np.sum(masses[:, None] * np.cross(points, np.cross(omega, points)), axis=0)
        np.testing.assert_allclose(inertia_tensor(second) @ omega, momentum, rtol=1e-13)


def test_the_matrix_has_its_parts_in_their_places():
    second = np.array([[1.0, 2.0, 3.0], [2.0, 4.0, 5.0], [3.0, 5.0, 6.0]])
    matrix = moment_matrix(7.0, [8.0, 9.0, 10.0], second)
    np.testing.assert_array_equal(matrix, [[7, 8, 9, 10], [8, 1, 2, 3], [9, 2, 4, 5], [10, 3, 5, 6]])

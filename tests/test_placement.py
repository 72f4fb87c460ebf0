import numpy as np
import pytest

from gearwright.errors import GeometryError
from gearwright.placement import Placement, require_rotation

LEANING = Placement.of([[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]], (0.7, -1.9, 3.1))
POINTS = np.array([[1.0, 2.0, 3.0], [-4.0, 0.5, 0.1]])


def test_points_are_turned_and_then_shifted():
    quarter = Placement.of([[0, -1, 0], [1, 0, 0], [0, 0, 1]], (10.0, 0.0, 0.5))
    np.testing.assert_array_equal(quarter.points(POINTS), [[8.0, 1.0, 3.5], [9.5, -4.0, 0.6]])
    np.testing.assert_array_equal(quarter.vectors(POINTS), [[-2.0, 1.0, 3.0], [-0.5, -4.0, 0.1]])


def test_there_and_back():
    np.testing.assert_allclose(LEANING.points_back(LEANING.points(POINTS)), POINTS, atol=1e-15)
    np.testing.assert_allclose(LEANING.vectors_back(LEANING.vectors(POINTS)), POINTS, atol=1e-15)


def test_one_after_another():
    quarter = Placement.of([[0, -1, 0], [1, 0, 0], [0, 0, 1]], (10.0, 0.0, 0.5))
    both = LEANING.after(quarter)
    np.testing.assert_allclose(both.points(POINTS), LEANING.points(quarter.points(POINTS)), atol=1e-14)
    assert not np.allclose(both.points(POINTS), quarter.points(LEANING.points(POINTS)))


@pytest.mark.parametrize(
    ("rotation", "shift", "keeps", "flips"),
    [
        (np.eye(3), (0.0, 0.0, 7.0), True, False),
        ([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]], (0.0, 0.0, 0.0), True, False),
        (np.eye(3), (1e-9, 0.0, 0.0), False, False),
        (np.diag([1.0, -1.0, -1.0]), (0.0, 0.0, 3.0), False, True),
        (np.diag([1.0, -1.0, -1.0]), (0.0, 2.0, 3.0), False, False),
        (LEANING.rotation, (0.0, 0.0, 0.0), False, False),
    ],
)
def test_what_becomes_of_the_axis(rotation, shift, keeps, flips):
    placement = Placement.of(rotation, shift)
    assert (placement.keeps_axis, placement.flips_axis) == (keeps, flips)


@pytest.mark.parametrize(
    ("matrix", "words"),
    [
        (np.diag([1.0, 1.0, -1.0]), "mirror"),
        (2.0 * np.eye(3), "orthonormal rows"),
        (np.eye(2), r"shape \(2, 2\)"),
        (np.full((3, 3), np.nan), "rotation is needed"),
        (np.eye(3) + 1e-10, "to 1e-12"),
    ],
)
def test_what_is_no_rotation(matrix, words):
    with pytest.raises(GeometryError, match=words):
        require_rotation(matrix, 1e-12)

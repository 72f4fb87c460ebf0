"""Polygons in one plane: how near they come, and what lies in what."""

import numpy as np
import pytest

from gearwright.boundary.outlines import nearest_approach, winding

SQUARE = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])


def test_distance_is_between_sides_and_not_only_between_corners():
    diamond = np.array([[2.5, 1.0], [3.5, 0.0], [4.5, 1.0], [3.5, 2.0]])
    for one, other in ((SQUARE, diamond), (diamond, SQUARE)):
        distance, where = nearest_approach(one, other)
        assert distance == pytest.approx(0.5)
        np.testing.assert_allclose(where, [2.5, 1.0])


def test_nested_polygons_have_the_distance_of_their_sides():
    assert nearest_approach(SQUARE, 0.8 * SQUARE + 0.1)[0] == pytest.approx(0.1)


def test_a_cross_has_no_corner_in_the_other_and_yet_crosses():
    wide, tall = SQUARE * [5.0, 0.5] + [-4.0, 0.5], SQUARE * [0.5, 5.0] + [0.5, -4.0]
    distance, where = nearest_approach(wide, tall)
    assert distance == 0.0
    assert any(np.allclose(where, p) for p in ([0.5, 0.5], [1.5, 0.5], [0.5, 1.5], [1.5, 1.5]))


def test_winding_counts_turns_with_their_sense():
    assert winding(np.array([1.0, 1.9]), SQUARE) == 1
    assert winding(np.array([1.0, 1.9]), SQUARE[::-1]) == -1
    assert winding(np.array([1.0, 2.1]), SQUARE) == 0
    assert winding(np.array([1.0, 1.0]), np.concatenate([SQUARE, SQUARE])) == 2

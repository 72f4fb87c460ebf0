"""Fans and area vectors of polygon faces."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.faces import corner_lists, face_vectors, fan_triangles, next_corners

L_SHAPE = np.array([[0.0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]])


def test_corner_lists_of_an_array_and_of_lists_are_the_same():
    for faces in (np.array([[0, 1, 2], [2, 1, 3]]), [[0, 1, 2], (2, 1, 3)]):
        indices, offsets = corner_lists(faces)
        assert indices.tolist() == [0, 1, 2, 2, 1, 3]
        assert offsets.tolist() == [0, 3, 6]
    assert [part.tolist() for part in corner_lists([[4, 5, 6, 7], [0, 1, 2]])] == [[4, 5, 6, 7, 0, 1, 2], [0, 4, 7]]
    assert [part.tolist() for part in corner_lists([])] == [[], [0]]


@pytest.mark.parametrize("faces", [np.array([[0.0, 1, 2]]), [[0, 1, 2.5]], [[True, False, True]]])
def test_corners_that_are_no_whole_numbers_are_refused(faces):
    with pytest.raises(ValueError, match="whole numbers"):
        corner_lists(faces)


def test_fans_of_mixed_faces():
    indices, offsets = corner_lists([[0, 1, 2, 3, 4], [5, 6, 7], [8, 9, 1, 2]])
    expected = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [5, 6, 7], [8, 9, 1], [8, 1, 2]]
    assert fan_triangles(indices, offsets).tolist() == expected
    assert next_corners(indices, offsets).tolist() == [1, 2, 3, 4, 0, 6, 7, 5, 9, 1, 2, 8]


@pytest.mark.parametrize("first", range(6))
def test_area_of_a_non_convex_face_from_any_corner(first):
    faces = corner_lists([np.roll(np.arange(6), first), [0, 2, 1]])
    np.testing.assert_allclose(face_vectors(L_SHAPE, *faces), [[0, 0, 3], [0, 0, -1]], atol=1e-15)

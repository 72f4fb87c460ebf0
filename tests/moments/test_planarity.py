"""How large faces are, and how far they are from plane."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.faces import corner_lists, face_vectors
from gearwright.moments.planarity import face_measures

from .bodies import gear_like, star_shaped

L_SHAPE = np.array([[0.0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]])


@pytest.mark.parametrize("body", [gear_like(), gear_like(hole=True), star_shaped()])
def test_areas_are_the_lengths_of_area_vectors_and_closed_faces_leave_no_residual(body):
    vertices, faces = body
    measures = face_measures(vertices, *corner_lists(faces))
    vectors = face_vectors(vertices, *corner_lists(faces))
    np.testing.assert_allclose(measures.areas, np.linalg.norm(vectors, axis=1), rtol=1e-13)
    assert np.abs(measures.residual).max() < 3e-16 * measures.areas.sum()
    missing = face_measures(vertices, *corner_lists(faces[1:]))
    np.testing.assert_allclose(missing.residual, -vectors[0], atol=1e-15)


def test_extents_are_from_the_first_corner():
    assert face_measures(L_SHAPE, *corner_lists([range(6), [3, 4, 2]])).extents.tolist() == [5**0.5, 1.0]


def test_deviations_of_a_quadrilateral_with_one_corner_lifted():
    """The mean plane of a slightly warped square leaves a quarter of the lift to each corner."""
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 4e-3], [0, 1, 0]])
    faces = corner_lists([range(4), [0, 1, 2]])
    for offset in (0.0, 1e6):
        found = face_measures(square + offset, *faces).deviations
        assert found[0] == pytest.approx(1e-3, rel=1e-5)
        assert found[1] == 0
    assert face_measures(100 * square, *faces).deviations[0] == pytest.approx(0.1, rel=1e-5)
    assert face_measures(L_SHAPE + 1e6, *corner_lists([range(6)])).deviations.tolist() == [0.0]


def test_deviations_without_an_area_vector():
    bow_tie = np.array([[0.0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]])
    assert face_measures(bow_tie, *corner_lists([range(4)])).deviations[0] < 1e-15
    bow_tie[:2, 2], bow_tie[2:, 2] = 0.2, -0.2  # a saddle
    assert face_measures(bow_tie, *corner_lists([range(4)])).deviations[0] > 0.1

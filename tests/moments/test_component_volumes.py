"""Signed volumes of parts of boundaries, against rational arithmetic where they cancel."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.component_volumes import component_volumes
from gearwright.moments.components import component_boxes
from gearwright.moments.faces import corner_lists

from .bodies import cube, exact_moments, nested_cubes


def test_volumes_are_signed_and_about_any_point():
    np.testing.assert_allclose(component_volumes(*nested_cubes(), np.zeros((2, 3))), [8.0, -1.0])
    middles = component_boxes(*nested_cubes(), 2).mean(axis=1)
    np.testing.assert_allclose(component_volumes(*nested_cubes(), middles), [8.0, -1.0])


@pytest.mark.parametrize("shape", [[1, 1e-10, 1e-10], [1, 1, 1e-15], [1, 1e-7, 1e-14]])
@pytest.mark.parametrize("shear", [0.0, 1e7])
def test_the_volume_of_a_thin_turned_body_is_that_of_its_corners(shape, shear):
    """Of the rounded corners, which may well be negative. Plain sums keep two digits before they are redone."""
    random = np.random.default_rng(7)
    for _ in range(8):
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        points = cube()[0] * shape
        points[:, 0] += shear * points[:, 2]
        points = points @ (turn * np.linalg.det(turn)).T
        faces = [triangle for a, b, c, d in cube()[1] for triangle in ([a, b, c], [a, c, d])]
        (found,) = component_volumes(points, *corner_lists(faces), np.zeros(12, int), points[:1] + 0.3)
        exact = exact_moments(points, faces)[0]
        assert found == pytest.approx(float(exact), rel=1e-2, abs=0.0)


def test_what_has_no_volume_has_exactly_none():
    sheet = np.random.default_rng(2).normal(size=(8, 3))
    faces = corner_lists([[0, 1, 2], [2, 1, 0], [3, 4, 5], [4, 3, 5]])
    found = component_volumes(sheet, *faces, np.array([0, 0, 1, 1]), sheet[6:8])
    assert found.tolist() == [0.0, 0.0]

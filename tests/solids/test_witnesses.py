"""Points inside faces: by which it is told where shells lie."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from gearwright.moments.faces import corner_lists
from gearwright.solids.validity.witnesses import face_points

from ..moments.bodies import gear_like

COMB = [(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (3, 1), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
SPIKE = [(0, 0), (4, 0), (4, 4), (0, 4), (3.9, 2)]
STRAIGHT = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 1), (0, 1), (0, 0.5)]
KEYHOLE = [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0), (3, 3), (3, 6), (6, 6), (6, 3), (3, 3)]
TWICE = [(0, 0), (0, 0), (2, 0), (2, 0), (1, 2)]


@pytest.mark.parametrize("corners", [COMB, SPIKE, STRAIGHT, KEYHOLE, TWICE, COMB[::-1], SPIKE[::-1]])
def test_points_are_inside_polygons_from_whichever_corner_they_begin(corners):
    polygon = shapely.Polygon(corners)
    region = (
        shapely.Polygon(polygon.exterior)
        if corners is not KEYHOLE
        else shapely.box(0, 0, 9, 9) - shapely.box(3, 3, 6, 6)
    )
    turn = np.linalg.qr(np.random.default_rng(len(corners)).normal(size=(3, 3)))[0]
    for first in range(len(corners)):
        flat = np.roll(np.array(corners, float), first, axis=0)
        space = np.c_[flat, np.full(len(flat), 2.0)] @ turn.T
        (point,), (area,) = face_points(space, *corner_lists([range(len(flat))]), np.array([0]))
        local = point @ turn
        assert local[2] == pytest.approx(2.0, abs=1e-14)
        assert shapely.Point(local[:2]).within(region)
        assert region.boundary.distance(shapely.Point(local[:2])) > 0.01
        assert np.linalg.norm(area) == pytest.approx(region.area)


def test_points_of_chosen_faces_and_of_one_without_an_inside():
    vertices, faces = gear_like()
    points, _ = face_points(vertices, *corner_lists(faces), np.array([1, 0, 3]))
    assert points[:2, 2].tolist() == [0.5, 0.0]
    assert 0.0 < points[2, 2] < 0.5
    line = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 0, 0]])
    assert face_points(line, *corner_lists([range(4)]), np.array([0]))[0].tolist() == [[0.5, 0.0, 0.0]]

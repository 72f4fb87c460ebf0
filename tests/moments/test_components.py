"""Parts of boundaries: boxes, volumes, and what they wind around."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.component_volumes import component_volumes
from gearwright.moments.components import component_boxes, winding_number
from gearwright.moments.faces import corner_lists, fan_triangles
from gearwright.moments.windings import windings

from .bodies import cube, gear_like, joined, moved, reversed_faces, star_shaped


def nested_cubes():
    vertices, faces = joined(cube(2.0), moved(reversed_faces(cube()), 0.5))
    return vertices, *corner_lists(faces), np.repeat([0, 1], 6)


def test_boxes_and_signed_volumes():
    boxes = component_boxes(*nested_cubes(), 2)
    np.testing.assert_array_equal(boxes, [[[0, 0, 0], [2, 2, 2]], [[0.5] * 3, [1.5] * 3]])
    np.testing.assert_allclose(component_volumes(*nested_cubes(), np.zeros((2, 3))), [8.0, -1.0])
    np.testing.assert_allclose(component_volumes(*nested_cubes(), boxes.mean(axis=1)), [8.0, -1.0])


@pytest.mark.parametrize(("point", "expected"), [((0, 0, 0.25), 1), ((0, 0, 1), 0), ((0.95, 0.13, 0.25), 0)])
def test_winding_number_of_a_gear_with_non_convex_faces(point, expected):
    vertices, faces = gear_like()
    triangles = fan_triangles(*corner_lists(faces))
    assert winding_number(np.array(point), vertices, triangles) == pytest.approx(expected, abs=1e-12)
    assert winding_number(np.array(point), vertices, triangles[:, ::-1]) == pytest.approx(-expected, abs=1e-12)


@pytest.mark.parametrize(
    "body", [gear_like(), gear_like(hole=True), star_shaped(), reversed_faces(star_shaped(seed=2))]
)
def test_windings_agree_with_solid_angles(body):
    """Of random points, and of points below corners and edges, where the lines towards +z meet these exactly."""
    vertices, faces = body
    corners = corner_lists(faces)
    random = np.random.default_rng(5)
    points = random.uniform(-1.2, 1.2, (300, 3)) * np.where(np.arange(300) % 2, 1.0, 0.5)[:, None]
    below = np.concatenate([vertices, (vertices + np.roll(vertices, 1, axis=0)) / 2.0])
    below[:, 2] -= random.uniform(0.01, 1.0, len(below))
    points = np.concatenate([points, below])
    parts, labels = np.zeros(len(points), np.int64), np.zeros(len(faces), np.int64)
    found, on = windings(points, parts, vertices, *corners, labels)
    triangles = fan_triangles(*corners)
    angles = np.array([winding_number(point, vertices, triangles) for point in points])
    clear = np.abs(angles - np.round(angles)) < 1e-6  # the others are on the surface
    assert clear.sum() > 300
    assert len(set(found[clear].tolist())) == 2
    assert np.array_equal(found[clear], np.round(angles[clear]))
    assert not on[:300].any()


def test_windings_are_of_the_part_asked_about_and_know_points_on_it():
    around = np.array([[1.0, 1.0, 1.0]] * 2 + [[0.25] * 3] * 2 + [[0.5, 1.0, 1.0], [2.0, 2.0, 2.0], [0.5, 0.5, 1.0]])
    found, on = windings(around, np.array([0, 1, 0, 1, 1, 0, 1]), *nested_cubes())
    assert found[:4].tolist() == [1, -1, 1, 0]
    assert on.tolist() == [False] * 4 + [True] * 3

"""How often boundaries wind around points, and where that is unsure."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.components import winding_number
from gearwright.moments.faces import corner_lists, fan_triangles
from gearwright.moments.windings import windings

from .bodies import gear_like, nested_cubes, prism, reversed_faces, star_shaped


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


def around(points, vertices, faces):
    points = np.array(points, dtype=float)
    return windings(points, np.zeros(len(points), int), vertices, *corner_lists(faces), np.zeros(len(faces), int))


U_SHAPE = prism(np.array([[0.0, 0], [3, 0], [3, 2], [2, 2], [2, 1], [1, 1], [1, 2], [0, 2]]), 1.0)


@pytest.mark.parametrize("axes", [[0, 1, 2], [1, 2, 0], [2, 0, 1]])
def test_points_in_the_plane_of_a_face_are_only_unsure_on_it(axes):
    """In the notch of a U, whose fan from one corner covers that; above, beside and on its faces."""
    notch, beside, on = [[1.5, 1.5, 1.0], [1.5, 1.75, 0.0]], [[4.0, 2.0, 0.5], [1.5, 2.0, 0.5]], [[0.5, 1.5, 1.0]]
    upright = [U_SHAPE[0][:, axes], U_SHAPE[1]]
    found, unsure = around(np.array([*notch, *beside, *on, [1.5, 0.5, 0.5]])[:, axes], *upright)
    assert found[[0, 1, 2, 3, 5]].tolist() == [0, 0, 0, 0, 1]
    # where the U stands on end, whether a line along its own plane meets it is not asked
    assert unsure[2:].tolist() == [False, False, True, False]
    assert not unsure[:2].any() or axes != [0, 1, 2]


@pytest.mark.parametrize("off", [1e-12, 1e-15])
def test_how_near_a_face_is_unsure(off):
    cube = prism(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]), 1.0)
    sides = [[0.5, 0.5, off], [off, 0.5, 0.5], [0.5, 1.0 - off, 0.5], [0.25, 0.5, 1.0 - off]]
    found, unsure = around(sides, *cube)
    assert unsure.all() == unsure.any() == (off < 1e-14)
    if off > 1e-14:
        assert found.tolist() == [1] * 4
        assert around([[0.5, 0.5, -off], [-off, 0.5, 0.5], [0.5, 0.5, 1 + off]], *cube)[0].tolist() == [0] * 3


def test_points_above_and_below_sloping_sides_in_the_plane_of_a_wall_are_sure():
    """However the wall is turned about z, whose corners then are beside the line through the point by rounding."""
    ends = np.array([[0.0, 0.0], [4, 1], [3, 3], [1, 2]])  # in x and z
    vertices = np.concatenate([np.c_[ends[:, :1], np.full(4, y), ends[:, 1:]] for y in (0.0, 1.0)])
    faces = [[0, 1, 2, 3], [7, 6, 5, 4], *([i + 4, (i + 1) % 4 + 4, (i + 1) % 4, i] for i in range(4))]
    points = [[0.25, 0.0, 2.9], [2.0, 0.0, 2.7], [0.5, 1.0, 1.6], [2.0, 0.0, 0.1], [3.5, 1.0, 0.2], [3.0, 1.0, 0.5]]
    for angle in np.linspace(0.1, 6.0, 40):
        turn = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
        found, unsure = around(points @ turn, vertices @ turn, faces)
        assert not found.any()
        assert not unsure.any()


def test_between_the_corners_of_a_bent_face_it_is_unsure():
    vertices, faces = prism(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]), 1.0)
    vertices[6, 2] += 1e-7
    heights = np.array([[0.5, 0.5, 1.0 + height] for height in (-1e-6, 1e-8, 2e-8, 4e-8, 1e-6)])
    found, unsure = around(heights, vertices, faces)
    assert unsure.tolist() == [False, True, True, True, False]
    assert found[[0, 4]].tolist() == [1, 0]


def test_a_triangle_without_area_is_no_wall_for_points_beside_it():
    """A tetrahedron with one edge split on one side only: the triangle between the two is a line."""
    vertices = np.array([[0, 0, 0], [10, 10, 10], [10, 0, 0], [10, 10, 0], [5, 5, 5]], float)
    faces = [[2, 4, 0], [2, 1, 4], [4, 1, 0], [1, 3, 0], [3, 2, 0], [2, 3, 1]]
    points = np.random.default_rng(3).uniform(0.0, 10.0, (500, 3))
    x, y, z = points.T
    found, unsure = around(points, vertices, faces)
    assert not unsure.any()
    np.testing.assert_array_equal(found, (z < y) & (y < x))
    assert 50 < found.sum() < 150
    assert around([[5.0, 5.0, 5.0], [7.0, 7.0, 7.0]], vertices, faces)[1].all()

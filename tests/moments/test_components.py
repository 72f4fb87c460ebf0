"""Connected components, boxes in boxes, and winding numbers."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.components import component_labels, component_volumes, containers, winding_number
from gearwright.moments.faces import corner_lists, fan_triangles

from .bodies import cube, gear_like, joined, moved, reversed_faces, star_shaped


def test_labels_follow_the_first_faces():
    body = joined(gear_like(), joined(cube(), star_shaped()))
    labels = component_labels(len(body[0]), *corner_lists(body[1]))
    sizes = [len(part[1]) for part in (gear_like(), cube(), star_shaped())]
    assert labels.tolist() == np.repeat([0, 1, 2], sizes).tolist()


def test_a_long_shuffled_strip_is_one_component():
    random = np.random.default_rng(0)
    n = 5000
    strip = np.stack([np.arange(n), np.arange(n) + 1, np.arange(n) + 2], axis=1)
    shuffled = random.permutation(n + 2)[strip][random.permutation(n)]
    assert not component_labels(n + 2, *corner_lists(shuffled)).any()


def test_signed_volumes_of_components():
    vertices, faces = joined(cube(2.0), moved(reversed_faces(cube()), 0.5))
    corners = corner_lists(faces)
    labels = component_labels(len(vertices), *corners)
    np.testing.assert_allclose(component_volumes(vertices, *corners, labels, np.zeros((2, 3))), [8.0, -1.0])


def test_containers_agree_with_comparing_all_pairs():
    random = np.random.default_rng(3)
    low = random.integers(0, 6, (40, 3)).astype(float)
    boxes = np.stack([low, low + random.integers(0, 5, (40, 3))], axis=1)
    for k, around in enumerate(containers(boxes)):
        outside = {
            i
            for i in range(40)
            if i != k
            and (boxes[i, 0] <= boxes[k, 0]).all()
            and (boxes[i, 1] >= boxes[k, 1]).all()
            and not (np.array_equal(boxes[i], boxes[k]) and i not in around)
        }
        assert set(around.tolist()) == outside


@pytest.mark.parametrize(("point", "expected"), [((0, 0, 0.25), 1), ((0, 0, 1), 0), ((0.95, 0.13, 0.25), 0)])
def test_winding_number_of_a_gear_with_non_convex_faces(point, expected):
    vertices, faces = gear_like()
    triangles = fan_triangles(*corner_lists(faces))
    assert winding_number(np.array(point), vertices, triangles) == pytest.approx(expected, abs=1e-12)
    assert winding_number(np.array(point), vertices, triangles[:, ::-1]) == pytest.approx(-expected, abs=1e-12)

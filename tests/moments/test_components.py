"""Parts of boundaries: boxes, and what they wind around."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.moments.components import component_boxes, winding_number
from gearwright.moments.faces import corner_lists, fan_triangles

from .bodies import gear_like, nested_cubes


def test_boxes():
    boxes = component_boxes(*nested_cubes(), 2)
    np.testing.assert_array_equal(boxes, [[[0, 0, 0], [2, 2, 2]], [[0.5] * 3, [1.5] * 3]])


@pytest.mark.parametrize(("point", "expected"), [((0, 0, 0.25), 1), ((0, 0, 1), 0), ((0.95, 0.13, 0.25), 0)])
def test_winding_number_of_a_gear_with_non_convex_faces(point, expected):
    vertices, faces = gear_like()
    triangles = fan_triangles(*corner_lists(faces))
    assert winding_number(np.array(point), vertices, triangles) == pytest.approx(expected, abs=1e-12)
    assert winding_number(np.array(point), vertices, triangles[:, ::-1]) == pytest.approx(-expected, abs=1e-12)

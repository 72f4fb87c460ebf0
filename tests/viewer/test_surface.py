"""What the viewer is given: the whole surface, its sharp edges and no others, relative to the body's middle."""

from base64 import b64decode

import numpy as np
import pytest

import gearwright as gw
from gearwright.viewer.surface import surface

BOX = gw.Polyhedron(
    [[x, y, z] for z in (0, 3) for x, y in ((0, 0), (1, 0), (1, 2), (0, 2))],
    [[3, 2, 1, 0], [4, 5, 6, 7], *([k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4))],
)


def of(polyhedron):
    return surface(polyhedron.vertices, polyhedron.simple_triangles())


def lengths(found):
    return np.linalg.norm(np.diff(found.positions[found.edges], axis=1)[:, 0], axis=-1)


def test_a_box_has_its_twelve_edges_and_a_corner_for_each_of_its_faces():
    found = of(BOX)
    assert sorted(lengths(found)) == pytest.approx([1] * 4 + [2] * 4 + [3] * 4)
    assert len(found.positions) == 24
    assert found.closed
    np.testing.assert_allclose(found.centre, [0.5, 1.0, 1.5])


@pytest.mark.parametrize("away", [0.0, 1e7])
def test_positions_hold_in_single_precision_wherever_the_body_lies(away):
    moved = gw.Polyhedron(BOX.vertices + away, BOX.faces)
    texts = of(moved).encoded()
    positions = np.frombuffer(b64decode(texts["positions"]), "<f4").reshape(-1, 3)
    triangles = np.frombuffer(b64decode(texts["triangles"]), "<u4").reshape(-1, 3)
    volume = np.linalg.det(positions[triangles]).sum() / 6.0
    np.testing.assert_allclose(texts["centre"], [away + 0.5, away + 1.0, away + 1.5])
    assert volume == pytest.approx(6.0, rel=1e-6)


def test_a_turned_cylinder_is_sharp_at_its_rims_alone_and_its_normals_point_outward():
    found = of(gw.extrude(gw.Section.circle(5.0), 4.0).polyhedron(0.01))
    assert lengths(found).sum() == pytest.approx(2 * 2 * np.pi * 5.0, rel=2e-3)
    round_ = np.abs(found.normals[:, 2]) < 16000
    outward = np.sum(found.normals[round_, :2] * found.positions[round_, :2], axis=-1) / (32767 * 5.0)
    assert outward.min() > 0.999
    ends = found.normals[~round_, 2] * found.positions[~round_, 2]
    assert np.all(ends > 0.99 * 32767 * 2.0)


@pytest.mark.parametrize(("angle", "sharp"), [(29.0, 0), (31.0, 1)])
def test_faces_have_an_edge_between_them_where_they_meet_at_more_than_thirty_degrees(angle, sharp):
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    roof = np.array([[0.0, 0, 0], [0, 1, 0], [-1, 0, 0], [c, 0, s]])
    found = surface(roof, np.array([[0, 1, 2], [1, 0, 3]]))
    assert not found.closed
    assert len(found.edges) == 4 + sharp  # the rims of an open surface are drawn, too


def test_an_inverted_face_leaves_no_inside():
    triangles = BOX.simple_triangles().copy()
    assert surface(BOX.vertices, triangles).closed
    triangles[0] = triangles[0, ::-1]
    assert not surface(BOX.vertices, triangles).closed

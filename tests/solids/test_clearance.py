"""Faces moved inward: distances of planes, first-order volumes, gaps between gears, and what is too much."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from scipy.spatial import ConvexHull, cKDTree

import gearwright as gw
from gearwright.errors import FileError, GeometryError
from gearwright.solids.clearance import with_clearance
from gearwright.solids.polyhedron import Polyhedron

CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
TRIANGLES = [[f[i], f[j], f[k]] for f in QUADS for i, j, k in ((0, 1, 2), (0, 2, 3))]


@pytest.mark.parametrize("faces", [QUADS, TRIANGLES])
def test_a_box_has_every_plane_at_half_the_clearance(faces):
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    found = with_clearance(Polyhedron(CORNERS * [3, 4, 5] @ turn.T + 10, faces), 0.5)
    wanted = (CORNERS * [2.5, 3.5, 4.5] + 0.25) @ turn.T + 10
    np.testing.assert_allclose(found.vertices, wanted, atol=1e-13)
    assert found.properties().volume == pytest.approx(2.5 * 3.5 * 4.5, rel=1e-13)


def test_planes_of_a_random_convex_body_move_by_half_the_clearance():
    """Three planes at every vertex: a body dual to a convex hull."""
    points = np.random.default_rng(5).normal(size=(14, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    hull = ConvexHull(points)  # triangles: each is a vertex of the dual, where three planes points·x = 1 meet
    vertices = np.linalg.solve(points[hull.simplices], np.ones((len(hull.simplices), 3, 1)))[..., 0]
    faces = []
    for k, normal in enumerate(points):
        around = np.flatnonzero((hull.simplices == k).any(axis=1))
        first = vertices[around[0]] - normal
        angles = np.arctan2(np.cross(first, vertices[around] - normal) @ normal, (vertices[around] - normal) @ first)
        faces.append(around[np.argsort(angles)].tolist())
    body = Polyhedron(vertices, faces)
    assert body.validity().valid
    moved = with_clearance(body, 0.002)
    for face, normal in zip(faces, points, strict=True):
        np.testing.assert_allclose(moved.vertices[face] @ normal, 1 - 0.001, atol=1e-12)


def test_points_within_a_face_go_with_its_border():
    """A square cut finely near a border: its inner points would be passed if they stayed."""
    n = 40
    x = np.linspace(0, 1, n + 1)
    grid = np.array([(a, b) for a in x for b in x])
    number = lambda i, j, top: top * (n + 1) ** 2 + i * (n + 1) + j  # noqa: E731
    faces = [
        [number(i, j, 1), number(i + 1, j, 1), number(i + 1, j + 1, 1), number(i, j + 1, 1)]
        for i in range(n)
        for j in range(n)
    ]
    faces += [
        [number(i, j, 0), number(i, j + 1, 0), number(i + 1, j + 1, 0), number(i + 1, j, 0)]
        for i in range(n)
        for j in range(n)
    ]
    border = (
        [(i, 0) for i in range(n)]
        + [(n, j) for j in range(n)]
        + [(i, n) for i in range(n, 0, -1)]
        + [(0, j) for j in range(n, 0, -1)]
    )
    faces += [
        [number(*a, 0), number(*b, 0), number(*b, 1), number(*a, 1)]
        for a, b in zip(border, border[1:] + border[:1], strict=True)
    ]
    body = Polyhedron(np.concatenate([np.column_stack([grid, np.full(len(grid), z)]) for z in (0.0, 1.0)]), faces)
    moved = with_clearance(body, 0.1)  # twice the distance of points
    assert moved.properties().volume == pytest.approx(0.9**3, rel=1e-12)
    assert not moved.self_intersections()
    assert moved.validity().valid


def test_a_bore_becomes_wider():
    gear = gw.SpurGear(teeth=20, module=2, face_width=10, bore=12).polyhedron(0.01)
    moved = with_clearance(gear, 0.2)
    inner = np.linalg.norm(gear.vertices[:, :2], axis=1) < 6 + 1e-9
    np.testing.assert_allclose(np.linalg.norm(moved.vertices[inner, :2], axis=1), 6.1, atol=2e-3)
    np.testing.assert_allclose(np.ptp(moved.vertices[:, 2]), 9.8, atol=1e-12)


ELEMENTS = {
    "spur": lambda: gw.SpurGear(teeth=20, module=2, face_width=10),
    "helical": lambda: gw.HelicalGear(teeth=20, module=2, face_width=10, helix_angle=20, bore=12),
    "internal": lambda: gw.InternalGear(teeth=50, module=2, face_width=10),
    "bevel": lambda: gw.BevelPair(teeth=(16, 20), module=4, face_width=15, bore=(12, 12)).pinion,
    "spiral": lambda: gw.BevelPair(teeth=(16, 20), module=4, face_width=15, trace="logarithmic", spiral_angle=35).gear,
}


@pytest.mark.parametrize("name", ELEMENTS)
def test_to_first_order_the_volume_loses_the_area_times_half_the_clearance(name):
    body = ELEMENTS[name]().polyhedron(0.02)
    area = body.properties().extent.area
    clearance = 0.01
    lost = [body.properties().volume - with_clearance(body, c).properties().volume for c in (clearance, 2 * clearance)]
    # the second order is taken out by the two values
    slope = (4 * lost[0] - lost[1]) / (2 * clearance)
    assert slope == pytest.approx(area / 2, rel=2e-4)


@pytest.mark.parametrize("name", ELEMENTS)
def test_gears_keep_whole_at_a_printers_clearance(name):
    body = ELEMENTS[name]().polyhedron(0.02)
    moved = with_clearance(body, 0.2)
    assert moved.validity().valid
    assert not moved.self_intersections()
    assert moved.indices.tolist() == body.indices.tolist()


def test_gears_in_mesh_get_the_gap():
    """Without backlash they touch; sections of both are compared as polygons of shapely."""
    pair = gw.GearPair(kind="spur", teeth=(20, 30), module=2, face_width=10)
    gaps = []
    for clearance in (0.0, 0.2):
        outlines = []
        for part in pair.parts(tolerance=0.005):
            body = with_clearance(part.polyhedron, clearance).transformed(part.placement)
            bottom = body.vertices[:, 2].min()
            flat = np.flatnonzero([np.all(np.abs(body.vertices[f, 2] - bottom) < 1e-9) for f in np.asarray(body.faces)])
            triangles = shapely.polygons(body.vertices[np.asarray(body.faces)[flat]][..., :2])
            outlines.append(shapely.union_all(triangles))
        gaps.append(shapely.distance(*outlines))
    assert gaps[0] < 0.01
    assert gaps[1] - gaps[0] == pytest.approx(0.2, abs=4e-3)


def test_no_clearance_changes_nothing():
    body = Polyhedron(CORNERS, QUADS)
    assert with_clearance(body, 0.0) is body


@pytest.mark.parametrize("clearance", [-0.1, np.nan, np.inf])
def test_what_is_no_clearance_is_refused(clearance):
    with pytest.raises(GeometryError, match="a finite length from 0 is needed"):
        with_clearance(Polyhedron(CORNERS, QUADS), clearance)


def test_the_limit_is_where_a_face_turns_over():
    body = Polyhedron(CORNERS * [3, 1, 5], QUADS)
    assert with_clearance(body, 0.999).properties().volume == pytest.approx(2.001 * 0.001 * 4.001, rel=1e-9)
    for clearance in (1.0, 1.5, 10.0):
        with pytest.raises(GeometryError, match=r"turns over.*it must be less than 1;"):
            with_clearance(body, clearance)


def test_the_limit_is_found_where_walls_pass_through_each_other():
    """A void 0.2 from the side of a box: no face of either turns over when they pass."""
    void = CORNERS * [4.8, 3, 3] + [0.2, 3, 3]
    body = Polyhedron(np.concatenate([CORNERS * 9, void]), QUADS + [[k + 8 for k in face[::-1]] for face in QUADS])
    found = with_clearance(body, 0.19)
    assert found.properties().volume == pytest.approx(8.81**3 - 4.99 * 3.19**2, rel=1e-12)
    with pytest.raises(GeometryError, match=r"pass through each other; it must be less than 0\.(19|2)"):
        with_clearance(body, 0.5)


def test_smooth_faces_have_no_clearance(tmp_path):
    gear = gw.SpurGear(teeth=20, module=2, face_width=10)
    for save in (gear.save, gear.solid.save):
        with pytest.raises(FileError, match="backlash, tip clearance, smaller bores"):
            save(tmp_path / "gear.step", clearance=0.1)


def test_save_takes_a_clearance(tmp_path):
    gear = gw.SpurGear(teeth=20, module=2, face_width=10)
    pair = gw.GearPair(kind="spur", teeth=(20, 30), module=2, face_width=10)
    gear.save(tmp_path / "gear.ply", 0.05, clearance=0.2)
    gear.solid.save(tmp_path / "solid.ply", 0.05, clearance=0.2)
    pair.save(tmp_path / "pair", 0.05, clearance=0.2, suffix=".ply")
    for name in ("gear", "solid", "pair/pinion", "pair/gear"):
        assert np.ptp(Polyhedron.load(tmp_path / f"{name}.ply").vertices[:, 2]) == pytest.approx(9.8, abs=1e-12)
    pair.save(tmp_path / "pair.ply", 0.05, clearance=0.2)
    both = Polyhedron.load(tmp_path / "pair.ply").bodies()
    assert cKDTree(both[0].vertices).query(both[1].vertices)[0].min() > 0.19


def test_walls_that_pass_through_each_other_whole_are_refused(tmp_path):
    # no faces intersect any more then: the void is outside
    outline = [(35, -5), (45, -5), (45, 5), (35, 5)]
    hole = [(35.5, -4.5), (44.5, -4.5), (44.5, 4.5), (35.5, 4.5)]
    ring = gw.revolve(gw.Section.polygon(outline, holes=[hole]))
    ring.save(tmp_path / "ring.stl", 0.05, clearance=0.4)
    with pytest.raises(GeometryError, match=r"walls vanish.*it must be less than 0\.4\d"):
        ring.save(tmp_path / "ring.stl", 0.05, clearance=1.1)
    assert gw.Polyhedron.load(tmp_path / "ring.stl").validity().valid

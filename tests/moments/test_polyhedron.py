"""Polyhedral moments against exact rational arithmetic, wherever the body lies and however much cancels."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.errors import GeometryError
from gearwright.moments.bare import mass_properties
from gearwright.moments.faces import corner_lists
from gearwright.moments.indexed import bounding_box
from gearwright.moments.polyhedron import polyhedron_moments

from .bodies import cube, exact_moments, gear_like, joined, moved, prism, relative_errors, reversed_faces, star_shaped

PLACE = np.array([1.0, 0.7, -0.4])
BALL = star_shaped()
TRIANGULATED_GEAR = (gear_like()[0], [[f[0], f[k], f[k + 1]] for f in gear_like()[1] for k in range(1, len(f) - 1)])
BODIES = {
    "cube": cube(),
    "random star": BALL,
    "non-convex polygon faces": gear_like(),
    "the same in triangles": TRIANGULATED_GEAR,
    "with a hole": gear_like(hole=True),
}


def measured(body):
    return polyhedron_moments(body[0], *corner_lists(body[1]))


def errors(body):
    moments = measured(body)
    found = moments.body
    result = relative_errors(body, found.volume, found.centroid, found.central_second)
    assert max(result[0], result[2]) <= found.error_bound < 5e-14
    return result


@pytest.mark.parametrize("offset", [0.0, 1e3, 1e6, 1e8])
@pytest.mark.parametrize("name", BODIES)
def test_machine_precision_at_any_offset(name, offset):
    assert max(errors(moved(BODIES[name], offset * PLACE))) <= 1e-15


@pytest.mark.parametrize("distance", [3.0, 1e3, 1e6, 1e9, 1e12])
def test_two_bodies_far_apart(distance):
    assert max(errors(joined(BALL, moved(BALL, distance * PLACE)))) <= 1e-15


def test_twenty_seven_bodies_apart():
    places = [1e4 * np.array([x, y, z]) for x in (0, 1, 2) for y in (0, 1, 2) for z in (0, 1, 2)]
    small = star_shaped(3, 6)
    bodies = moved(small, places[0])
    for place in places[1:]:
        bodies = joined(bodies, moved(small, place))
    assert max(errors(bodies)) <= 1e-15


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.floats(-3, 3), st.floats(-9, 9), st.floats(0, 8))
def test_sheared_and_flattened_bodies_of_any_size_anywhere(seed, aspect, scale, offset):
    """Slivers across the axes, where not the terms but the products in them cancel."""
    random = np.random.default_rng(seed)
    vertices, faces = star_shaped(4, 7, seed % 100)
    shear = random.normal(size=(3, 3)) @ np.diag([1.0, 1.0, 10.0**aspect])
    if np.linalg.det(shear) < 0.0:
        shear = -shear
    size = 10.0**scale * np.abs(shear).max()
    body = vertices @ shear.T * 10.0**scale + random.normal(size=3) * size * 10.0**offset * (seed % 2), faces
    # far away the vertices are rounded: the body is the rounded one, which must still bound something
    if float(exact_moments(*body)[0]) > 1e-3 * abs(np.linalg.det(shear)) * 10.0 ** (3 * scale):
        assert max(errors(body)) <= 2e-15


@pytest.mark.parametrize("offset", [0.0, 1e3, 1e6])
@pytest.mark.parametrize("thickness", [1e-2, 1e-7, 1e-9])
def test_thin_shell(thickness, offset):
    outer = star_shaped(5, 8)
    shell = joined(moved(outer, offset * PLACE), reversed_faces(moved(outer, offset * PLACE, 1 - thickness)))
    assert max(errors(shell)) <= 1e-15


def test_heavy_end_on_a_long_needle():
    outer = star_shaped(5, 8)
    needle = (outer[0] * [100.0, 1e-3, 1e-3] + [100.0, 0.0, 0.0], outer[1])
    assert max(errors(joined(outer, needle))) <= 1e-15


@pytest.mark.parametrize("scale", [1e-30, 1e-9, 1e30])
def test_any_length_unit(scale):
    assert max(errors(moved(BALL, 0.0, scale))) <= 1e-15


@pytest.mark.parametrize("name", BODIES)
def test_area_closure_and_box(name):
    vertices, faces = BODIES[name]
    # a vertex that no face uses must not matter
    moments = measured((np.concatenate([vertices, [[1e9, 1e9, 1e9]]]), faces))
    areas = []
    for face in faces:
        p = vertices[face]
        areas.append(np.linalg.norm(sum(np.cross(p[k] - p[0], p[k + 1] - p[0]) for k in range(1, len(p) - 1))) / 2)
    assert moments.area == pytest.approx(sum(areas), rel=1e-14)
    assert moments.closure < 1e-15
    box = bounding_box(np.concatenate([vertices, [[1e9, 1e9, 1e9]]]), corner_lists(faces)[0])
    np.testing.assert_array_equal(box, [vertices.min(axis=0), vertices.max(axis=0)])


def test_an_open_boundary_shows_in_the_closure_residual():
    vertices, faces = cube()
    assert measured((vertices, faces[1:])).closure == pytest.approx(1 / 5)


@settings(max_examples=30, deadline=None)
@given(st.integers(3, 12), st.integers(0, 10**6), st.floats(0.1, 10))
def test_prisms_of_random_polygons(n, seed, height):
    random = np.random.default_rng(seed)
    angle = np.arange(n) * 2 * np.pi / n
    corners = random.uniform(0.2, 1, (n, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1) + random.normal(size=2)
    assert max(errors(prism(corners, height))) <= 2e-15


@pytest.mark.parametrize("seed", range(5))
def test_a_polygon_is_as_good_as_any_triangles_of_it(seed):
    """Faces that are not convex, whole and cut by a triangulation of their own."""
    random = np.random.default_rng(seed)
    angle = np.arange(40) * 2 * np.pi / 40
    corners = random.uniform(0.2, 1, (40, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    vertices, faces = prism(corners, 0.7)
    cut = shapely.constrained_delaunay_triangles(shapely.Polygon(corners))
    number = {tuple(corner): k for k, corner in enumerate(corners.tolist())}
    lids = [[number[p] for p in list(part.exterior.coords)[:3]] for part in cut.geoms]
    areas = [np.linalg.det(corners[lid[1:]] - corners[lid[0]]) for lid in lids]
    lids = [lid if area > 0 else lid[::-1] for lid, area in zip(lids, areas, strict=True)]
    assert len(lids) == 38
    triangles = [lid[::-1] for lid in lids] + [[40 + k for k in lid] for lid in lids]
    for face in faces[2:]:
        triangles += [face[:3], [face[0], *face[2:]]]
    whole, parts = measured((vertices, faces)), measured((vertices, triangles))
    assert whole.body.volume == pytest.approx(parts.body.volume, rel=1e-15)
    np.testing.assert_allclose(whole.body.centroid, parts.body.centroid, atol=1e-15)
    spread = np.abs(parts.body.central_second).max()
    np.testing.assert_allclose(whole.body.central_second, parts.body.central_second, atol=1e-15 * spread)
    assert whole.area == pytest.approx(parts.area, rel=1e-14)


def test_the_bare_function_gives_mass_centroid_and_inertia():
    vertices = moved(prism(np.array([[0.0, 0], [2, 0], [2, 3], [0, 3]]), 5.0), [7.0, 0, 0])
    mass, centroid, inertia = mass_properties(*vertices, density=2.0)
    assert mass == pytest.approx(60.0)
    np.testing.assert_allclose(centroid, [8.0, 1.5, 2.5])
    np.testing.assert_allclose(inertia, np.diag([5.0 * (9 + 25), 5.0 * (4 + 25), 5.0 * (4 + 9)]), atol=1e-13)


def test_the_bare_function_has_minus_the_products_off_the_diagonal():
    _, _, central = exact_moments(*BALL)
    _, _, inertia = mass_properties(*BALL)
    assert inertia[0, 1] == pytest.approx(-float(central[0][1]))


@pytest.mark.parametrize(
    ("vertices", "faces", "said"),
    [
        (*reversed_faces(cube()), "turned"),
        (cube()[0], cube()[1][1:], "closure residual 0.2"),
        (cube()[0], [[0, 1, 2], [0, 1, -1]], "vertex number -1 in face 1: vertex numbers go from 0 to 7"),
        (cube()[0], [[0, 1, 8]], "vertex number 8 in face 0"),
        (cube()[0], [[0, 1]], "at least 3"),
        (np.full((8, 3), np.nan), cube()[1], "vertex 0 = .nan, nan, nan.: coordinates must be finite"),
        (np.zeros((0, 3)), np.zeros((0, 3), int), "positive volume"),
    ],
)
def test_the_bare_function_refuses_what_bounds_nothing(vertices, faces, said):
    with pytest.raises(GeometryError, match=said):
        mass_properties(vertices, faces)

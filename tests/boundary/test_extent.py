"""Area and bounding box of boundaries."""

import numpy as np
import pytest

from gearwright.boundary.extent import bounding_box, rough_diagonal, surface_area
from gearwright.elements.cylindrical.spur_gear import SpurGear

from ..examples import PARTS, built, every_part, polyhedron, size
from .shapes import BOXES

AREAS = {
    "cube": 6.0,
    "cylinder": 20.0 * np.pi,
    "tube of twelve sectors": 12.0 * np.pi,
    "ring of square section": 20.0 * np.pi,
    "ball": 4.0 * np.pi,
    "torus": 12.0 * np.pi**2,
}
CORNERS = {
    "cube": ((0, 0, 0), (1, 1, 1)),
    "cylinder": ((-2, -2, 0), (2, 2, 3)),
    "ring of square section": ((-3, -3, 0), (3, 3, 1)),
    "quarter of a cone": ((0, 0, 0), (1, 1, 1)),
    "ball": ((-1, -1, -1), (1, 1, 1)),
    "torus": ((-4, -4, -1), (4, 4, 1)),
}


@pytest.mark.parametrize("name", AREAS)
def test_areas(name):
    assert surface_area(BOXES[name][0]()) == pytest.approx(AREAS[name], rel=1e-12)


@pytest.mark.parametrize("name", CORNERS)
def test_boxes(name):
    np.testing.assert_allclose(bounding_box(BOXES[name][0]()), CORNERS[name], atol=1e-9)


@every_part
def test_polyhedra_have_nearly_the_same(part):
    """Corners lie on the surface: within the box, and a chord's depth from its sides at most."""
    box, body = bounding_box(built(part).boundary), polyhedron(part, 1e-4)
    low, high = body.vertices.min(axis=0), body.vertices.max(axis=0)
    slack = 1e-9 * size(part)
    assert np.all(low >= box[0] - slack)
    assert np.all(high <= box[1] + slack)
    np.testing.assert_allclose([low, high], box, atol=2e-3 * size(part))
    a, b, c = np.moveaxis(body.vertices[np.asarray(body.faces)], 1, 0)
    area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2.0
    assert area == pytest.approx(surface_area(built(part).boundary), rel=2e-3)


@every_part
def test_the_diagonal_is_about_that_of_the_box(part):
    exact = float(np.linalg.norm(np.diff(bounding_box(built(part).boundary), axis=0)))
    assert 0.95 * exact < rough_diagonal(built(part).boundary) <= exact * (1.0 + 1e-12)


def _is_widest_on_edges(part):
    leaning = getattr(built(part), "ends", "") == "spherical" and built(part).sizes()["face_angle"].value >= 90.0
    return not leaning


@pytest.mark.parametrize("part", [part for part in PARTS if _is_widest_on_edges(part)], ids=str)
def test_the_box_is_that_of_a_dense_cloud(part):
    """Points all along the edges of every image, and the poles inside the end faces.

    Crown gears, whose end faces reach beyond 90°, are widest inside them.
    """
    boundary = built(part).boundary
    fractions = np.linspace(0.0, 1.0, 1201 if len(boundary.patches) > 10 else 30_001)  # springs have many windings
    clouds = [edge.pattern.images(edge.curve.point(edge.curve.parameter(fractions))) for edge in boundary.edges]
    poles = [cap.surface.point(np.zeros((1, 2))) for cap in boundary.caps if len(cap.loops) == 1]
    points = np.concatenate([cloud.reshape(-1, 3) for cloud in (*clouds, *poles)])
    box = bounding_box(boundary)
    np.testing.assert_allclose([points.min(axis=0), points.max(axis=0)], box, atol=1e-6 * size(part))


def test_a_crown_gear_is_widest_inside_its_end_face():
    part = next(p for p in PARTS if p.example == "crown")
    assert bounding_box(built(part).boundary)[1, 0] == pytest.approx(built(part).cone_distance, rel=1e-15)


def test_the_widest_place_is_found_between_samples():
    """A tooth at 72° so wide that its tip reaches over 90°, at no fraction that a grid would hit."""
    gear = SpurGear(teeth=5, module=4.0, face_width=3.0, circular_thickness=7.0, addendum=0.3, dedendum=1.5)
    radius = 10.3
    box = bounding_box(gear.boundary)
    assert box[1, 1] == pytest.approx(radius, rel=1e-12)
    assert box[0, 1] == pytest.approx(-radius, rel=1e-12)
    assert box[0, 0] > -radius

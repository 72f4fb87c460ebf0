"""Distance from the true surface of a body, with its sign."""

import numpy as np
import pytest

from gearwright.boundary.nearness import Skin
from gearwright.boundary.placed import placed_boundary
from gearwright.placement import Placement

from .shapes import HALF_DISC, SQUARE, circle, extruded, revolved

LEANING = Placement.of([[0.48, 0.64, 0.6], [-0.8, 0.6, 0.0], [-0.36, -0.48, 0.8]], (0.7, -1.9, 3.1))
DIRECTIONS = np.array([[1.0, 2.0, -0.5], [-0.3, 0.2, 0.9], [0.1, -1.0, 0.4]])
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=1)[:, None]


@pytest.mark.parametrize("off", [-0.3, -1e-7, 1e-7, 0.4])
def test_of_a_ball(off):
    ball = Skin.of(placed_boundary(revolved(HALF_DISC), LEANING))
    found = ball.signed_distance(LEANING.points((1.0 + off) * DIRECTIONS), 1e-5)
    np.testing.assert_allclose(found, off, rtol=1e-7)


@pytest.mark.parametrize("off", [-0.3, -1e-7, 1e-7, 0.4])
def test_of_the_wall_and_the_ends_of_a_bar_with_a_pattern(off):
    bar = Skin.of(extruded(circle(2.0, pieces=12), height=3.0))
    points = np.array(
        [[(2.0 + off) * np.cos(1.0), (2.0 + off) * np.sin(1.0), 1.4], [0.1, 0.2, 3.0 + off], [0.3, -0.5, -off]]
    )
    np.testing.assert_allclose(bar.signed_distance(points, 1e-5), off, rtol=1e-7)


def test_of_an_edge_from_outside():
    cube = Skin.of(extruded(SQUARE))
    assert cube.signed_distance(np.array([[1.3, 1.4, 0.5]]), 1e-5)[0] == pytest.approx(0.5)


def test_nearest_places_lie_between_samples():
    bar, other = Skin.of(extruded(circle(2.0), height=3.0)), Skin.of(extruded(circle(1.0), height=3.0))
    angle = 1.0
    shifted = Skin.of(
        placed_boundary(other.boundary, Placement.of(np.eye(3), (3.2 * np.cos(angle), 3.2 * np.sin(angle), 0.5)))
    )
    places, distances = bar.nearest_to(shifted, np.arange(len(bar.points)), 1e-5)
    assert distances[0] == pytest.approx(0.2, abs=1e-8)
    np.testing.assert_allclose(places[0, :2], [2.0 * np.cos(angle), 2.0 * np.sin(angle)], atol=1e-3)

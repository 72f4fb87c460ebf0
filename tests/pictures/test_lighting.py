import numpy as np
import pytest

from gearwright.pictures.lighting import illumination, metal, settled, studio

from .shapes import cube, sphere

UP = np.array([0.0, 0.0, 1.0])


def lit(points, normals, body):
    places = np.column_stack([np.arange(len(points)) % 7, np.arange(len(points)) % 5])
    return illumination(np.asarray(points, float), np.asarray(normals, float), places, *body, studio(UP))


def test_a_convex_body_does_not_shade_itself():
    vertices, triangles = sphere(radius=0.9, rings=48)
    light = lit(vertices, vertices / 0.9, (vertices, triangles))
    assert light[:, :2].sum(axis=1) == pytest.approx(light[:, 2:].sum(axis=1), rel=0.02)


def test_light_comes_mostly_from_above():
    body = sphere(radius=0.01, rings=4)
    above, below = lit([[0.5, 0.0, 0.0]] * 2, [UP, -UP], body)
    assert above[:2].sum() > 2.0 * below[:2].sum() > 0.0


def test_under_a_block_it_is_dark_and_beside_it_half_dark():
    body = cube(side=0.8, middle=(0.0, 0.0, 0.44))
    under, beside, far = lit([[0, 0, 0], [0.44, 0, 0], [0.98, 0.0, 0.0]], [UP] * 3, body)
    shares = [light[:2].sum() / light[2:].sum() for light in (under, beside, far)]
    assert shares[0] < 0.05
    assert shares[0] < shares[1] < shares[2]
    assert 0.15 < shares[1] < 0.85


def test_settling_averages_a_surface_but_not_across_an_edge():
    rows, columns = (index.ravel() for index in np.indices((10, 10)))
    places = np.column_stack([rows, columns])
    points = np.column_stack([columns, -rows, np.zeros(100)]).astype(float)
    normals = np.where((columns < 5)[:, None], UP, np.array([0.6, 0.0, 0.8]))
    light = np.where(columns < 5, (columns + rows) % 2, 10.0)[:, None] * np.ones(4)
    mean = settled(light, points, normals, places, np.arange(101), 10, 1.0)
    assert mean[columns >= 5] == pytest.approx(10.0)
    assert np.abs(mean[columns < 5] - 0.5).max() < 0.1


def test_metal_is_as_warm_as_its_colour_and_darker_in_a_recess():
    normals = np.broadcast_to(UP, (2, 3))
    towards_eye = np.array([[0.0, 0.6, 0.8]] * 2)
    light = np.array([[1.0, 1.0, 1.0, 1.0], [0.1, 0.2, 1.0, 1.0]])
    open_face, recess = metal(normals, towards_eye, light, np.array([[0.6, 0.4, 0.1]] * 2), UP)
    assert open_face[0] > open_face[1] > open_face[2]
    assert (recess < 0.3 * open_face).all()

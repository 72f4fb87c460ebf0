import numpy as np
import pytest

from gearwright.pictures.facets import facets

from .shapes import cube, sphere


def test_a_sphere_is_smooth():
    vertices, triangles = sphere(rings=24)
    made = facets([(vertices, triangles)])
    corners = made.vertices[made.triangles]
    outward = corners / np.linalg.norm(corners, axis=-1, keepdims=True)
    assert np.sum(made.normals * outward, axis=-1).min() > np.cos(np.radians(1.0))


def test_a_cube_is_crisp():
    made = facets([cube()])
    assert np.sort(np.abs(made.normals), axis=-1) == pytest.approx(np.broadcast_to([0.0, 0.0, 1.0], (12, 3, 3)))


@pytest.mark.parametrize(("angle", "smooth"), [(27.0, True), (29.0, False)])
def test_the_crease_angle_decides(angle, smooth):
    bend = np.radians(angle)
    vertices = np.array([[-1, 0, 0], [0, 0, 0], [0, 1, 0], [np.cos(bend), 0, -np.sin(bend)]])
    made = facets([(vertices, np.array([[0, 1, 2], [2, 1, 3]]))])
    first, second = made.normals
    # the corners at the ends of the common edge
    assert np.allclose(first[1], second[1]) == smooth
    assert np.allclose(first[0], [0, 0, 1])


def test_a_soup_of_triangles_is_as_smooth_as_its_polyhedron():
    vertices, triangles = sphere(rings=12)
    soup = vertices[triangles].reshape(-1, 3)
    made = facets([(vertices, triangles)])
    from_soup = facets([(soup, np.arange(len(soup)).reshape(-1, 3))])
    assert from_soup.normals == pytest.approx(made.normals, abs=1e-9)


def test_triangles_without_area_are_dropped_and_bodies_kept_apart():
    vertices, triangles = cube()
    flat = np.array([[0, 0, 1], [0, 1, 1], [2, 2, 2]])
    made = facets([(vertices, np.vstack([triangles, flat])), cube(middle=(3.0, 0.0, 0.0))])
    assert np.bincount(made.members).tolist() == [12, 12]
    assert np.isfinite(made.normals).all()
    assert made.vertices[made.triangles[made.members == 1]][..., 0].min() == 2.5

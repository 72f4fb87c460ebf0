import numpy as np
import pytest
from scipy.ndimage import binary_dilation, binary_erosion

from gearwright.pictures.camera import View, camera
from gearwright.pictures.colours import gamma, linear
from gearwright.pictures.image import image

from .shapes import cube, sphere

WHITE = np.ones(3)
GREY = np.array([[0.6, 0.6, 0.6], [0.8, 0.6, 0.3]])
FROM_ABOVE = View(direction=(0.0, -1.0, 0.8), perspective=0.0)
FROM_BELOW = View(direction=(0.0, -1.0, -0.3), perspective=0.0)


def seen(bodies, view, size=(240, 200)):
    points = np.concatenate([vertices for vertices, _ in bodies])
    eye = camera(points, view, (40.0, 40.0, size[0] - 40.0, size[1] - 40.0))
    return image(bodies, GREY[: len(bodies)], eye, size, WHITE)


@pytest.fixture(scope="module")
def ball():
    return seen([sphere(rings=64)], FROM_BELOW)


def test_the_silhouette_of_a_sphere_has_the_area_of_its_disk(ball):
    assert (ball.owners == 0).sum() == pytest.approx(np.pi * 60.0**2, rel=0.004)


def test_the_background_stays_as_it_was(ball):
    far = ~binary_dilation(ball.owners == 0, iterations=4)
    assert ball.colours[far].min() > 1.0 - 1e-12


def test_a_smooth_sphere_is_shaded_smoothly(ball):
    inner = binary_erosion(ball.owners == 0, iterations=4)
    grey = ball.colours.mean(axis=-1)
    for axis in (0, 1):
        both = inner & np.roll(inner, 1, axis=axis)
        assert np.abs(grey - np.roll(grey, 1, axis=axis))[both].max() < 0.05
    assert np.ptp(grey[inner]) > 0.2  # yet it is no flat disk


def test_edges_of_a_cube_are_drawn_and_its_faces_differ():
    cubed = seen([cube()], View(direction=(1.0, -1.0, 0.9), perspective=0.0))
    grey = cubed.colours.mean(axis=-1)
    row, middle = 130, 120  # below the near top corner runs an edge, left and right of it a face each
    left, right = grey[row, middle - 12], grey[row, middle + 12]
    assert abs(left - right) > 0.04
    assert grey[row, middle - 1 : middle + 2].min() < min(left, right) - 0.02


def test_the_nearer_body_hides_the_farther_one_whichever_comes_first():
    near, far = cube(middle=(0.0, -2.0, 0.0)), cube(middle=(0.0, 0.0, 0.0))
    straight = View(direction=(0.0, -1.0, 0.0), perspective=0.0)
    for bodies, front in (([near, far], 0), ([far, near], 1)):
        owners = seen(bodies, straight).owners
        assert set(np.unique(owners)) == {-1, front}


def test_a_shadow_falls_on_the_ground_under_the_body_and_fades():
    shaded = seen([sphere(rings=32)], FROM_ABOVE, size=(400, 300))
    background = ~binary_dilation(shaded.owners == 0, iterations=4)
    grey = np.where(background, shaded.colours.mean(axis=-1), 1.0)
    assert grey[:, 150:].min() < 0.85
    assert grey.max() > 1.0 - 1e-12
    assert grey[:20].min() > 0.95


def test_a_recess_is_darker_than_the_open_face():
    floor = (np.array([[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]]))
    top = View(direction=(0.0, 0.0, 1.0), perspective=0.0)
    walls = [cube(middle=(x, 0.0, 0.5)) for x in (-0.7, 0.7)]
    bodies = np.concatenate([floor[0], *(v for v, _ in walls)])
    triangles = np.concatenate([floor[1], walls[0][1] + 4, walls[1][1] + 12])
    grey = seen([(bodies, triangles)], top, size=(240, 240)).colours.mean(axis=-1)
    between, beside = grey[120, 120], grey[60, 60]
    assert between < 0.75 * beside


def test_pictures_are_the_same_each_time():
    first, second = (seen([cube()], FROM_ABOVE) for _ in range(2))
    assert np.array_equal(first.colours, second.colours)


def test_colours_survive_the_way_to_intensities_and_back():
    values = np.linspace(0.0, 1.0, 101)
    assert gamma(linear(values)) == pytest.approx(values)
    assert linear(np.array([0.5]))[0] == pytest.approx(0.21404, abs=1e-5)

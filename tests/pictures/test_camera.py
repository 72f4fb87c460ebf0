import numpy as np
import pytest

from gearwright.pictures.camera import View, camera, suitable_view

from .shapes import cone, crown, cube, sphere

FRAME = (100.0, 50.0, 700.0, 450.0)


@pytest.mark.parametrize("perspective", [0.0, 0.2])
def test_the_bodies_just_fill_the_frame(perspective):
    points = cube(side=30.0, middle=(5.0, 6.0, 7.0))[0]
    eye = camera(points, View(direction=(1.0, 2.0, 1.5), perspective=perspective), FRAME)
    screen = eye.screen(eye.seen(points))
    (left, top), (right, bottom) = screen[:, :2].min(axis=0), screen[:, :2].max(axis=0)
    assert left >= FRAME[0] - 1e-9
    assert right <= FRAME[2] + 1e-9
    assert (top, bottom) == pytest.approx((50.0, 450.0))
    assert (left + right) / 2 == pytest.approx(400.0)


def test_what_is_nearer_and_higher_is_so_on_the_screen():
    points = cube()[0]
    eye = camera(points, View(direction=(0.0, -1.0, 0.0)), FRAME)
    nearer, farther, above, right = eye.screen(eye.seen(np.array([[0, -1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0.0]])))
    assert nearer[2] > farther[2]
    assert above[1] < nearer[1]
    assert right[0] > nearer[0]


def test_perspective_keeps_lines_straight_in_depth_too():
    eye = camera(cube()[0], View(direction=(1.0, 1.0, 1.0), perspective=0.3), FRAME)
    ends = np.array([[-0.4, 0.2, 0.3], [0.5, -0.1, -0.2]])
    line = ends[0] + np.linspace(0.0, 1.0, 7)[:, None] * (ends[1] - ends[0])
    screen = eye.screen(eye.seen(line))
    assert np.linalg.matrix_rank(screen - screen[0], tol=1e-9) == 1


def test_screen_points_lead_back():
    eye = camera(cube()[0], View(direction=(1.0, 0.5, 1.0), perspective=0.25), FRAME)
    seen = np.random.default_rng(1).uniform(-1.0, 1.0, (20, 3))
    assert eye.unscreen(eye.screen(seen)) == pytest.approx(seen)


def test_looking_straight_along_up_is_possible():
    eye = camera(cube()[0], View(direction=(0.0, 0.0, 2.0), up=(0.0, 0.0, 1.0)), FRAME)
    assert eye.rotation @ eye.rotation.T == pytest.approx(np.eye(3))
    assert eye.rotation[1] == pytest.approx([0.0, 1.0, 0.0])


@pytest.mark.parametrize(("gear", "pinion"), [((0, 0, 4), (5, 0, 0)), ((0, -4, 0), (0, 0, -5)), ((3, 0, 0), (2, 5, 0))])
def test_of_two_cones_that_share_an_apex_the_larger_lies_and_both_are_seen_from_their_apex(gear, pinion):
    apex = np.zeros(3)
    view = suitable_view([cone(apex, pinion, 3.0), cone(apex, gear, 5.5)])
    up, direction = np.asarray(view.up), np.asarray(view.direction)
    assert up == pytest.approx(-np.asarray(gear) / np.linalg.norm(gear), abs=1e-6)
    assert direction @ gear < 0.0
    assert direction @ pinion < 0.0


def test_a_single_cone_is_seen_with_its_apex_up():
    view = suitable_view([cone((1.0, 1.0, 1.0), (1.0, 1.0, 3.0), 2.5)])
    assert view.up == pytest.approx((0.0, 0.0, -1.0), abs=1e-6)


def test_a_single_toothed_body_lies_with_its_teeth_up():
    vertices, triangles = crown()
    assert suitable_view([(vertices, triangles)]).up == pytest.approx((0.0, 0.0, -1.0), abs=1e-3)
    assert suitable_view([(-vertices, triangles)]).up == pytest.approx((0.0, 0.0, 1.0), abs=1e-3)


def test_a_body_that_is_not_round_is_seen_from_above():
    vertices, triangles = cube()
    view = suitable_view([(vertices * (1.0, 2.0, 3.5), triangles)])
    assert view.up == (0.0, 0.0, 1.0)
    assert view.direction[2] > 0.0


def test_bodies_apart_or_alone_always_have_a_view():
    for bodies in ([sphere(rings=6)], [sphere(rings=6), cube(middle=(4.0, 1.0, 0.0))], [cube()] * 3):
        assert np.isfinite(suitable_view(bodies).direction).all()


@pytest.mark.parametrize(
    ("parameters", "text"),
    [
        ({"direction": (0.0, 0.0, 0.0)}, "direction"),
        ({"direction": (0.0, 0.0, float("nan"))}, "direction"),
        ({"direction": (1.0, 0.0, 0.0), "up": (0.0, 0.0, 0.0)}, "up"),
        ({"direction": (1.0, 0.0, 0.0), "perspective": 0.9}, "perspective"),
    ],
)
def test_impossible_views_are_refused(parameters, text):
    with pytest.raises(ValueError, match=text):
        View(**parameters)

"""Frames along paths: orthonormal, their rates, no spin, double reflection's limit, closing; what is refused."""

import numpy as np
import pytest

from gearwright.curves.frames import FRAMES, fixed_up, frenet, rotation_minimising
from gearwright.curves.helix import helix
from gearwright.curves.path import path_of, path_through
from gearwright.errors import GeometryError

TURN = 2.0 * np.pi


def knot_point(u):
    k = TURN * np.asarray(u)
    return np.stack(
        [(4 + 2 * np.cos(3 * k)) * np.cos(2 * k), (4 + 2 * np.cos(3 * k)) * np.sin(2 * k), 2 * np.sin(3 * k)], axis=-1
    )


PATHS = {
    "helix": lambda: helix(3.0, 2.0, 2.3),
    "left helix": lambda: helix(3.0, 2.0, 2.3, "left"),
    "knot": lambda: path_of(knot_point),
    "spline knot": lambda: path_through(knot_point(np.linspace(0.0, 1.0, 61))),
    "spline": lambda: path_through([(0, 0, 0), (8, 1, 3), (15, 7, 1), (18, 16, 5)]),
}
CASES = [(path, frame) for path in PATHS for frame in FRAMES if (path, frame) != ("spline", "frenet")]
every_case = pytest.mark.parametrize(("path", "frame"), CASES)
U = np.random.default_rng(3).uniform(0.002, 0.998, 60)


@every_case
def test_the_axes_are_orthonormal_and_right_handed(path, frame):
    found = FRAMES[frame](PATHS[path]())
    rotation = np.concatenate([found.across(U), found.path.tangent(U)[..., None]], axis=-1)
    np.testing.assert_allclose(
        np.swapaxes(rotation, 1, 2) @ rotation, np.broadcast_to(np.eye(3), (60, 3, 3)), atol=1e-14
    )
    np.testing.assert_allclose(np.linalg.det(rotation), 1.0, atol=1e-14)


@every_case
def test_the_rates_are_the_differences_of_the_axes(path, frame):
    found = FRAMES[frame](PATHS[path]())
    h = 2e-5
    near, far = (found.across(U + k * h) - found.across(U - k * h) for k in (1, 2))
    numeric = (8.0 * near - far) / (12.0 * h)
    rates = found.across_rate(U)
    if path == "spline knot":  # at knots the third derivative jumps
        good = np.min(np.abs(U[:, None] - found.path.series.breaks), axis=1) > 3.0 * h
        numeric, rates = numeric[good], rates[good]
    np.testing.assert_allclose(rates, numeric, atol=1e-7 * np.max(np.abs(rates)))


@pytest.mark.parametrize("path", PATHS)
def test_a_rotation_minimising_frame_does_not_spin_but_to_close(path):
    found = rotation_minimising(PATHS[path]())
    spin = np.sum(found.across_rate(U)[..., 0] * found.across(U)[..., 1], axis=-1)
    speeds = np.linalg.norm(found.path.derivative(U), axis=-1)
    if found.path.closed:  # evenly along the length
        np.testing.assert_allclose(spin / speeds, spin[0] / speeds[0], rtol=1e-10)
        np.testing.assert_allclose(found.across(1.0), found.across(0.0), atol=1e-12)
        assert abs(spin[0] / speeds[0]) * found.path.length <= np.pi
    else:
        np.testing.assert_allclose(spin, 0.0, atol=1e-13 * speeds.max())


def double_reflection(path, steps, start):
    """e₁ at the end, by two reflections a step: W. Wang et al., ACM Trans. Graph. 27 (2008), table I."""
    u = np.linspace(0.0, 1.0, steps + 1)
    points, tangents, axis = path.point(u), path.tangent(u), start
    for i in range(steps):
        chord = points[i + 1] - points[i]
        reflected = axis - 2.0 / (chord @ chord) * (chord @ axis) * chord
        tangent = tangents[i] - 2.0 / (chord @ chord) * (chord @ tangents[i]) * chord
        second = tangents[i + 1] - tangent
        axis = reflected - 2.0 / (second @ second) * (second @ reflected) * second
    return axis


def test_double_reflection_converges_to_the_rotation_minimising_frame_with_its_fourth_order():
    path = path_of(lambda u: np.stack([3 * np.cos(7 * u), 2 * np.sin(7 * u), 2 * u + np.sin(3 * u)], axis=-1))
    found = rotation_minimising(path)
    misses = [
        np.linalg.norm(double_reflection(path, n, found.across(0.0)[:, 0]) - found.across(1.0)[:, 0])
        for n in (100, 200, 400)
    ]
    assert misses[2] < 2e-10
    np.testing.assert_allclose(np.log2(np.divide(misses[:-1], misses[1:])), 4.0, atol=0.2)


def test_section_y_starts_as_near_as_possible_to_z_else_to_x():
    flat = rotation_minimising(path_through([(0, 0, 0), (5, 0, 0)])).across(0.5)
    np.testing.assert_allclose(flat, [[0, 0], [1, 0], [0, 1]], atol=1e-15)
    upright = rotation_minimising(path_through([(0, 0, 0), (0, 0, 5)])).across(0.5)
    np.testing.assert_allclose(upright[:, 1], [1, 0, 0], atol=1e-15)
    slanting = rotation_minimising(helix(3.0, 2.0)).across(0.0)[:, 1]
    assert slanting @ [0, 0, 1] > 0.99


def test_a_frenet_frame_points_to_the_centre_of_curvature():
    path = helix(3.0, 2.0, 1.4)
    axes = frenet(path).across(U)
    outward = path.point(U) * [1.0, 1.0, 0.0] / 3.0
    np.testing.assert_allclose(axes[..., 0], -outward, atol=1e-11)


def test_a_fixed_up_frame_keeps_section_x_level():
    axes = fixed_up(PATHS["spline"]()).across(U)
    np.testing.assert_allclose(axes[:, 2, 0], 0.0, atol=1e-13)
    assert np.all(axes[:, 2, 1] > 0.5)


@pytest.mark.parametrize(
    ("frame", "path", "words"),
    [
        (frenet, lambda: path_through([(0, 0, 0), (1, 2, 3)]), "is straight there"),
        (frenet, lambda: path_of(lambda u: np.stack([u, (u - 0.4) ** 3, 0 * u], axis=-1)), "is straight there"),
        (fixed_up, lambda: path_through([(0, 0, 0), (0, 0, 3)]), "runs along z there"),
        (fixed_up, lambda: path_of(lambda u: np.stack([np.cos(4 * u), 0 * u, np.sin(4 * u)], axis=-1)), "along z"),
    ],
)
def test_a_frame_that_is_not_defined_is_refused_with_the_place(frame, path, words):
    with pytest.raises(GeometryError, match=words):
        frame(path())

"""Paths: points, functions, lengths, closedness; corners, standstills and nonsense refused with the place."""

import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.curves.helix import helix
from gearwright.curves.path import path_of, path_through

TURN = 2.0 * np.pi


def test_a_spline_path_runs_through_its_points():
    points = np.random.default_rng(2).normal(size=(9, 3)) + 3.0 * np.arange(9)[:, None]
    path = path_through(points)
    np.testing.assert_allclose(path.point(path.series.breaks), points, atol=1e-13)
    assert not path.closed


def test_two_points_make_a_line_and_three_a_parabola():
    line = path_through([(1, 2, 3), (4, 6, 3)])
    assert line.length == pytest.approx(5.0, rel=1e-15)
    np.testing.assert_allclose(line.point(0.25), [1.75, 3.0, 3.0], rtol=1e-15)
    bend = path_through([(0, 0, 0), (1, 1, 0), (2, 0, 0)])
    np.testing.assert_allclose(bend.second_derivative([0.1, 0.9]), bend.second_derivative([0.5, 0.5]), atol=1e-12)


def test_closed_where_the_ends_meet():
    angles = np.linspace(0.0, TURN, 41)
    ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)
    path = path_through(ring)
    assert path.closed
    np.testing.assert_allclose(path.tangent(1.0), path.tangent(0.0), atol=1e-13)
    assert path.length == pytest.approx(TURN, rel=1e-5)
    assert not path_through(ring[:-1]).closed


def test_length_is_the_arc_length():
    path = helix(3.0, 2.0, 1.5)
    assert path.length == pytest.approx(1.5 * np.hypot(TURN * 3.0, 2.0), rel=1e-14)
    np.testing.assert_allclose(path.length_to.value([0.0, 0.25, 1.0])[:, 0] / path.length, [0.0, 0.25, 1.0], atol=1e-14)


def test_a_function_of_one_number_serves_as_well():
    one = path_of(lambda u: [math.cos(u), math.sin(u), u])
    many = path_of(lambda u: np.stack([np.cos(u), np.sin(u), u], axis=-1))
    np.testing.assert_allclose(one.point([0.2, 0.7]), many.point([0.2, 0.7]), atol=1e-15)


def test_tangent_rate_is_the_curvature_times_the_speed():
    path = helix(3.0, 2.0, 1.0)
    pitch = 2.0 / TURN
    curvature = 3.0 / (3.0**2 + pitch**2)
    bend = np.linalg.norm(path.tangent_rate([0.1, 0.6]), axis=-1)
    np.testing.assert_allclose(bend / path.length, curvature, rtol=1e-10)


@pytest.mark.parametrize("hand", ["right", "left"])
def test_a_helix_climbs_its_pitch_each_turn_on_its_hand(hand):
    path = helix(3.0, 2.0, 2.25, hand)
    np.testing.assert_allclose(path.point(0.0), [3.0, 0.0, 0.0], atol=1e-15)
    sign = 1.0 if hand == "right" else -1.0
    np.testing.assert_allclose(path.point(1.0), [0.0, 3.0 * sign, 4.5], atol=1e-13)


@pytest.mark.parametrize(("pitch", "turns"), [(1.0, 400.0), (1e-3, 200.0), (50.0, 1000.0)])
def test_a_helix_of_many_turns_is_smooth(pitch, turns):
    path = helix(3.0, pitch, turns)
    assert path.length == pytest.approx(turns * np.hypot(TURN * 3.0, pitch), rel=1e-12)
    assert path.series.kinks == ()


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (lambda: path_through([]), "at least two points"),
        (lambda: path_through([(0, 0, 0)]), "at least two points"),
        (lambda: path_through([(0, 0), (1, 1)]), r"shape \(2, 2\)"),
        (lambda: path_through("abc"), "an array"),
        (lambda: path_through([(0, 0, 0), (1, float("nan"), 2)]), "point 1"),
        (lambda: path_through([(0, 0, 0), (1, 0, 0), (1, 0, 0), (2, 0, 0)]), r"points 1 and 2 at \[1.0, 0.0, 0.0\]"),
        (lambda: path_of(lambda u: np.stack([u, abs(u - 0.4), 0 * u], axis=-1)), "u = 0.4 .* a corner of 90°"),
        (
            lambda: path_of(lambda u: np.stack([(u - 0.5) ** 2, (u - 0.5) ** 3, 0 * u], axis=-1)),
            "u = 0.5 .* stands still",
        ),
        (lambda: path_of(lambda u: np.zeros((*np.shape(u), 3))), "stays where it is"),
        (lambda: path_of(lambda u: [1.0, 2.0, 3.0]), "stays where it is"),
        (lambda: path_of(lambda u: np.stack([10 * (u - 0.3) ** 2, 0 * u, 0 * u], -1)), "u = 0.3 .* turns back"),
        (lambda: path_of(lambda u: np.stack([(u - 0.3) ** 3, 0 * u, 0 * u], -1)), "u = 0.3 .* stands still"),
        (lambda: path_through([(0, 0, 0), (10, 0, 0), (3, 0, 0)]), "turns back"),
        (lambda: path_of(lambda u: [u, 0.0] if u > 0.9 else [u, 0.0, 0.0]), r"points \(n, 3\)"),
        (lambda: path_of(lambda u: [math.sqrt(0.9 - u), u, 0.0]), "ValueError: math domain error"),
        (lambda: path_of(lambda u: u), r"points \(n, 3\)"),
        (lambda: path_of(lambda u: 1 / 0), "ZeroDivisionError"),
        (
            lambda: path_of(lambda u: np.stack([np.cos(TURN * u) * (1 + u * (1 - u)), np.sin(TURN * u), 0 * u], -1)),
            "corner",
        ),
        (lambda: helix(0.0, -1.0, 1.0, "up"), "hand = 'up'"),
        (lambda: helix(1.0, 0.0, 2.0), "would run into the first"),
        (lambda: helix(float("nan"), 1.0), "finite"),
    ],
)
def test_what_is_no_path_is_refused(build, words):
    with pytest.raises(gw.GearwrightError, match=words):
        build()

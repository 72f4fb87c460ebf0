"""Sections from corners, points and curves: what they enclose, and what is refused and where."""

from fractions import Fraction
from itertools import pairwise
from math import comb

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gearwright as gw
from gearwright.curves.arc import Arc
from gearwright.curves.involute import Involute
from gearwright.curves.line import Line

SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
HOLE = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0)]


def rational_moments(*loops):
    """∫ x^a y^b dA of polygons, outer first, to the last digit: edges integrated term by term."""
    total = {}
    for number, loop in enumerate(loops):
        points = [(Fraction(x), Fraction(y)) for x, y in loop]
        edges = list(zip(points, [*points[1:], points[0]], strict=True))
        sense = 1 if sum(a[0] * b[1] - b[0] * a[1] for a, b in edges) > 0 else -1
        for a in range(4):
            for b in range(4 - a):
                value = sum(
                    (x * v - u * y)
                    * comb(a, i)
                    * comb(b, j)
                    * x ** (a - i)
                    * (u - x) ** i
                    * y ** (b - j)
                    * (v - y) ** j
                    / Fraction(i + j + 1)
                    for (x, y), (u, v) in edges
                    for i in range(a + 1)
                    for j in range(b + 1)
                )
                signed = value * sense * (1 if number == 0 else -1) / (a + b + 2)
                total[a, b] = total.get((a, b), 0) + signed
    return total


def star(random, corners, inner=1.0, outer=3.0, centre=(0.0, 0.0)):
    """A polygon around a point, star-shaped about it."""
    angles = np.sort(random.uniform(0.0, 2.0 * np.pi, corners)) + np.arange(corners) * 1e-3
    radii = random.uniform(inner, outer, corners)
    return np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=-1) + centre


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**6), corners=st.integers(9, 40), offset=st.sampled_from([0.0, 3.0, 50.0]))
def test_a_polygon_with_a_hole_has_the_moments_of_exact_arithmetic(seed, corners, offset):
    random = np.random.default_rng(seed)
    base = np.stack(
        [np.cos(np.arange(corners) * 2 * np.pi / corners), np.sin(np.arange(corners) * 2 * np.pi / corners)]
    )
    outer = base.T * random.uniform(2.0, 3.0, corners)[:, None] + offset
    hole = base.T * random.uniform(0.5, 1.0, corners)[:, None] + offset
    found = gw.Section.polygon(outer, holes=[hole[::-1] if seed % 2 else hole]).properties()
    exact = rational_moments(outer.tolist(), hole.tolist())
    for (a, b), value in exact.items():
        scale = float(exact[0, 0]) * (3.0 + offset) ** (a + b)
        assert abs(float(Fraction(float(found.moments[a, b])) - value)) <= 2e-15 * scale
    assert found.error_bound < 1e-14 * max(1.0, offset)  # coordinates far off are rounded


def test_either_sense_and_a_repeated_first_corner_are_the_same_polygon():
    plain = gw.Section.polygon(SQUARE, holes=[HOLE]).properties().moments
    for outline, hole in ((SQUARE[::-1], HOLE), (SQUARE, HOLE[::-1]), ([*SQUARE, SQUARE[0]], [*HOLE, HOLE[0]])):
        np.testing.assert_allclose(gw.Section.polygon(outline, holes=[hole]).properties().moments, plain, rtol=1e-14)


def test_properties_of_a_rectangle_are_the_textbook_s():
    found = gw.Section.rectangle(6.0, 2.0, centre=(1.0, -4.0)).properties()
    assert found.area == pytest.approx(12.0, rel=1e-15)
    assert found.perimeter == pytest.approx(16.0, rel=1e-15)
    np.testing.assert_allclose(found.centroid, [1.0, -4.0], rtol=1e-15)
    np.testing.assert_allclose(found.central_second_moments, [6 * 2**3 / 12, 2 * 6**3 / 12], rtol=1e-14)
    np.testing.assert_allclose(found.second_moments, [4 + 12 * 16, 36 + 12], rtol=1e-14)
    assert found.product == pytest.approx(-48.0, rel=1e-14)
    assert found.central_product == pytest.approx(0.0, abs=1e-13)
    assert found.polar_moment == pytest.approx(40.0, rel=1e-14)
    np.testing.assert_allclose(found.principal_moments, [4.0, 36.0], rtol=1e-14)
    np.testing.assert_allclose(found.radii_of_gyration, [2 / np.sqrt(12), 6 / np.sqrt(12)], rtol=1e-14)
    assert set(found.to_dict()) >= {"area", "centroid", "second_moments", "principal_axes", "moments"}


def test_principal_axes_are_those_of_the_shape_turned():
    """An L of known legs, turned by 25°: the axes turn with it, the moments stay."""
    shape = np.array([(0, 0), (5, 0), (5, 1), (1, 1), (1, 3), (0, 3)], float)
    angle = np.radians(25.0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    before, after = (gw.Section.polygon(points).properties() for points in (shape, shape @ turn.T))
    np.testing.assert_allclose(after.principal_moments, before.principal_moments, rtol=1e-13)
    cosines = np.abs(after.principal_axes.T @ turn @ before.principal_axes)
    np.testing.assert_allclose(cosines, np.eye(2), atol=1e-13)
    # the tensor of moments about the axes is diagonal in them
    m = after.central_moments
    tensor = np.array([[m[0, 2], -m[1, 1]], [-m[1, 1], m[2, 0]]])
    diagonal = after.principal_axes.T @ tensor @ after.principal_axes
    np.testing.assert_allclose(diagonal, np.diag(after.principal_moments), atol=1e-13)
    assert np.linalg.det(after.principal_axes) == pytest.approx(1.0)


def test_a_section_with_equal_principal_moments_keeps_the_axes_of_the_frame():
    np.testing.assert_array_equal(gw.Section.rectangle(2.0, 2.0, (5.0, 1.0)).properties().principal_axes, np.eye(2))


def test_a_circle_and_third_moments():
    found = gw.Section.circle(2.0, (3.0, 1.0)).properties()
    assert found.area == pytest.approx(4.0 * np.pi, rel=1e-15)
    assert found.perimeter == pytest.approx(4.0 * np.pi, rel=1e-15)
    # ∫ x³ dA = A c (c² + 3 r²/4)
    assert found.moments[3, 0] == pytest.approx(4.0 * np.pi * 3.0 * (9.0 + 3.0), rel=1e-14)


def test_a_spline_has_the_moments_of_the_true_curve():
    """Against a polygon of so many chords that they are of no account."""
    from scipy.interpolate import CubicSpline

    points = star(np.random.default_rng(5), 12, 2.0, 3.0, (1.0, -2.0))
    closed = np.concatenate([points, points[:1]])
    knots = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    spline = CubicSpline(knots, closed, bc_type="periodic")
    found = gw.Section.spline(points)

    def chords(n):
        return gw.Section.polygon(spline(np.linspace(0.0, knots[-1], n + 1)[:-1])).moments

    limit = (4.0 * chords(4000) - chords(2000)) / 3.0
    np.testing.assert_allclose(found.moments, limit, rtol=1e-8, atol=1e-8)
    assert abs(chords(2000)[0, 0] - limit[0, 0]) > 1e-6


def test_an_outline_of_mixed_curves():
    """A stadium whose upper side is an arc's chord replaced by two lines, with a round hole."""
    curves = [
        Line(first=(-2.0, -1.0), last=(2.0, -1.0)),
        Arc(radius=1.0, centre=(2.0, 0.0), interval=(-np.pi / 2, np.pi / 2)),
        Line(first=(2.0, 1.0), last=(-2.0, 1.0)),
        Arc(radius=1.0, centre=(-2.0, 0.0), interval=(np.pi / 2, 3 * np.pi / 2)),
    ]
    hole = [Arc(radius=0.5, centre=(0.3, 0.1), interval=(0.0, 2 * np.pi))]
    found = gw.Section.outline(curves, holes=[hole]).properties()
    assert found.area == pytest.approx(8.0 + np.pi - np.pi / 4, rel=1e-15)
    backwards = gw.Section.outline([c.reversed() for c in curves[::-1]], holes=[hole])
    assert backwards.properties().area == pytest.approx(found.area, rel=1e-15)


def two_holes(overlap):
    """Two round holes of radius 1 in a disc, which overlap by a length."""
    holes = [
        [Arc(radius=1.0, centre=(x, 0.0), interval=(0.7, 0.7 + 2 * np.pi))] for x in (overlap / 2 - 1, 1 - overlap / 2)
    ]
    return gw.Section.outline([Arc(radius=5.0, interval=(0.0, 2 * np.pi))], holes=holes)


def test_two_holes_with_a_thin_wall_are_two_holes():
    assert two_holes(-1e-5).properties().area == pytest.approx(23.0 * np.pi, rel=1e-13)


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (lambda: gw.Section.polygon([(0, 0), (4, 3), (4, 0), (0, 2)]), ["crosses itself", "(1.6, 1.2)"]),
        (lambda: gw.Section.polygon([(0, 0), (2, 2), (2, 0), (0, 2)]), ["encloses nothing", "(1, 1)"]),
        (lambda: gw.Section.polygon([(0, 0), (1, 0), (2, 0)]), ["encloses nothing"]),
        (lambda: gw.Section.polygon([(0, 0), (1, 0)]), ["2 points", "at least 3"]),
        (lambda: gw.Section.polygon([]), ["(0,)", "(n, 2)"]),
        (lambda: gw.Section.polygon([(0, 0), (1, 0), (1, np.nan)]), ["point 2", "finite"]),
        (lambda: gw.Section.polygon([(0, 0), (1, 0), (1, 0), (1, 1)]), ["points 1 and 2", "(1, 0)", "coincide"]),
        (lambda: gw.Section.polygon("abc"), ["(n, 2)"]),
        (lambda: gw.Section.polygon(SQUARE, holes=[[(3, 1), (5, 1), (5, 2)]]), ["loop 1 and 2", "(4, 1"]),
        (lambda: gw.Section.polygon(SQUARE, holes=[[(9, 1), (10, 1), (10, 2)]]), ["loop 2 at (9, 1)", "outside"]),
        (lambda: gw.Section.polygon(SQUARE, holes=[HOLE, HOLE]), ["loop 2 and 3"]),
        (lambda: gw.Section.polygon(SQUARE, holes=[HOLE, [(1.5, 1.2), (1.7, 1.2), (1.7, 1.3)]]), ["another hole"]),
        (lambda: gw.Section.polygon([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)]), ["touches itself", "(2, 0)"]),
        (lambda: gw.Section.polygon(SQUARE, holes=[[(0, 2), (1, 1), (1, 2.5)]]), ["loops 1 and 2 at (0, 2)", "touch"]),
        (
            lambda: gw.Section.polygon([*SQUARE, (1, 1.5)], holes=[[(1, 1), (3, 1), (3, 2), (1, 2)]]),
            ["(1, 1.5)", "touch"],
        ),
        (
            lambda: gw.Section.polygon(SQUARE, holes=[[(1, 1), (2, 1), (2, 2)], [(2, 2), (3, 2), (3, 2.5)]]),
            ["loops 2 and 3"],
        ),
        (lambda: two_holes(1e-6), ["loop 2 and 3", "crosses"]),
        (lambda: two_holes(1e-9), ["loops 2 and 3 at (", "too close to tell"]),
        (lambda: two_holes(0.0), ["loops 2 and 3 at (", "too close to tell"]),
        (lambda: gw.Section.spline([(0, 0), (4, 3), (4, 0), (0, 2)]), ["crosses itself", "(1.778"]),
        (lambda: gw.Section.circle(0.0), ["radius = 0", "greater than 0"]),
        (lambda: gw.Section.circle("2"), ["radius = 2", "greater than 0"]),
        (lambda: gw.Section.circle(1.0, (1.0,)), ["centre = (1.0,)"]),
        (lambda: gw.Section.rectangle(1.0, float("inf")), ["height = inf"]),
        (lambda: gw.Section.outline([Line(first=(0, 0), last=(1, 0)), Line(first=(1, 1e-3), last=(0, 0))]), ["gap"]),
    ],
)
def test_what_is_no_section_is_refused_with_the_place(build, words):
    with pytest.raises(gw.GeometryError) as caught:
        build()
    for word in words:
        assert word in str(caught.value)


def test_curves_that_pass_closely_are_not_taken_for_crossing():
    """A hole whose wall is 1e-6 of the size: closer than the first look's chords."""
    gw.Section.outline(
        [Arc(radius=1.0, interval=(0.0, 2 * np.pi))],
        holes=[[Arc(radius=0.5, centre=(0.5 - 1e-6, 0.0), interval=(0.0, 2 * np.pi))]],
    )
    with pytest.raises(gw.GeometryError, match=r"at \(0.99999"):
        gw.Section.outline(
            [Arc(radius=1.0, interval=(0.0, 2 * np.pi))],
            holes=[[Arc(radius=0.5, centre=(0.5 + 1e-6, 0.0), interval=(0.0, 2 * np.pi))]],
        )


@pytest.mark.parametrize("seed", range(6))
def test_the_support_function_is_the_farthest_point(seed):
    random = np.random.default_rng(seed)
    involute = Involute(base_radius=2.0, interval=(0.0, 1.2))
    tip = float(np.hypot(*involute.end))
    top = float(np.arctan2(involute.end[1], involute.end[0]))
    curves = [
        involute,
        Arc(radius=tip, interval=(top, top + 2.0)),
        Line(first=(tip * np.cos(top + 2.0), tip * np.sin(top + 2.0)), last=(2.0, 0.0)),
    ]
    section = gw.Section.outline(curves)
    direction = random.normal(size=2)
    reach, point = section.support.exactly(direction)
    cloud = np.concatenate([c.point(c.parameter(np.linspace(0.0, 1.0, 200_001))) for c in curves])
    best = np.max(cloud @ direction)
    assert best <= reach + 1e-14
    assert reach - best < 1e-9
    assert point @ direction == pytest.approx(reach, rel=1e-15)
    assert section.support.roughly(direction) <= reach + 1e-15


def test_where_smooth_curves_join_the_support_is_found_in_either():
    """A circle of three arcs: the radius in every direction, however near to a joint."""
    cuts = [0.3, 2.1, 4.4, 0.3 + 2 * np.pi]
    arcs = [Arc(radius=3.0, interval=(a, b)) for a, b in pairwise(cuts)]
    support = gw.Section.outline(arcs).support
    for angle in np.concatenate(
        [np.linspace(0.0, 2 * np.pi, 37), np.array(cuts)[:, None] + [-0.02, 0.0, 0.02]], axis=None
    ):
        reach, _ = support.exactly(np.array([np.cos(angle), np.sin(angle)]))
        assert reach == pytest.approx(3.0, rel=1e-15)

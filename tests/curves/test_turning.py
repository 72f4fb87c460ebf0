"""What turns: flanks that stay involutes, arcs that grow narrower."""

import numpy as np
import pytest

from gearwright.curves.curve import mapped, turn
from gearwright.curves.involute import Involute
from gearwright.curves.polynomial import Polynomial, parabola
from gearwright.curves.turning import TurnedArc, turned

RELIEF = 0.03
BASE = 2.3
INVOLUTE = Involute(base_radius=BASE, interval=(0.2, 1.3))


def test_the_normal_offset_of_an_involute_is_the_involute_turned_by_offset_over_base_radius():
    """The flank's normals touch the base circle: along them it is moved inward by the relief, at another roll."""
    flank = turned(INVOLUTE, parabola(RELIEF / BASE, 0.0, 10.0))
    for v, offset in ((0.0, RELIEF), (2.5, RELIEF / 4.0), (5.0, 0.0), (10.0, RELIEF)):
        u = np.linspace(0.3, 1.2, 7)
        # at roll u the tangent is (cos u, sin u), so that the normal towards growing azimuth is (−sin u, cos u)
        moved = INVOLUTE.point(u) + offset * np.stack([-np.sin(u), np.cos(u)], axis=-1)
        angle = offset / BASE
        np.testing.assert_allclose(flank.at(v).point(u - angle), moved, atol=1e-15)


def test_a_positive_angle_turns_counter_clockwise_and_its_mirror_image_clockwise():
    flank = turned(INVOLUTE, Polynomial(coefficients=(0.0, 0.1)))
    for curve, sign in ((flank, 1.0), (mapped(flank, turn(0.9, 2, mirrored=True)), -1.0)):
        first, later = (np.arctan2(*curve.at(v).point(0.7)[::-1]) for v in (0.0, 3.0))
        assert later - first == pytest.approx(sign * 0.3, abs=1e-15)
        np.testing.assert_array_equal(curve.point(0.7), curve.at(0.0).point(0.7))


def test_a_mirror_image_turns_back_where_the_curve_does():
    flank = turned(INVOLUTE, parabola(0.1, 2.0, 5.0))
    assert mapped(flank, turn(0.9, 2, mirrored=True)).extremes(0.0, 9.0) == (3.5,)


def test_turns_add():
    first, second = Polynomial(coefficients=(0.1, 0.2)), Polynomial(coefficients=(0.0, 0.0, 0.3), centre=1.0)
    inner = turned(INVOLUTE, first)
    both = turned(inner, second)
    expected = turn(0.1 + 0.2 * 2.5 + 0.3 * 1.5**2, 2) @ INVOLUTE.point(0.8)
    np.testing.assert_allclose(both.at(2.5).point(0.8), expected, atol=1e-15)
    assert both.extremes(-4.0, 4.0) == (1.0,)


def test_the_ends_of_an_arc_turn_each_by_its_own_angle():
    narrower = TurnedArc(
        radius=2.0,
        azimuths=(-0.2, 0.5),
        turnings=(parabola(0.05, 0.0, 4.0), Polynomial(coefficients=(0.0, -0.01))),
    )
    tip = narrower.at(4.0)
    for point, azimuth in ((tip.start, -0.15), (tip.end, 0.46), (tip.point(0.5), 0.155)):
        np.testing.assert_allclose(point, [2.0 * np.cos(azimuth), 2.0 * np.sin(azimuth)], atol=1e-15)
    np.testing.assert_allclose(narrower.start, [2.0 * np.cos(0.2), -2.0 * np.sin(0.2)], atol=1e-15)
    assert narrower.extremes(0.0, 4.0) == (2.0,)
    back = narrower.reversed().at(4.0)
    np.testing.assert_allclose(back.start, tip.end, atol=1e-15)
    np.testing.assert_allclose(back.point(back.parameter(0.25)), tip.point(0.75), atol=1e-15)

"""Loops: closure, sense, copies and families."""

from dataclasses import dataclass

import numpy as np
import pytest

from gearwright.curves.arc import Arc
from gearwright.curves.curve import mapped, turn
from gearwright.curves.line import Line
from gearwright.curves.meridian import Meridian
from gearwright.curves.parallel import Parallel
from gearwright.errors import GeometryError
from gearwright.sections.loop import CLOSURE, Loop


def polygon(*corners):
    return tuple(Line(first=a, last=b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))


def saw(copies, sense=1):
    """One period of a saw-toothed rim about the origin, running clockwise for sense −1."""
    step = 2.0 * np.pi / copies
    a, b = (1.0, 0.0), (1.4 * np.cos(0.3 * step), 1.4 * np.sin(0.3 * step))
    c = (np.cos(0.6 * step), np.sin(0.6 * step))
    curves = (Line(first=a, last=b), Line(first=b, last=c), Arc(radius=1.0, interval=(0.6 * step, step)))
    return Loop(curves=curves if sense > 0 else tuple(x.reversed() for x in curves[::-1]), copies=copies)


def spherical_saw(copies, sense=1):
    step = 2.0 * np.pi / copies
    curves = (
        Meridian(azimuth=0.0, interval=(0.5, 0.8)),
        Parallel(polar_angle=0.8, interval=(0.0, 0.4 * step)),
        Meridian(azimuth=0.4 * step, interval=(0.8, 0.5)),
        Parallel(polar_angle=0.5, interval=(0.4 * step, step)),
    )
    return Loop(curves=curves if sense > 0 else tuple(x.reversed() for x in curves[::-1]), copies=copies)


def samples(loop, n=7):
    return np.concatenate([c.point(c.parameter(np.arange(n) / n)) for c in loop.curves])


class TestClosure:
    def test_a_gap_is_refused_with_its_place_and_size(self):
        with pytest.raises(GeometryError) as caught:
            Loop(
                curves=(
                    Line(first=(0.0, 0.0), last=(2.0, 0.0)),
                    Line(first=(2.0, 0.0), last=(2.0, 1.0)),
                    Line(first=(2.0, 1.25), last=(0.0, 0.0)),
                )
            )
        assert len(caught.value.problems) == 1
        assert caught.value.problems[0].subject == "gap of 0.25 after curve 2 of 3 at [2. 1.]"
        assert "at most 2e-09" in str(caught.value)
        assert "not closed" in str(caught.value)

    def test_every_gap_is_named_at_once(self):
        with pytest.raises(GeometryError) as caught:
            Loop(curves=(Line(first=(0.0, 1.0), last=(2.0, 0.0)), Line(first=(2.0, 0.5), last=(0.0, 0.0))))
        assert ["after curve 1 of 2" in str(p) or "after curve 2 of 2" in str(p) for p in caught.value.problems] == [
            True,
            True,
        ]

    def test_a_period_that_does_not_reach_the_next_is_refused(self):
        with pytest.raises(GeometryError, match="after curve 1 of 1"):
            Loop(curves=(Arc(radius=1.0, interval=(0.0, 1.0)),), copies=6)
        Loop(curves=(Arc(radius=1.0, interval=(0.0, np.pi / 3.0)),), copies=6)

    @pytest.mark.parametrize(("gap", "closed"), [(0.5 * CLOSURE, True), (2.0 * CLOSURE, False)])
    @pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
    def test_the_gap_allowed_grows_with_the_loop(self, gap, closed, scale):
        corners = np.array([[1.0, 0.1], [0.2, 0.7], [-0.4, 0.3]]) * scale
        lines = list(polygon(*map(tuple, corners)))
        lines[1] = Line(first=tuple(corners[1] + [gap * scale, 0.0]), last=tuple(corners[2]))
        if closed:
            Loop(curves=tuple(lines))
        else:
            with pytest.raises(GeometryError, match="after curve 1 of 3"):
                Loop(curves=tuple(lines))

    def test_a_curve_without_a_place_is_a_gap(self):
        with pytest.raises(GeometryError, match="gap of nan"):
            Loop(curves=polygon((0.0, 0.0), (1.0, np.nan), (0.0, 1.0)))

    @pytest.mark.parametrize("radius", [1e7, 1e9])
    def test_a_circle_through_the_origin_closes_whatever_its_size(self, radius):
        Loop(curves=(Arc(radius=radius, centre=(-radius, 0.0), interval=(0.0, 2.0 * np.pi)),))


@pytest.mark.parametrize("make", [saw, spherical_saw])
@pytest.mark.parametrize("copies", [3, 6, 12])
@pytest.mark.parametrize("sense", [1, -1])
class TestCopies:
    def test_the_sense_is_that_in_which_periods_follow(self, make, copies, sense):
        assert make(copies, sense).sense == sense

    @pytest.mark.parametrize("divisor", [1, 3])
    def test_fewer_longer_periods_are_the_same_loop(self, make, copies, sense, divisor):
        loop = make(copies, sense)
        longer = loop.with_copies(divisor)
        assert longer.copies == divisor
        assert len(longer.curves) == len(loop.curves) * copies // divisor
        assert longer.sense == sense or divisor == 1
        period = samples(loop)
        angle = sense * 2.0 * np.pi / copies
        c, s = np.cos(angle), np.sin(angle)
        for k in range(copies // divisor):
            np.testing.assert_allclose(samples(longer)[k * len(period) : (k + 1) * len(period)], period, atol=1e-14)
            x, y = period[:, 0].copy(), period[:, 1].copy()
            period[:, 0], period[:, 1] = c * x - s * y, s * x + c * y

    def test_quadrature_covers_one_period(self, make, copies, sense):
        loop = make(copies, sense)
        points, tangents = loop.quadrature(9)
        assert points.shape == tangents.shape == (9 * len(loop.curves), loop.curves[0].start.size)
        np.testing.assert_allclose(tangents.sum(axis=0), loop.curves[-1].end - loop.curves[0].start, atol=1e-9)


def test_two_copies_close_both_ways():
    half = (Arc(radius=1.0, interval=(0.0, np.pi)),)
    for curves in (half, (half[0].reversed(),)):
        whole = Loop(curves=curves, copies=2).with_copies(1)
        assert len(whole.curves) == 2


@dataclass(frozen=True, kw_only=True)
class Tapered(Line):
    """A segment that shrinks towards the origin as 1 − v."""

    def at(self, v):
        k = 1.0 - float(v)
        return Line(first=tuple(k * x for x in self.first), last=tuple(k * x for x in self.last))


class TestFamily:
    def test_a_constant_loop_is_itself(self):
        loop = saw(5)
        assert loop.at(0.3) is loop

    def test_a_constant_loop_with_mapped_curves_is_itself(self):
        loop = Loop(curves=(mapped(Arc(radius=1.0, interval=(0.0, np.pi)), turn(0.4, 2)),), copies=2)
        assert loop.at(0.3) is loop

    def test_a_loop_with_reversed_mirror_images_keeps_its_sense(self):
        loop = Loop(
            curves=(
                Line(first=(-1.0, 0.0), last=(1.0, 0.0)),
                Line(first=(1.0, 0.0), last=(0.0, 1.0)),
                mapped(Line(first=(1.0, 0.0), last=(0.0, 1.0)), [[-1.0, 0.0], [0.0, 1.0]]).reversed(),
            )
        )
        np.testing.assert_allclose(samples(loop.at(0.3)), samples(loop))

    def test_a_family_gives_its_member_and_keeps_its_copies(self):
        family = Loop(
            curves=(Tapered(first=(1.0, 0.0), last=(0.0, 1.0)), Tapered(first=(0.0, 1.0), last=(-1.0, 0.0))), copies=2
        )
        member = family.at(0.25)
        assert member.copies == 2
        np.testing.assert_allclose(samples(member), 0.75 * samples(family))

"""Tooth forms on the sphere: conjugate, as thick as asked for, and as far from one another as theory says."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
from scipy.optimize import brentq, minimize_scalar

from gearwright.curves.curve import turn
from gearwright.elements.bevel.meshing import contact_ratio, fillet_limit, interference_limit, meshing_placements
from gearwright.elements.bevel.spherical_flank import InvoluteFlank, OctoidFlank
from gearwright.elements.bevel.tooth_flank import Relief

from ...laws.contact import touching
from .teeth import PRESSURE, pair, polar_and_azimuth, tooth

EVERY_FORM = pytest.mark.parametrize("form", ["involute", "octoid"])
PAIRS = [
    *(((16, 20), shaft) for shaft in (45.0, 60.0, 90.0, 110.0, 135.0)),
    *(((12, 31), shaft) for shaft in (45.0, 60.0, 90.0, 110.0)),
    ((18, 36), 120.0),  # with a crown gear
]


class Placed:
    """A flank of a tooth in space, its parameter from 0 to 1."""

    def __init__(self, tooth, placement):
        self.curve = tooth.tooth_flank.curves()[0]
        self.seat = placement[:3, :3]

    def points(self, u):
        return self.curve.point(self.curve.parameter(u)) @ self.seat.T

    def point(self, u, extra_turn=0.0):
        return self.seat @ turn(extra_turn, 3) @ self.curve.point(self.curve.parameter(u))

    def tangent(self, u, extra_turn=0.0):
        tangent = self.curve.derivative(self.curve.parameter(u))
        return self.seat @ turn(extra_turn, 3) @ (tangent / np.linalg.norm(tangent))


def contact(teeth, shaft, angle, error=0.0):
    """Where clockwise flanks touch, and the turn of the gear beyond its placement, the pinion turned by an angle."""
    pinion, gear = meshing_placements(np.radians(shaft + error), teeth[0].teeth, teeth[1].teeth, angle)
    return touching(Placed(teeth[0], pinion), Placed(teeth[1], gear))


def turns_of_contact(teeth, count=9):
    """Turns of the pinion, well inside those at which its first clockwise flank touches."""
    pinion = teeth[0]
    first = max(pinion.flank.parameter_at(pinion.form_angle), -float(teeth[1].flank.parameter_at(teeth[1].face_angle)))
    last = min(float(pinion.flank.parameter_at(pinion.face_angle)), -teeth[1].flank.parameter_at(teeth[1].form_angle))
    crown = np.linspace(first + 0.02 * (last - first), last - 0.02 * (last - first), count)
    return pinion.thickness / 2.0 - crown / np.sin(pinion.pitch_angle)


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "shaft"), PAIRS)
def test_the_ratio_is_constant(teeth, shaft, form):
    both = pair(teeth, shaft, form)
    turns = turns_of_contact(both)
    found = [contact(both, shaft, float(angle)) for angle in turns]
    assert None not in found
    np.testing.assert_allclose([extra for _, _, extra in found], 0.0, atol=1e-12)
    assert np.all(np.diff(turns) < 0.0)  # the pinion drives by this flank, and contact goes from its root to its tip
    assert np.all(np.diff([u for u, _, _ in found]) > 0.0)
    assert np.all(np.diff([v for _, v, _ in found]) < 0.0)


@pytest.mark.parametrize(("form", "bound"), [("involute", (0.0, 1e-13)), ("octoid", (1e-7, 1e-4))])
def test_only_involutes_bear_an_error_of_the_shaft_angle(form, bound):
    both = pair((16, 20), 90.0, form)
    turns = turns_of_contact(both, 7)[1:-1]
    extra = [contact(both, 90.0, float(angle), error=0.2)[2] for angle in turns]
    assert bound[0] < np.ptp(extra) < max(bound[1], 2e-12)


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "shaft"), [((16, 20), 90.0), ((20, 30), 60.0), ((24, 31), 110.0)])
def test_contact_lasts_as_long_as_the_contact_ratio_says(teeth, shaft, form):
    both = pair(teeth, shaft, form, rho=None)
    longer = [replace(one, face_angle=one.face_angle + 0.02) for one in both]
    turns = turns_of_contact(both, 5)

    def beyond(angle, member):
        found = contact(longer, shaft, angle)
        flank = longer[member].tooth_flank.curves()[0]
        polar, _ = polar_and_azimuth(flank.point(flank.parameter(found[member])))
        return float(polar) - both[member].face_angle

    step = 0.05 * (turns[0] - turns[-1])
    first = brentq(beyond, turns[0], turns[0] + step, args=(1,), xtol=1e-13)
    last = brentq(beyond, turns[-1], turns[-1] - step, args=(0,), xtol=1e-13)
    assert (first - last) / (2.0 * np.pi / teeth[0]) == pytest.approx(contact_ratio(*both), rel=1e-9)


def test_contact_ratios_of_the_16_20_pair():
    involute, octoid = (contact_ratio(*_published(form)) for form in ("involute", "octoid"))
    assert involute == pytest.approx(1.33423, abs=0.6e-5)
    assert octoid == pytest.approx(involute, rel=0.01)
    assert octoid < involute


def _published(form):
    """16/20 teeth, P_d = 2, both addenda 0.4 in at the cone distance √41 in: the thesis's example."""
    height = np.arctan(0.4 / np.sqrt(41.0))
    return [replace(one, face_angle=one.pitch_angle + height) for one in pair((16, 20), 90.0, form, rho=None)]


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "shaft"), [((16, 20), 90.0), ((12, 31), 60.0)])
def test_the_interference_limit_is_where_the_tip_meets_the_mate_s_inner_end(teeth, shaft, form):
    """A tip a little lower meets a flank that still moves; the speed of the mate's flank vanishes at the limit."""
    pinion, gear = pair(teeth, shaft, form, rho=None)
    longer = [pinion, replace(gear, face_angle=interference_limit(gear, pinion))]
    distances = []
    for below in (0.01, 0.02):
        at = longer[1].face_angle - below
        u = float(gear.flank.parameter_at(at))
        angle = pinion.thickness / 2.0 + u / np.sin(pinion.pitch_angle)
        reached, met, extra = contact(longer, shaft, angle)
        flank = longer[1].tooth_flank.curves()[0]
        assert polar_and_azimuth(flank.point(flank.parameter(met)))[0] == pytest.approx(at, abs=1e-12)
        assert extra == pytest.approx(0.0, abs=1e-12)
        own = longer[0].tooth_flank.curves()[0]
        distances.append(polar_and_azimuth(own.point(own.parameter(reached)))[0] - pinion.flank.least_polar)
    assert distances[0] > 0.0
    assert distances[1] / distances[0] == pytest.approx(4.0, rel=0.25)  # parabolic from the cusp


def test_limits_of_the_16_20_pair():
    pinion, gear = pair((16, 20), 90.0, "involute", rho=None)
    assert np.degrees(interference_limit(gear, pinion)) == pytest.approx(57.855, abs=0.6e-3)
    assert np.degrees(interference_limit(pinion, gear)) == pytest.approx(50.653, abs=0.6e-3)


@EVERY_FORM
def test_the_fillet_limit_is_lower_and_keeps_tips_off_the_fillet(form):
    pinion, gear = pair((16, 20), 90.0, form)
    limit = fillet_limit(gear, pinion)
    assert gear.face_angle < limit < interference_limit(gear, pinion)
    longer = [pinion, replace(gear, face_angle=limit)]
    angle = pinion.thickness / 2.0 + (gear.flank.parameter_at(limit) - 0.01) / np.sin(pinion.pitch_angle)
    reached, met, _ = contact(longer, 90.0, float(angle))
    assert reached < 0.04
    assert met > 0.96


@pytest.mark.parametrize(("teeth", "pitch"), [(16, 38.659808), (20, 51.340192), (20, 30.0), (40, 51.34)])
def test_the_octoid_is_off_the_involute_by_what_theory_says(teeth, pitch):
    gamma = np.radians(pitch)
    module = 2.0 * np.sin(gamma) / teeth
    involute, octoid = (form(pitch_angle=gamma, pressure_angle=PRESSURE) for form in (InvoluteFlank, OctoidFlank))

    def off(height):
        """Normal distance, µm per mm of module, so many modules above the pitch cone; positive in the other's tooth."""
        u = octoid.parameter_at(gamma + height * module)
        point = octoid.rolled(0.0, 0.0).point(u)
        curve = involute.rolled(0.0, 0.0)
        nearest = minimize_scalar(
            lambda v: float(np.linalg.norm(curve.point(v) - point)),
            bounds=(u - 0.1 * module, u + 0.1 * module),
            method="bounded",
            options={"xatol": 1e-13},
        )
        sign = np.sign(octoid.azimuth_at(gamma + height * module) - involute.azimuth_at(gamma + height * module))
        return 1e3 * nearest.fun / module * sign

    assert off(0.0) == pytest.approx(0.0, abs=1e-6)
    assert 0.02 < off(0.5) < 0.35
    assert 0.4 < off(1.0) < 2.1
    assert -0.35 < off(-0.3) < -0.02


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), [(5, 3), (16, 38.66), (20, 51.34), (30, 80), (40, 90)])
class TestTeeth:
    def test_are_as_thick_as_asked_for_at_the_pitch_cone(self, teeth, pitch, form):
        thick = tooth(teeth, pitch, form, backlash=0.07)
        assert 2.0 * thick.half_angle(thick.pitch_angle) == pytest.approx((np.pi - 0.07) / teeth, abs=1e-14)
        assert thick.thickness_at(thick.pitch_angle) == pytest.approx(thick.thickness, abs=1e-14)

    def test_have_flanks_inclined_by_the_pressure_angle_at_the_pitch_point(self, teeth, pitch, form):
        one = tooth(teeth, pitch, form, rho=None)
        curve = one.flank.curve(one.pitch_angle, one.face_angle)
        tangent = curve.derivative(curve.interval[0])
        tangent /= np.linalg.norm(tangent)
        np.testing.assert_allclose(curve.start, [np.sin(one.pitch_angle), 0.0, np.cos(one.pitch_angle)], atol=1e-14)
        assert tangent[1] == pytest.approx(np.sin(PRESSURE), abs=1e-12)

    def test_are_pointed_where_their_flanks_meet(self, teeth, pitch, form):
        one = tooth(teeth, pitch, form)
        assert one.thickness_at(one.pointed_angle) == pytest.approx(0.0, abs=1e-13)
        assert one.pointed_angle > one.face_angle

    @pytest.mark.parametrize("rho", [None, 0.25])
    @pytest.mark.parametrize("power", [None, 2])
    def test_have_simple_sections_of_their_polygon_s_solid_angle(self, teeth, pitch, form, rho, power):
        one = tooth(teeth, pitch, form, rho)
        if power:
            middle = (one.pitch_angle + one.face_angle) / 2.0
            relief = Relief(amount=0.02 * np.sin(one.pitch_angle) / teeth, begin=float(middle), power=power)
            one = replace(one, relief=relief)
        section = one.section()
        loop = section.loops[0]
        points = np.concatenate([c.point(c.parameter(np.linspace(0.0, 1.0, 4001)[:-1])) for c in loop.curves])
        polar, azimuth = polar_and_azimuth(points @ turn(-np.pi / teeth, 3).T)
        azimuth = np.unwrap(azimuth)
        assert azimuth[-1] - azimuth[0] == pytest.approx(2.0 * np.pi / teeth, rel=1e-3)
        assert shapely.LineString(np.stack([azimuth, polar], axis=-1)).is_simple
        azimuth, polar = np.append(azimuth, azimuth[0] + 2.0 * np.pi / teeth), np.append(polar, polar[0])
        cap = 2.0 * np.sin(polar / 2.0) ** 2
        polygon = teeth * np.sum((cap[:-1] + cap[1:]) / 2.0 * np.diff(azimuth))
        assert section.moments[0, 0] == pytest.approx(polygon, rel=1e-6)
        assert section.moments[0, 0] < 2.0 * np.pi * (1.0 - np.cos(one.face_angle))
        assert section.moments[0, 0] > 2.0 * np.pi * (1.0 - np.cos(one.root_angle))


@EVERY_FORM
@pytest.mark.parametrize("pitch", [20.0, 51.34, 90.0])
def test_the_ends_of_flanks_are_where_their_turns_say(pitch, form):
    flank = tooth(20, pitch, form).flank
    polar = flank.parameter_at(np.array([flank.least_polar, flank.pitch_angle, flank.greatest_polar]))
    np.testing.assert_allclose(polar, [flank.least_turn, 0.0, flank.greatest_turn], atol=1e-7)  # flat at the ends
    assert flank.polar_at(flank.least_turn) == pytest.approx(flank.least_polar, abs=1e-14)
    assert flank.polar_at(flank.greatest_turn) == pytest.approx(flank.greatest_polar, abs=1e-14)
    assert flank.pitch_azimuth == pytest.approx(-float(flank.azimuth_at(flank.least_polar)), abs=1e-14)


@EVERY_FORM
@pytest.mark.parametrize("relieved", [False, True])
def test_nearby_teeth_have_the_same_curves(relieved, form):
    """The same number and kind, close to one another: a family of them is analytic in its parameters."""

    def curves(eps):
        one = tooth(14, 35.0 + eps, form, 0.3 + eps)
        if relieved:
            one = replace(one, relief=Relief(amount=1e-3, begin=one.pitch_angle + 0.02, power=1))
        return one.section().loops[0].curves

    for a, b in zip(curves(0.0), curves(1e-7), strict=True):
        np.testing.assert_allclose(
            a.point(a.parameter([0.0, 0.4, 1.0])), b.point(b.parameter([0.0, 0.4, 1.0])), atol=1e-7
        )


@EVERY_FORM
@pytest.mark.parametrize("power", [1, 2])
@pytest.mark.parametrize(("teeth", "pitch"), [(16, 38.66), (12, 5.0), (30, 80), (40, 90)])
class TestRelief:
    def teeth(self, teeth, pitch, form, power):
        plain = tooth(teeth, pitch, form)
        begin = (2.0 * plain.pitch_angle + plain.face_angle) / 3.0
        amount = 0.03 * np.sin(plain.pitch_angle) / teeth
        return plain, replace(plain, relief=Relief(amount=amount, begin=begin, power=power))

    @staticmethod
    def depth(plain, point):
        """Least distance of a point from the flank without relief, made longer."""
        curve = replace(plain, face_angle=plain.face_angle * 0.97 + plain.pointed_angle * 0.03).tooth_flank.curves()[0]
        at = minimize_scalar(
            lambda f: float(np.linalg.norm(curve.point(curve.parameter(f)) - point)),
            bounds=(0.0, 1.0),
            method="bounded",
            options={"xatol": 1e-13},
        )
        assert 0.0 < at.x < 1.0
        return 2.0 * np.arcsin(at.fun / 2.0)

    def test_is_what_was_asked_for_at_the_tip_and_grows_as_asked_for(self, teeth, pitch, form, power):
        plain, relieved = self.teeth(teeth, pitch, form, power)
        curve = relieved.tooth_flank.curves()[1]
        amount = relieved.relief.amount
        assert self.depth(plain, curve.end) == pytest.approx(amount, rel=1e-9)
        assert self.depth(plain, curve.point(curve.parameter(0.5))) == pytest.approx(amount / 2.0**power, rel=1e-9)

    def test_begins_and_ends_on_the_cones_it_was_given(self, teeth, pitch, form, power):
        _, relieved = self.teeth(teeth, pitch, form, power)
        below, above = relieved.tooth_flank.curves()
        polar, azimuth = polar_and_azimuth(np.array([above.start, above.end]))
        np.testing.assert_allclose(polar, [relieved.relief.begin, relieved.face_angle], atol=1e-14)
        np.testing.assert_allclose(below.end, above.start, atol=1e-14)
        np.testing.assert_allclose(-azimuth, [relieved.half_angle(polar[0]), relieved.tip_half], atol=1e-14)
        directions = [c.derivative(c.interval[end]) for c, end in ((below, 1), (above, 0))]
        a, b = (v / np.linalg.norm(v) for v in directions)
        assert (np.linalg.norm(np.cross(a, b)) < 1e-12) == (power == 2)
        assert a @ b > 0.99

    def test_makes_teeth_thinner_above_where_it_begins(self, teeth, pitch, form, power):
        plain, relieved = self.teeth(teeth, pitch, form, power)
        polar = np.linspace(plain.form_angle, plain.face_angle, 20)
        thinner = plain.half_angle(polar) - relieved.half_angle(polar)
        below = polar <= relieved.relief.begin
        assert not thinner[below].any()
        assert np.all(thinner[~below] > 0.0)
        assert np.all(np.diff(thinner[~below]) > 0.0)
        curve = relieved.tooth_flank.curves()[1]
        polar, azimuth = polar_and_azimuth(curve.point(curve.parameter(np.linspace(0.0, 1.0, 9))))
        np.testing.assert_allclose(relieved.half_angle(polar), -azimuth, atol=1e-12)
        assert relieved.half_angle(polar[3]).shape == ()
        assert relieved.tip_half == pytest.approx(float(relieved.half_angle(relieved.face_angle)), abs=1e-12)


@EVERY_FORM
@pytest.mark.parametrize("rounded", [True, False], ids=["fillet", "radial"])
@pytest.mark.parametrize(("teeth", "pitch"), [(16, 38.66), (30, 80), (40, 90)])
class TestProfileCrowning:
    AMOUNT = 2e-3

    def teeth(self, teeth, pitch, form, rounded):
        plain = tooth(teeth, pitch, form)
        plain = replace(plain, tip_radius=0.1 * plain.largest_tip_radius if rounded else None)
        return plain, replace(plain, profile_crowning=self.AMOUNT)

    def test_turns_flanks_by_what_was_asked_for_at_both_ends_and_not_on_the_pitch_cone(
        self, teeth, pitch, form, rounded
    ):
        plain, crowned = self.teeth(teeth, pitch, form, rounded)
        ends = np.array([crowned.form_angle, crowned.face_angle])
        turned = plain.half_angle(np.maximum(ends, plain.form_angle)) - crowned.half_angle(ends)
        np.testing.assert_allclose(turned, self.AMOUNT, rtol=0.02)  # a wider space moves where the fillet ends
        assert turned[1] == pytest.approx(self.AMOUNT, rel=1e-12)
        assert crowned.half_angle(plain.pitch_angle) == pytest.approx(plain.half_angle(plain.pitch_angle), abs=1e-15)
        u = crowned.flank.parameter_at(crowned.face_angle)
        halfway = crowned.flank.polar_at(float(u) / 2.0)
        assert plain.half_angle(halfway) - crowned.half_angle(halfway) == pytest.approx(self.AMOUNT / 4.0, rel=1e-9)

    def test_curves_meet_and_have_the_half_angles_told(self, teeth, pitch, form, rounded):
        _, crowned = self.teeth(teeth, pitch, form, rounded)
        curves = crowned.section().loops[0].curves  # that they close, the loop sees to
        flank = crowned.tooth_flank.curves()
        assert len(flank) == 2
        assert len(curves) > 4
        for curve in flank:
            polar, azimuth = polar_and_azimuth(curve.point(curve.parameter(np.linspace(0.0, 1.0, 9))))
            np.testing.assert_allclose(crowned.half_angle(polar), -azimuth, atol=1e-12)

    def test_goes_with_relief(self, teeth, pitch, form, rounded):
        _, crowned = self.teeth(teeth, pitch, form, rounded)
        for part in (0.3, 1.3):  # of the addendum: above the pitch cone, and from below it
            begin = crowned.face_angle - part * (crowned.face_angle - crowned.pitch_angle)
            if begin <= crowned.form_angle:
                continue
            both = replace(crowned, relief=Relief(amount=1e-4, begin=begin, power=2))
            assert both.section().moments[0, 0] < crowned.section().moments[0, 0]
            assert both.tip_half == pytest.approx(float(both.half_angle(both.face_angle)), abs=1e-9)
            assert len(both.tooth_flank.curves()) == 3

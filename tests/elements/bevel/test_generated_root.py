"""Generated roots against the tool itself: a crown gear's rounded tooth rolled past the gear."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear

from .generating_crown import GeneratingCrown
from .teeth import PRESSURE, polar_and_azimuth, tooth

EVERY_FORM = pytest.mark.parametrize("form", ["involute", "octoid"])
GEARS = [(5, 3), (5, 30), (8, 51.34), (8, 90), (12, 10), (12, 75), (20, 3), (20, 51.34), (40, 10), (60, 88), (60, 90)]


def tool(cut):
    space = 2.0 * np.pi / cut.teeth - cut.thickness
    half_width = space * np.sin(cut.pitch_angle) / 2.0
    return GeneratingCrown(cut.form, cut.pressure_angle, half_width, cut.pitch_angle - cut.root_angle, cut.tip_radius)


def space_side(cut, fractions):
    """Points of fillet, flank and root arc on the clockwise flank of a tooth, the space below it on azimuth 0."""
    middle = np.pi / cut.teeth
    c, s = np.cos(middle), np.sin(middle)
    turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    curves = [cut.fillet.curve(), *cut.tooth_flank.curves()]
    return [curve.point(curve.parameter(fractions)) @ turned.T for curve in curves]


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), GEARS)
@pytest.mark.parametrize(("rho", "backlash"), [(0.3, 0.0), (0.1, 0.05)])
def test_the_crown_gear_touches_every_point_and_cuts_no_deeper(teeth, pitch, form, rho, backlash):
    cut = tooth(teeth, pitch, form, rho, backlash)
    crown = tool(cut)
    for part in space_side(cut, np.linspace(0.0, 1.0, 9)):
        for point in part:
            assert crown.least_clearance(point, cut.pitch_angle) == pytest.approx(0.0, abs=1e-9)


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), GEARS)
def test_the_fillet_is_tangent_to_the_root_and_to_the_flank_unless_undercut(teeth, pitch, form):
    cut = tooth(teeth, pitch, form)
    foot, flank = cut.fillet.curve(), cut.tooth_flank.curves()[0]
    first, last, above = (
        v / np.linalg.norm(v)
        for v in (
            foot.derivative(foot.interval[0]),
            foot.derivative(foot.interval[1]),
            flank.derivative(flank.interval[0]),
        )
    )
    polar, azimuth = polar_and_azimuth(foot.start)
    assert polar == pytest.approx(cut.root_angle, abs=1e-14)
    assert abs(first[2]) < 1e-13  # along the parallel
    np.testing.assert_allclose(foot.end, flank.start, atol=1e-12)
    assert (np.linalg.norm(np.cross(last, above)) < 1e-9) == (not cut.fillet.undercuts)
    assert -last @ above > 0.0
    assert cut.root_space / 2.0 == pytest.approx(azimuth + np.pi / teeth, abs=1e-14)


def test_few_teeth_on_slender_cones_are_undercut_and_no_others():
    undercut = {(z, g) for z, g in GEARS if tooth(z, g, "involute").fillet.undercuts}
    assert undercut == {(5, 3), (5, 30), (8, 51.34), (12, 10)}
    assert {(z, g) for z, g in GEARS if tooth(z, g, "octoid").fillet.undercuts} == {(5, 3), (5, 30), (12, 10)}


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), [(5, 3), (5, 30), (12, 10)])
def test_an_undercut_corner_is_on_both_curves(teeth, pitch, form):
    cut = tooth(teeth, pitch, form)
    polar, azimuth = polar_and_azimuth(cut.fillet.curve().end)
    assert polar == pytest.approx(cut.form_angle, abs=1e-13)
    assert polar > cut.flank.least_polar
    assert -azimuth == pytest.approx(cut.half_angle(polar), abs=1e-12)
    # without undercut the same tool would leave the flank down to here and beyond
    polar, _ = polar_and_azimuth(cut.fillet.trochoid.point(cut.fillet.crown_tip.tangent[1]))
    assert polar > cut.flank.least_polar


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), [(8, 30), (20, 51.34), (40, 90)])
def test_the_largest_radius_leaves_no_land(teeth, pitch, form):
    some = tooth(teeth, pitch, form, 0.1)
    largest = some.largest_tip_radius
    full = tooth(teeth, pitch, form, tip_radius=largest)
    assert full.root_space == 0.0
    crown = tool(full)
    assert crown.corner[1] == pytest.approx(0.0, abs=1e-8)  # the tool's own corner is found to that
    assert len(full.section().loops[0].curves) == len(some.section().loops[0].curves) - 1
    assert tooth(teeth, pitch, form, tip_radius=largest * 0.99).root_space > 0.0
    assert tooth(teeth, pitch, form, tip_radius=largest * 1.01).root_space < 0.0


def test_the_largest_radius_of_a_slender_cone_is_the_rack_s():
    plane = (np.pi / 4.0 - 1.25 * np.tan(PRESSURE)) * np.cos(PRESSURE) / (1.0 - np.sin(PRESSURE))  # ISO 53
    for form in ("involute", "octoid"):
        module = 2.0 * np.sin(np.radians(0.05)) / 20
        assert tooth(20, 0.05, form).largest_tip_radius / module == pytest.approx(plane, rel=1e-6)


def test_flanks_that_meet_before_the_tip_leave_room_for_no_radius():
    module = 2.0 * np.sin(np.radians(40.0)) / 20
    deep = tooth(20, 40, "octoid", 0.1, root_angle=np.radians(40.0) - 2.3 * module)
    assert deep.largest_tip_radius < 0.0


@pytest.mark.parametrize(("teeth", "deepest"), [(8, 1.39), (6, 1.04)])
def test_an_involute_crown_gear_has_flanks_down_to_its_own_base_cone(teeth, deepest):
    """That is a from its pitch plane; an octoid's goes on. A corner is tangent before the flank's end, or nowhere."""
    module = 2.0 / teeth
    for depth, reaches in ((deepest - 0.02, True), (deepest + 0.02, False)):
        assert (depth * module < PRESSURE) == reaches
        at = {"root_angle": np.pi / 2.0 - depth * module, "tip_radius": 1e-6 * module}
        assert tooth(teeth, 90, "involute", **at).fillet.crown_tip.reaches == reaches
        assert tooth(teeth, 90, "octoid", **at).fillet.crown_tip.reaches
    flank = tooth(8, 90, "involute").flank
    for radius in np.linspace(0.0, 0.5, 26):
        turning = flank.tip_tangent(0.3, radius)[0] - flank.crown.least_turn
        assert flank.crown_reaches(0.3, radius) == (turning > 0.0)


def test_a_corner_may_be_rounder_than_the_tip_is_deep():
    shallow = tooth(30, 50, "octoid", 0.1, root_angle=np.radians(50.0) - 0.02)
    largest = shallow.largest_tip_radius
    assert largest > shallow.fillet.crown_tip.depth
    full = replace(shallow, tip_radius=0.999 * largest)
    crown = tool(full)
    for part in space_side(full, np.linspace(0.0, 1.0, 5)):
        for point in part:
            assert crown.least_clearance(point, full.pitch_angle) == pytest.approx(0.0, abs=1e-9)


@EVERY_FORM
@pytest.mark.parametrize(("teeth", "pitch"), GEARS)
def test_half_angles_and_waist_are_those_of_the_outline(teeth, pitch, form):
    cut = tooth(teeth, pitch, form)
    foot, flank = cut.fillet.curve(), cut.tooth_flank.curves()[0]
    inside = np.linspace(0.02, 0.98, 7)
    polar, azimuth = polar_and_azimuth(foot.point(foot.parameter(inside)))
    np.testing.assert_allclose(cut.fillet.half_angle(polar), -azimuth, atol=1e-10)
    polar, azimuth = polar_and_azimuth(flank.point(flank.parameter(inside)))
    np.testing.assert_allclose(cut.half_angle(polar), -azimuth, atol=1e-12)
    _, azimuth = polar_and_azimuth(foot.point(foot.parameter(np.linspace(0.0, 1.0, 2001))))
    assert cut.waist == pytest.approx(np.min(-azimuth), abs=1e-4)
    assert cut.fillet.regular


def test_no_warning_whatever_the_radius():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for rho in (0.0, 0.2, 0.6, 2.0):
            cut = tooth(6, 80, "involute", rho)
            assert isinstance(cut.fillet.undercuts, bool)
            assert isinstance(cut.fillet.crown_tip.reaches, bool)
            assert np.isfinite(cut.largest_tip_radius)


@pytest.mark.parametrize("form", ["involute", "octoid"])
def test_a_radius_of_the_librarys_own_leaves_a_root_arc_all_along_teeth_of_uniform_depth(form):
    """Their spaces are narrowest at the toe: a tip that is round all over there would end the root arc on the way."""
    gear = BevelGear(teeth=20, mate_teeth=16, module=4, face_width=15, taper="uniform", tooth_form=form)
    assert gear.generating_tip_radius < 1.0, "a quarter of the module does not fit"
    inner, outer = gear.bevel_teeth.inner.root_space, gear.bevel_teeth.outer.root_space
    assert 0.0 < inner < outer
    assert gear.properties().error_bound < 1e-12

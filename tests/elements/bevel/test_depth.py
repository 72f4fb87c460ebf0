"""Teeth whose depth, width or flanks change along the face: where their tips and roots lie, and what they weigh."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.depth_line import DepthLine
from gearwright.elements.bevel.tooth_ends import ToothEnds
from gearwright.moments.matrix import shifted
from gearwright.motions.levels import level_moments
from gearwright.solids.solid import flux_moments

KINDS = ("conical", "spherical", "flat")
BASE = {"teeth": 24, "module": 3.0, "mate_teeth": 36, "face_width": 16.0}
MILLED = {"trace": "circular", "spiral_angle": 35.0, "cutter_radius": 50.0}
HOBBED = {"trace": "epicycloid", "spiral_angle": 30.0, "cutter_radius": 70.0, "blade_groups": 5}
GEARS = {
    "standard taper": BevelGear(**BASE),
    "uniform": BevelGear(**BASE, taper="uniform", crown_tip_radius=0.3),
    "uniform, flat, octoid": BevelGear(**BASE, taper="uniform", ends="flat", tooth_form="octoid"),
    "uniform, spherical, radial roots": BevelGear(**BASE, taper="uniform", ends="spherical", root="radial"),
    "own angles": BevelGear(**BASE, addendum_angle=1.0, dedendum_angle=5.5),
    "own angles, roots opening inward": BevelGear(**BASE, dedendum_angle=0.5, ends="flat", pressure_angle=25.0),
    "flat, far out": BevelGear(
        teeth=29, module=3.0, mate_teeth=10, shaft_angle=100.0, face_width=5.0, addendum_angle=7.5, ends="flat"
    ),
    "gleason": BevelGear(**BASE, standard="gleason-straight"),
    "duplex, milled": BevelGear(**BASE, standard="iso-23509", taper="duplex", **MILLED),
    "tilted, spherical": BevelGear(**BASE, standard="iso-23509", taper="tilted", ends="spherical", **MILLED),
    "hobbed": BevelGear(**BASE, standard="iso-23509", **HOBBED),
    "crowned": BevelGear(**BASE, crowning=0.03),
    "crowned octoid, relieved, flat": BevelGear(
        **BASE, crowning=0.03, tooth_form="octoid", tip_relief=0.02, ends="flat", bore=12.0
    ),
    "uniform, relieved, crowned": BevelGear(
        **BASE, taper="uniform", tip_relief=0.02, tip_relief_form="parabolic", crowning=0.02
    ),
}
every_gear = pytest.mark.parametrize("name", GEARS)
every_varying = pytest.mark.parametrize("name", [name for name, gear in GEARS.items() if gear.bevel_teeth.varies])


def about_apex(body):
    return shifted(body.matrix, body.origin)


def apart(one, other):
    """Greatest difference of entries of two moment matrices about the apex, of the body's own size."""
    size = np.sqrt(np.trace(one[1:, 1:]) / one[0, 0])
    unit = np.array([1.0, size, size, size])
    return float(np.abs((one - other) / (one[0, 0] * np.outer(unit, unit))).max())


@pytest.mark.parametrize("line", [(2.0, 4.0), (3.0, 0.0), (-3.5, -6.0), (-3.0, 0.0), (1.0, 1.1), (-2.0, 3.0)], ids=str)
@pytest.mark.parametrize("pitch", [5.0, 40.0, 80.0])
@pytest.mark.parametrize("kind", KINDS)
def test_the_point_at_the_polar_angle_told_is_on_the_line_and_on_the_level(kind, pitch, line):
    height, slope = line
    gamma = np.radians(pitch)
    ends = ToothEnds(kind=kind, pitch_angle=gamma, inner=30.0, outer=50.0)
    depth = DepthLine(outer=50.0, height=height, angle=np.radians(slope))
    for s in (30.0, 37.0, 50.0):
        v = ends.parameter(s)
        rho, z = ends.point(depth.polar_angle(ends, v), s)
        along, above = rho * np.sin(gamma) + z * np.cos(gamma), rho * np.cos(gamma) - z * np.sin(gamma)
        assert above == pytest.approx(height - (50.0 - along) * np.tan(np.radians(slope)), abs=1e-12)
        level = {"conical": along - s, "spherical": np.hypot(rho, z) - s, "flat": z - s * np.cos(gamma)}[kind]
        assert level == pytest.approx(0.0, abs=1e-12)


@cache
def _axial(gear):
    """Along the pitch line and above it (n,), and the level's parameter, of the corners of the polyhedron."""
    points = gear.polyhedron(0.1).vertices
    rho, z = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    c, s = np.cos(gear.pitch_cone_angle), np.sin(gear.pitch_cone_angle)
    along = rho * s + z * c
    return along, rho * c - z * s, {"conical": along, "spherical": np.hypot(rho, z), "flat": z}[gear.ends]


@every_gear
def test_tips_lie_on_one_straight_line_of_the_axial_plane_and_roots_on_another(name):
    """From end to end, and nothing of the gear is above the tips."""
    gear = GEARS[name]
    along, above, level = _axial(gear)
    shape, ends = gear.proportions, [gear.tooth_ends.parameter(s) for s in (gear.inner_distance, gear.cone_distance)]
    tips = shape.addendum - (gear.cone_distance - along) * np.tan(shape.addendum_angle)
    roots = -shape.dedendum + (gear.cone_distance - along) * np.tan(shape.dedendum_angle)
    on_teeth = (level > ends[0] - 1e-9) & (level < ends[1] + 1e-9)
    assert (above - tips)[on_teeth].max() == pytest.approx(0.0, abs=1e-9)
    for line in (tips, roots):
        on_it = np.abs(above - line) < 1e-9
        assert on_it.sum() >= 4 * gear.teeth
        for end in ends:
            assert np.sum(on_it & (np.abs(level - end) < 1e-9)) >= 2 * gear.teeth


@every_gear
def test_outer_heights_stand_on_the_back_cone(name):
    gear = GEARS[name]
    if gear.ends != "conical":
        return
    along, above, _ = _axial(gear)
    last = np.abs(along - gear.cone_distance) < 1e-9
    sizes = gear.sizes()
    assert above[last].max() == pytest.approx(sizes["addendum"].value, abs=1e-9)
    assert np.abs(above[last] + sizes["dedendum"].value).min() < 1e-9
    first = np.abs(along - gear.inner_distance) < 1e-9
    narrower = gear.face_width * np.tan(gear.proportions.addendum_angle)
    assert above[first].max() == pytest.approx(sizes["addendum"].value - narrower, abs=1e-9)


@every_varying
def test_a_section_between_known_ones_is_the_tooth_s_own(name):
    teeth = GEARS[name].bevel_teeth
    inner, outer = teeth.level("inner"), teeth.level("outer")
    section = teeth.section(None)
    t = np.linspace(0.0, 1.0, 14)
    for part in (0.013, 0.37, 0.618, 0.991):
        v = inner + part * (outer - inner)
        own, met = teeth.tooth(v).section().loops[0].curves, section.at(v).loops[0].curves
        assert len(own) == len(met)
        for one, other in zip(own, met, strict=True):
            assert np.abs(one.point(one.parameter(t)) - other.point(other.parameter(t))).max() < 2e-12


@every_gear
def test_moments_are_the_flux_through_the_boundary(name):
    gear = GEARS[name]
    exact, flux = gear.solid.moments, flux_moments(gear.boundary)
    found = apart(about_apex(exact), about_apex(flux))
    assert found < 1e-12
    assert found <= exact.error_bound + flux.error_bound
    assert exact.error_bound < 1e-11
    assert exact.method == "exact"


@pytest.mark.parametrize("name", ["uniform", "own angles, roots opening inward", "uniform, relieved, crowned"])
def test_moments_are_sums_over_slices(name):
    """Slices between levels, each with the tooth in its middle, as gears that do not vary; order 2 in their number."""
    gear = GEARS[name]
    errors = []
    for count in (4, 8):
        total = np.zeros((4, 4))
        width = gear.face_width / count
        for k in range(count):
            total += about_apex(_slice(gear, gear.inner_distance + k * width, width))
        errors.append(apart(about_apex(gear.ring(None).moments), total))
    assert errors[1] < 1e-3
    assert 1.8 < np.log2(errors[0] / errors[1]) < 2.2


def _slice(gear, start, width):
    """Moments of a slice whose section is everywhere that in its middle."""
    ends, teeth = gear.tooth_ends, gear.bevel_teeth
    section = teeth.tooth(ends.parameter(start + width / 2.0)).section()
    return level_moments(section, ends.levels, ends.parameter(start), ends.parameter(start + width))


TRACES = {
    "left logarithmic": {"trace": "logarithmic", "spiral_angle": 35.0, "hand": "left"},
    "steep logarithmic": {"trace": "logarithmic", "spiral_angle": 55.0},
    "skew": {"trace": "skew", "spiral_angle": 15.0},
    "involute": {"trace": "involute", "spiral_angle": 40.0, "hand": "left"},
    "milled": {**MILLED, "spiral_angle": 20.0},
    "zerol": {"trace": "circular", "cutter_radius": 60.0, "hand": "left"},
    "hobbed": {**HOBBED, "hand": "left"},
}
STRAIGHT = {"trace": "straight", "spiral_angle": 0.0, "cutter_radius": None, "blade_groups": None}


@cache
def _straight(name, teeth):
    return replace(GEARS[name], **STRAIGHT, teeth=teeth, bore=None)


@pytest.mark.parametrize(
    ("name", "teeth", "trace"),
    [
        *[("standard taper", teeth, trace) for teeth in (24, 3) for trace in TRACES],
        *[("own angles", 24, trace) for trace in TRACES],
        ("uniform", 24, "steep logarithmic"),
        ("uniform, flat, octoid", 24, "milled"),
        ("uniform, flat, octoid", 24, "hobbed"),
        ("uniform, spherical, radial roots", 24, "involute"),
        ("crowned octoid, relieved, flat", 24, "left logarithmic"),
    ],
)
def test_a_trace_of_either_hand_changes_nothing(name, teeth, trace):
    if teeth == 3:
        straight = BevelGear(teeth=3, module=8.0, pitch_angle=20.0, face_width=9.0, addendum=3.0, dedendum=5.0)
    else:
        straight = _straight(name, teeth)
    if trace == "milled" and teeth == 3:
        other = replace(straight, **{**TRACES[trace], "cutter_radius": 30.0})
    else:
        other = replace(straight, **TRACES[trace])
    assert apart(about_apex(other.solid.moments), about_apex(straight.solid.moments)) < 1e-13


@pytest.mark.parametrize("form", ["involute", "octoid"])
@pytest.mark.parametrize("ends", KINDS)
def test_crowning_is_what_the_flank_is_lower_by_at_its_ends(form, ends):
    """Along its normal on the sphere, at the pitch cone: the whole amount at toe and heel, a quarter halfway."""
    amount, gamma = 0.04, GEARS["crowned"].pitch_cone_angle
    plain = BevelGear(**BASE, tooth_form=form, ends=ends)
    crowned = replace(plain, crowning=amount)
    for part, share in ((0.0, 1.0), (0.25, 0.25), (0.5, 0.0), (1.0, 1.0)):
        s = plain.inner_distance + part * plain.face_width
        v = plain.tooth_ends.parameter(s)
        gap = _gap(plain.bevel_teeth.tooth(v), crowned.bevel_teeth.tooth(v), gamma) * s
        assert gap == pytest.approx(share * amount, rel=2e-3, abs=1e-12)


def _gap(plain, crowned, gamma):
    """Distance along a great circle normal to the plain flank at the pitch cone to the crowned one, radians."""
    near = gamma + np.linspace(-2e-3, 2e-3, 4001)

    def flank(tooth):
        half = tooth.half_angle(near)
        return np.stack([np.sin(near) * np.cos(half), np.sin(near) * np.sin(half), np.cos(near)], axis=-1)

    place = flank(plain)[2000]
    return float(2.0 * np.arcsin(np.linalg.norm(flank(crowned) - place, axis=1).min() / 2.0))


def test_crowning_takes_material_away_from_both_ends():
    """A parabola takes a third of the amount on the mean, over two flanks of each tooth."""
    plain, amount = GEARS["standard taper"], 0.03
    lost = plain.solid.moments.volume - replace(plain, crowning=amount).solid.moments.volume
    depth = plain.proportions.depth * plain.mean_distance / plain.cone_distance
    flanks = 2.0 * plain.teeth * plain.face_width * depth / np.cos(np.radians(20.0))
    assert lost == pytest.approx(flanks * amount / 3.0, rel=0.1)


@pytest.mark.parametrize("form", ["involute", "octoid"])
@pytest.mark.parametrize("shape", ["linear", "parabolic"])
def test_relief_goes_with_depth_along_the_face(form, shape):
    """At every level the tip's flank is as far off, as a part of the cone distance, as at the outer end."""
    plain = BevelGear(**BASE, tooth_form=form, taper="uniform")
    relieved = replace(plain, tip_relief=0.03, tip_relief_form=shape)
    for s in (plain.inner_distance, plain.mean_distance, plain.cone_distance):
        tooth, other = (gear.bevel_teeth.tooth(s) for gear in (plain, relieved))
        thinner = (tooth.tip_half - other.tip_half) * np.sin(tooth.face_angle) * np.cos(np.radians(20.0))
        assert thinner == pytest.approx(0.03 / plain.cone_distance, rel=0.2)
        assert other.half_angle(plain.pitch_cone_angle) == pytest.approx(tooth.half_angle(plain.pitch_cone_angle))


@pytest.mark.parametrize(("height", "slope"), [(4.0, 3.0), (-5.0, -2.5), (4.0, 0.0)])
def test_heights_along_a_line_are_those_of_its_points_between_cones(height, slope):
    """h(s) = s tan(δ − γ) on the cone perpendicular to the pitch cone at s, and the offset at the apex."""
    line = DepthLine(outer=50.0, height=height, angle=np.radians(slope))
    ends = ToothEnds(kind="conical", pitch_angle=0.7, inner=35.0, outer=50.0)
    assert line.height_at(50.0) == height
    assert line.height_at(0.0) == pytest.approx(line.offset, abs=1e-14)
    for s in (35.0, 41.0):
        assert line.height_at(s) == pytest.approx(s * np.tan(line.polar_angle(ends, s) - 0.7), rel=1e-13)

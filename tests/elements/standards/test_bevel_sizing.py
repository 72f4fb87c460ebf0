"""Sizing systems of bevel gears against published tables, and against what their cones and slots are for."""

import numpy as np
import pytest

from gearwright.elements.standards.bevels.blank_sizes import blank_sizes
from gearwright.elements.standards.bevels.depth_data import DepthData, depth_data, strength_thickness_factor
from gearwright.elements.standards.bevels.design import BevelDesign
from gearwright.elements.standards.bevels.equal_addendum import equal_addendum
from gearwright.elements.standards.bevels.gleason import gleason_spiral, gleason_straight
from gearwright.elements.standards.bevels.iso_23509 import iso_23509
from gearwright.elements.standards.bevels.member import bevel_members
from gearwright.elements.standards.bevels.pair_sizes import pair_sizes
from gearwright.elements.standards.bevels.tooth_sizes import tooth_sizes
from gearwright.errors import ParameterError

SHAFT_ANGLES = (20, 45, 75, 90, 104, 112)
SYSTEMS = {
    "equal": equal_addendum,
    "shifted": lambda design: equal_addendum(design, profile_shift=0.3, thickness_modification=0.02),
    "straight": gleason_straight,
    "iso": iso_23509,
    "duplex": lambda design: iso_23509(design, taper="duplex"),
    "uniform": lambda design: iso_23509(design, taper="uniform"),
}

# KHK, Gear Technical Reference, "Calculation of gear dimensions": m = 3, z = 20/40, Σ = 90°, α = 20°
STANDARD = """
pitch_angle 26.56505 63.43495 | cone_distance 67.08204 67.08204 | pitch_diameter 60 120 | addendum 3 3
dedendum 3.75 3.75 | dedendum_angle 3.19960 3.19960 | addendum_angle 2.56064 2.56064 | face_angle 29.12569 65.99559
root_angle 23.36545 60.23535 | outside_diameter 65.3666 122.6833 | crown_to_apex 58.6584 27.3167
axial_face_width 19.2374 8.9587 | inner_tip_diameter 43.9292 82.4485 | face_apex 0 0 | root_apex 0 0
"""
GLEASON_STRAIGHT = """
addendum 4.035 1.965 | dedendum 2.529 4.599 | dedendum_angle 2.15903 3.92194 | addendum_angle 3.92194 2.15903
face_angle 30.48699 65.59398 | root_angle 24.40602 59.51301 | outside_diameter 67.2180 121.7575
crown_to_apex 58.1955 28.2425 | axial_face_width 19.0029 9.0969 | inner_tip_diameter 44.8425 81.6609
"""
GLEASON_SPIRAL = """
transverse_pressure_angle 23.95680 23.95680 | addendum 3.4275 1.6725 | dedendum 2.2365 3.9915
dedendum_angle 1.90952 3.40519 | addendum_angle 3.40519 1.90952 | face_angle 29.97024 65.34447
root_angle 24.65553 60.02976 | outside_diameter 66.1313 121.4959 | crown_to_apex 58.4672 28.5041
axial_face_width 17.3563 8.3479 | inner_tip_diameter 46.1140 85.1224 | circular_thickness 5.6722 3.7526
"""
# The same, chordal thickness of Gleason straight bevel gears: m = 4, z = 16/40, K = 0.0259
GLEASON_CHORDS = """
addendum 5.5456 2.4544 | circular_thickness 7.5119 5.0545 | chordal_thickness 7.4946 5.0536
chordal_height 5.7502 2.4692
"""

# KHK has the first terms of sine and cosine; the next are d (s/d)⁵/120 and cos δ d (s/d)⁴/48
NEXT_TERMS = {"chordal_thickness": 1.3e-5, "chordal_height": 2.4e-4}


def design(teeth=(20, 40), module=3.0, shaft=90.0, width=22.0, spiral=0.0, **more):
    angles = {"shaft_angle": np.radians(shaft), "pressure_angle": np.radians(20.0), "spiral_angle": np.radians(spiral)}
    return BevelDesign(teeth=teeth, module=module, face_width=width, **angles, **more)


def sizes(given, proportions):
    return [{**blank_sizes(member), **tooth_sizes(member)} for member in bevel_members(given, proportions)]


def rows(table):
    for row in table.replace("\n", "|").split("|"):
        if row.strip():
            name, *values = row.split()
            yield name, values


@pytest.mark.parametrize(
    ("table", "given", "system"),
    [
        (STANDARD, design(), equal_addendum),
        (GLEASON_STRAIGHT, design(), gleason_straight),
        (GLEASON_SPIRAL, design(width=20.0, spiral=35.0), lambda d: gleason_spiral(d, thickness_modification=0.03)),
        (
            GLEASON_CHORDS,
            design(teeth=(16, 40), module=4.0),
            lambda d: gleason_straight(d, thickness_modification=0.0259 / 2.0),
        ),
    ],
    ids=["standard", "Gleason straight", "Gleason spiral", "Gleason chords"],
)
def test_published_tables_are_reproduced_to_their_last_digit(table, given, system):
    found = sizes(given, system(given))
    for name, values in rows(table):
        digits = len(values[0].partition(".")[2]) or 4
        for member, value in zip(found, values, strict=True):
            most = 0.501 * 10.0**-digits + NEXT_TERMS.get(name, 0.0)
            assert member[name].value == pytest.approx(float(value), abs=most), name


def test_the_mean_point_of_iso_23509_first_sample():
    """z 14/39, d_e2 = 176.893, b = 25.4, β_m = 35°, r_c0 = 114.3, duplex taper; heights and angles as printed there."""
    given = design((14, 39), 176.893 / 39, width=25.4, spiral=35.0, cutter_radius=114.3)
    first, second = bevel_members(given, iso_23509(given, method=1, taper="duplex"))
    assert first.mean_cone_distance == pytest.approx(81.273, abs=6e-4)
    heights = [first.addendum(12.7), second.addendum(12.7), first.dedendum(12.7), second.dedendum(12.7)]
    assert heights == pytest.approx([4.837, 1.590, 2.393, 5.640], abs=6e-4)
    assert np.degrees([first.proportions.addendum_angle, second.proportions.addendum_angle]) == pytest.approx(
        [6.493, 2.134], abs=6e-4
    )


def designs(system):
    for shaft in SHAFT_ANGLES:
        yield design((17, 45), 2.5, shaft, 15.0)
    yield design((20, 40), 3.0, 120.0, 20.0)  # a crown gear
    yield design((25, 25), 2.0, 70.0, 8.0)
    yield design((25, 26), 2.0, 160.0, 8.0) if system != "duplex" else design((40, 20), 2.0, 60.0, 8.0)


@pytest.mark.parametrize("name", SYSTEMS)
def test_tips_clear_the_mates_roots_evenly_and_teeth_share_their_pitch(name):
    for given in designs(name):
        first, second = SYSTEMS[name](given)
        assert first.thickness + second.thickness == pytest.approx(np.pi * given.module, rel=1e-14)
        found = pair_sizes(*bevel_members(given, (first, second)))
        gaps = {where: [found[f"{where}_clearance_{i}"].value for i in (1, 2)] for where in ("outer", "mean", "inner")}
        assert min(gaps["inner"]) > 0.0
        if name in ("equal", "shifted"):
            shrink = 1.0 - given.face_width / given.cone_distance
            assert gaps["outer"] == pytest.approx([0.25 * given.module] * 2)
            assert gaps["inner"] == pytest.approx([0.25 * given.module * shrink] * 2)
        else:
            assert gaps["inner"] == pytest.approx(gaps["outer"], rel=1e-12)
            assert gaps["mean"] == pytest.approx([gaps["outer"][0]] * 2, rel=1e-12)


@pytest.mark.parametrize("name", SYSTEMS)
def test_corners_and_apexes_lie_on_the_cones(name):
    """Tip cone from its apex by its half-angle meets both tip corners; so does the root cone its outer corner."""
    for given in designs(name):
        for found in sizes(given, SYSTEMS[name](given)):
            value = {key: size.value for key, size in found.items()}
            lean, apex = np.radians(value["face_angle"]), value["face_apex"]
            outer, height = value["outside_diameter"] / 2.0, value["crown_to_apex"]
            inner, lower = value["inner_tip_diameter"] / 2.0, height - value["axial_face_width"]
            for radius, along in ((outer, height), (inner, lower)):
                assert radius * np.cos(lean) == pytest.approx((along + apex) * np.sin(lean), abs=1e-9)
            delta = np.radians(value["pitch_angle"])
            # both corners are as far apart, seen along the pitch cone, as the face is wide
            across = (outer - inner) * np.sin(delta) + (height - lower) * np.cos(delta)
            assert across == pytest.approx(given.face_width)
            root = np.array([np.sin(delta), np.cos(delta)]) * value["cone_distance"]
            root -= value["dedendum"] * np.array([np.cos(delta), -np.sin(delta)])
            assert 2.0 * root[0] == pytest.approx(value["root_diameter"], abs=1e-9)
            lean = np.radians(value["root_angle"])
            assert root[0] * np.cos(lean) == pytest.approx((root[1] + value["root_apex"]) * np.sin(lean), abs=1e-9)


@pytest.mark.parametrize("system", [gleason_straight, iso_23509])
def test_the_member_with_fewer_teeth_has_the_longer_addendum_whichever_is_named_first(system):
    for teeth, shaft in (((17, 45), 90.0), ((17, 45), 60.0), ((12, 13), 100.0)):
        one = system(design(teeth, 2.0, shaft, 8.0))
        other = system(design(teeth[::-1], 2.0, shaft, 8.0))
        assert one[0].addendum > one[1].addendum
        assert one[0].thickness > one[1].thickness
        for a, b in zip(one, other[::-1], strict=True):
            assert (a.addendum, a.dedendum_angle, a.thickness) == pytest.approx(
                (b.addendum, b.dedendum_angle, b.thickness)
            )


@pytest.mark.parametrize("system", [gleason_straight, iso_23509])
def test_equal_members_are_alike_and_a_crown_gears_mate_is_unlike_most(system):
    for shaft in SHAFT_ANGLES:
        first, second = system(design((30, 30), 2.0, shaft, 8.0))
        assert first.addendum == pytest.approx(second.addendum)
    crown = system(design((20, 40), 3.0, 120.0, 20.0))
    share = crown[1].addendum / (crown[0].addendum + crown[1].addendum)
    least = {gleason_straight: 0.27, iso_23509: 0.21}[system]
    if system is gleason_straight:
        assert share == pytest.approx(least)
    mean = [member.addendum(10.0) for member in bevel_members(design((20, 40), 3.0, 120.0, 20.0), crown)]
    assert mean[1] / sum(mean) == pytest.approx(least, abs=1e-12 if system is iso_23509 else 0.03)


def root_slots(given, pair, distance, trace):
    """Sum of both members' normal widths of slots at their roots, at a cone distance, for a spiral angle there."""
    inwards = given.cone_distance - distance
    spiral = trace(distance)
    pitch = np.pi * given.module * distance / given.cone_distance * np.cos(spiral)
    depths = sum(member.dedendum(inwards) for member in bevel_members(given, pair))
    return pitch - 2.0 * depths * np.tan(given.pressure_angle)


@pytest.mark.parametrize(("spiral", "cutter"), [(0.0, None), (35.0, 114.3), (35.0, 75.0), (20.0, 90.0), (0.0, 100.0)])
@pytest.mark.parametrize("shaft", [60.0, 90.0, 110.0])
def test_duplex_teeth_have_slots_of_one_width_at_their_roots(spiral, cutter, shaft):
    """Followed along a circular arc of the cutter's radius on the crown gear, no formula of the taper in sight."""
    given = design((14, 39), 4.5, shaft, 25.0, spiral, cutter_radius=cutter)
    mean, beta = given.mean_cone_distance, np.radians(spiral)
    centre = None if cutter is None else np.array([mean - cutter * np.sin(beta), cutter * np.cos(beta)])

    def trace(distance):
        """Angle between radius and arc where the arc about `centre`, through (mean, 0), is so far from the apex."""
        if centre is None:
            return 0.0
        away = np.hypot(*centre)
        sine = (distance**2 + cutter**2 - away**2) / (2.0 * distance * cutter)
        return np.arcsin(sine)

    assert trace(mean) == pytest.approx(beta, abs=1e-12)
    step = 1e-3
    for taper, flat in (("duplex", True), ("standard", False), ("uniform", False)):
        pair = iso_23509(given, taper=taper)
        wide, narrow = (root_slots(given, pair, mean + side * step, trace) for side in (1.0, -1.0))
        slope = (wide - narrow) / (2.0 * step)
        # the standard takes angles for their tangents, as small as they are
        taken = [np.tan(member.dedendum_angle) - member.dedendum_angle for member in pair]
        slope += 2.0 * np.tan(given.pressure_angle) * sum(taken)
        assert (abs(slope) < 1e-7) == flat


def test_standard_tapers_meet_in_the_pitch_apex_and_uniform_depths_do_not_taper():
    for given in designs("iso"):
        for found in sizes(given, iso_23509(given, taper="standard")):
            assert found["root_apex"].value == pytest.approx(0.0, abs=1e-11)
            # the tip cone is parallel to a cone through the pitch apex, a clearance nearer to its own axis
            gap = 0.25 * given.mean_normal_module * np.cos(np.radians(found["addendum_angle"].value))
            assert found["face_apex"].value * np.sin(np.radians(found["face_angle"].value)) == pytest.approx(-gap)
        for member in bevel_members(given, iso_23509(given, taper="uniform")):
            assert (member.face_angle, member.root_angle) == (member.pitch_angle, member.pitch_angle)
            assert member.addendum(0.0) == member.addendum(given.face_width)


def test_tilted_root_lines_are_duplex_ones_but_not_beyond_the_limit():
    def total(taper, cutter):
        given = design((14, 39), 4.5, 90.0, 25.0, 35.0, cutter_radius=cutter)
        return sum(member.dedendum_angle for member in iso_23509(given, taper=taper))

    assert total("tilted", 60.0) == total("duplex", 60.0) < total("standard", 60.0)
    assert total("duplex", 200.0) > total("tilted", 200.0) == pytest.approx(1.3 * total("standard", 200.0))


def test_depth_data_of_both_types_say_the_same():
    """k_d 2, k_c 0.125 and c_ham 0.3 by the definitions of h_mw, c and h_am2, and by ISO's type I."""
    given = design((15, 45), 4.0, 90.0, 20.0, 30.0, blade_groups=13)
    pair = iso_23509(given, method=3, depths=depth_data(gear_addendum=0.3, thickness=0.06))
    module = 4.0 * given.mean_cone_distance / given.cone_distance * np.cos(np.radians(30.0))
    addenda, dedenda = [p.addendum for p in pair], [p.dedendum for p in pair]
    assert sum(addenda) == pytest.approx(2.0 * module)
    assert addenda[1] == pytest.approx(0.6 * module)
    assert dedenda == pytest.approx([0.85 * module, 1.65 * module])
    normal = [member.mean_normal_thickness for member in bevel_members(given, pair)]
    assert normal[0] - normal[1] == pytest.approx((4.0 * 0.4 * np.tan(np.radians(20.0)) + 2.0 * 0.06) * module)
    assert all(p.addendum_angle == p.dedendum_angle == 0.0 for p in pair)


def test_methods_differ_in_defaults_only():
    given = design((15, 45), 4.0, 90.0, 20.0, 30.0, cutter_radius=100.0)
    depths = DepthData(profile_shift=0.2)
    pairs = [iso_23509(given, method=method, taper="uniform", depths=depths) for method in (0, 1, 2, 3)]
    assert pairs.count(pairs[0]) == 4
    assert iso_23509(given, method=1) == iso_23509(given) == iso_23509(given, taper="tilted")
    assert iso_23509(given, method=2) == iso_23509(given, method=3) != iso_23509(given, taper="uniform")
    assert iso_23509(given, method=2)[0].addendum == iso_23509(given, method=2)[1].addendum


def test_the_thickness_factor_grows_with_the_ratio_and_spares_equal_members():
    assert strength_thickness_factor(design((30, 30))) == pytest.approx(0.0, abs=1e-12)
    assert strength_thickness_factor(design((20, 40))) == pytest.approx(0.064)
    assert strength_thickness_factor(design((40, 20))) == strength_thickness_factor(design((20, 40)))


def test_long_and_short_addenda_keep_depth_and_clearance_and_move_material_to_the_pinion():
    given = design()
    plain, shifted = equal_addendum(given), equal_addendum(given, profile_shift=0.4)
    assert [p.depth for p in shifted] == pytest.approx([p.depth for p in plain])
    assert shifted[0].addendum - plain[0].addendum == pytest.approx(1.2)
    assert shifted[1].addendum - plain[1].addendum == pytest.approx(-1.2)
    # a flank of 20° moved out by 1.2 is wider by 1.2 tan 20° on either side
    assert shifted[0].thickness - plain[0].thickness == pytest.approx(2.0 * 1.2 * np.tan(np.radians(20.0)))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: design(shaft=150.0), ["shaft_angle = 2.61799", "internal"]),
        (lambda: design(width=70.0), ["face_width = 70", "less than the cone distance, 67.082"]),
        (lambda: design(spiral=95.0), ["spiral_angle", "degrees"]),
        (lambda: design(teeth=(0, 20), module=-1.0), ["teeth = (0, 20)", "module = -1.0"]),
        (lambda: gleason_straight(design(spiral=35.0)), ["spiral_angle", "gleason_spiral"]),
        (lambda: gleason_spiral(design()), ["spiral_angle = 0", "gleason_straight"]),
        (lambda: iso_23509(design(), method=2), ["method = 2", "face hobbing"]),
        (lambda: iso_23509(design(spiral=30.0, blade_groups=5), taper="duplex"), ["blade_groups = 5", '"uniform"']),
        (lambda: iso_23509(design(spiral=30.0), taper="duplex"), ["cutter_radius not given", "28.05"]),
        (lambda: iso_23509(design(spiral=30.0, cutter_radius=20.0), taper="tilted"), ["cutter_radius = 20", "28.05"]),
        (lambda: iso_23509(design(), depths=DepthData(profile_shift=1.25)), ["depths", "profile shift"]),
        (lambda: iso_23509(design(), depths=DepthData(profile_shift=-1.0)), ["depths", "profile shift"]),
    ],
)
def test_what_has_no_proportions_is_refused_with_a_way_out(make, words):
    with pytest.raises(ParameterError) as refusal:
        make()
    for word in words:
        assert word in str(refusal.value)

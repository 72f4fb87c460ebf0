"""Files against designs: differences of known size are found with that size, at the place where they are."""

from dataclasses import replace
from math import hypot

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import ParameterError

SPUR = gw.SpurGear(teeth=14, module=2.0, face_width=6.0, bore=8.0)
HELICAL = gw.HelicalGear(teeth=13, module=2.0, face_width=6.0, helix_angle=20.0)
PAIR = gw.GearPair(teeth=(12, 15), module=2.0, face_width=5.0)

CHORD = 1e-4 * hypot(32.0, 32.0, 6.0)
"""How far (mm) the spur gear's polyhedra lie from what they are made of, by default."""


def matrix(rotation=None, shift=(0.0, 0.0, 0.0)):
    result = np.eye(4)
    result[:3, :3] = np.eye(3) if rotation is None else rotation
    result[:3, 3] = shift
    return result


def turn(degrees, axis):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = np.eye(3)
    result[i, i] = result[j, j] = c
    result[j, i], result[i, j] = s, -s
    return result


def extremes(agreement):
    (part,) = agreement.parts
    return part.comparison.deviation


def test_a_polyhedron_is_its_design():
    agreement = gw.compare(SPUR.polyhedron(), SPUR)
    assert agreement.passed
    assert agreement.problems == ()


@pytest.mark.parametrize("shift", [0.01, -0.01])
def test_a_profile_shift_lifts_roots_by_so_many_modules(shift):
    agreement = gw.compare(replace(SPUR, profile_shift=shift).polyhedron(), SPUR)
    assert not agreement.passed
    found = extremes(agreement)
    largest = found.outward if shift > 0.0 else found.inward
    # root and tip circles move by x m
    assert largest.distance == pytest.approx(2.0 * shift, abs=CHORD)
    assert hypot(*largest.point[:2]) > SPUR.module * (SPUR.teeth / 2.0 - 1.5)


def test_tip_relief_lies_inside_the_flank_near_the_tip():
    found = extremes(agreement := gw.compare(replace(SPUR, tip_relief=0.03).polyhedron(), SPUR))
    assert not agreement.passed
    assert found.inward.distance == pytest.approx(-0.03, abs=CHORD)
    assert found.outward.distance < CHORD
    assert hypot(*found.inward.point[:2]) == pytest.approx(SPUR.module * (SPUR.teeth / 2.0 + 1.0), abs=0.3)
    assert any("(flank)" in problem or "(tip)" in problem for problem in agreement.problems)


def test_a_body_scaled_is_off_by_its_radius():
    found = extremes(agreement := gw.compare(SPUR.polyhedron().transformed(np.diag([1.002] * 3 + [1.0])), SPUR))
    assert not agreement.passed
    assert found.outward.distance == pytest.approx(0.002 * 16.0, abs=CHORD)
    assert "(tip)" in " ".join(agreement.problems)


def test_one_vertex_out_of_place_is_found_where_it_is():
    whole = SPUR.polyhedron()
    at = int(np.argmax(np.hypot(whole.vertices[:, 0], whole.vertices[:, 1])))
    vertices = whole.vertices.copy()
    vertices[at, :2] *= 1.0 + 0.05 / hypot(*vertices[at, :2])
    agreement = gw.compare(gw.Polyhedron(vertices, whole.faces), SPUR)
    assert not agreement.passed
    assert extremes(agreement).outward.distance == pytest.approx(0.05, abs=1e-4)
    np.testing.assert_allclose(extremes(agreement).outward.point, vertices[at], rtol=0.0, atol=1e-12)


def test_a_tooth_cut_off_is_missed():
    """The first tooth, about +x, is pressed down to the root cylinder."""
    whole = SPUR.polyhedron()
    vertices = whole.vertices.copy()
    root = SPUR.module * (SPUR.teeth / 2.0 - 1.25)
    radius, azimuth = np.hypot(*vertices.T[:2]), np.arctan2(vertices[:, 1], vertices[:, 0])
    tooth = (np.abs(azimuth) < np.pi / SPUR.teeth) & (radius > root)
    vertices[tooth, :2] *= (root / radius[tooth])[:, None]
    agreement = gw.compare(gw.Polyhedron(vertices, whole.faces), SPUR)
    found = extremes(agreement)
    assert not agreement.passed
    # the tip circle is 2.25 modules above the root circle; the nearest wall of the neighbours is farther
    assert found.lacking.distance == pytest.approx(2.25 * 2.0, abs=CHORD)
    assert found.lacking.point[0] > 15.0
    assert abs(found.lacking.point[1]) < 1.0


def test_a_bore_left_out_is_missed():
    agreement = gw.compare(replace(SPUR, bore=None).polyhedron(), SPUR)
    found = extremes(agreement)
    assert found.lacking.distance == pytest.approx(3.0, abs=1e-6)  # from the bore's middle to the end faces
    assert "(bore)" in " ".join(agreement.problems)
    assert any(problem.startswith("the volume is") for problem in agreement.problems)


def test_a_hub_left_out_is_missed():
    design = replace(SPUR, hub_diameter=18.0, hub_length=10.0)
    found = extremes(agreement := gw.compare(SPUR.polyhedron(), design))
    assert not agreement.passed
    assert found.lacking.distance == pytest.approx(4.0, abs=1e-3)  # the hub stands out by what it is longer


def test_the_wrong_hand_is_told_as_a_mirror_image():
    agreement = gw.compare(replace(HELICAL, hand="left").polyhedron(), HELICAL)
    assert not agreement.passed
    assert any("mirror image" in problem for problem in agreement.problems)


@pytest.mark.parametrize(
    ("rotation", "shift"),
    [(None, (1.0, -2.0, 3.0)), (turn(40.0, 0), (0.0, 0.0, 0.0)), (turn(5.0, 2), (0.0, 0.0, 0.0))],
    ids=["shifted", "tilted", "turned about its axis"],
)
def test_a_body_elsewhere_is_told_by_which_motion(rotation, shift):
    body = HELICAL.polyhedron().transformed(matrix(rotation, shift))
    agreement = gw.compare(body, HELICAL)
    assert not agreement.passed
    assert any("it is the design, but elsewhere" in problem for problem in agreement.problems)
    comparison = agreement.parts[0].comparison
    found = comparison.shift
    assert not found.mirrored
    back = body.transformed(np.linalg.inv(matrix(found.rotation, found.shift)))
    assert gw.compare(back, HELICAL, within=1.5 * comparison.within).passed


def test_a_shift_is_named():
    agreement = gw.compare(SPUR.polyhedron().transformed(matrix(shift=(1.0, 2.0, 3.0))), SPUR)
    assert "but elsewhere: moved by (1, 2, 3) mm" in agreement.problems[0]


def test_a_changed_gear_is_not_said_to_be_moved():
    agreement = gw.compare(replace(SPUR, profile_shift=0.01).polyhedron(), SPUR)
    assert agreement.parts[0].comparison.shift is None


def test_units_are_converted_and_wrong_ones_noticed(tmp_path):
    design = gw.SpurGear(teeth=14, diametral_pitch=12.0, face_width=0.25, length_unit="in")
    design.save(tmp_path / "inches.3mf")
    assert gw.compare(tmp_path / "inches.3mf", design).passed
    body = design.polyhedron()
    in_mm = body.transformed(np.diag([25.4] * 3 + [1.0]))
    in_mm.save(tmp_path / "mm.3mf", length_unit="mm")
    converted = gw.compare(tmp_path / "mm.3mf", design)
    assert converted.passed
    assert any("converted from mm to in" in remark for remark in converted.remarks)
    in_mm.save(tmp_path / "none.stl", length_unit=None)
    wrong = gw.compare(tmp_path / "none.stl", design)
    assert not wrong.passed
    assert "the unit looks wrong" in wrong.problems[0]
    assert 'in "mm", not "in"' in wrong.problems[0]
    assert any("states no unit" in remark for remark in wrong.remarks)


def test_bodies_of_a_pair_are_compared_with_the_members_they_fit(tmp_path):
    pinion, gear = PAIR.parts()
    PAIR.save(tmp_path / "pair.3mf")
    found = gw.compare(tmp_path / "pair.3mf", PAIR)
    assert found.passed
    assert [(part.member, part.in_mesh) for part in found.parts] == [("pinion", True), ("gear", True)]
    swapped = gw.compare(gw.Polyhedron.united([gear.placed, pinion.placed]), PAIR)
    assert swapped.passed
    assert [part.member for part in swapped.parts] == ["gear", "pinion"]
    alone = gw.compare(gear.polyhedron, PAIR)
    assert alone.passed
    assert [(part.member, part.in_mesh) for part in alone.parts] == [("gear", False)]
    assert any("the file has no pinion" in remark for remark in alone.remarks)


def test_points_of_a_pair_are_where_they_are_in_the_file():
    pinion, gear = PAIR.parts()
    thick = replace(PAIR.gear, bore=6.0).polyhedron().transformed(gear.placement)
    found = gw.compare(gw.Polyhedron.united([pinion.placed, thick]), PAIR)
    (_, part) = found.parts
    assert not found.passed
    axis = gear.placement[:2, 3]
    at = part.comparison.deviation.inward.point
    assert np.hypot(*(at[:2] - axis)) == pytest.approx(3.0, abs=CHORD)


def test_a_body_too_many_is_a_problem():
    pinion, gear = PAIR.parts()
    third = pinion.polyhedron.transformed(matrix(shift=(200.0, 0.0, 0.0)))
    found = gw.compare(gw.Polyhedron.united([pinion.placed, gear.placed, third]), PAIR)
    assert not found.passed
    assert any("one body too many" in problem for problem in found.problems)


@pytest.mark.parametrize("within", [0.0, -1.0, np.nan, "much"])
def test_limits_that_are_no_lengths_are_refused(within):
    with pytest.raises(ParameterError, match="a positive length"):
        gw.compare(SPUR.polyhedron(), SPUR, within=within)

"""Sizes of pairs on parallel axes against published numbers and against each other."""

import numpy as np
import pytest

from gearwright.elements.cylindrical.gear_pair import GearPair

KHK = {"teeth": (12, 24), "module": 3.0, "face_width": 20.0, "profile_shift": (0.6, 0.36)}
"""KHK's guide to gear calculation, profile-shifted spur gears and their contact ratio."""


def _values(element):
    return {name: size.value for name, size in element.sizes().items()}


def test_a_published_shifted_spur_pair():
    pair = GearPair(**KHK)
    found = _values(pair)
    assert found["working_pressure_angle"] == pytest.approx(26.0886, abs=0.6e-4)
    assert found["centre_distance"] == pytest.approx(56.4999, abs=0.6e-4)
    assert found["centre_distance_modification"] == pytest.approx(0.83329, abs=0.6e-5)
    assert found["pinion_working_diameter"] == pytest.approx(37.667, abs=0.6e-3)
    assert found["gear_working_diameter"] == pytest.approx(75.333, abs=0.6e-3)
    assert found["contact_ratio"] == pytest.approx(1.202, abs=0.6e-3)
    assert found["backlash"] == found["normal_backlash"] == 0.0
    assert found["pinion_tip_clearance"] == pytest.approx(0.75, rel=1e-9)
    assert found["gear_tip_clearance"] == pytest.approx(0.75, rel=1e-9)
    assert _values(pair.pinion)["outside_diameter"] == pytest.approx(44.840, abs=0.6e-3)
    assert _values(pair.gear)["outside_diameter"] == pytest.approx(79.400, abs=0.6e-3)
    assert _values(pair.pinion)["root_diameter"] == pytest.approx(32.1, rel=1e-12)
    assert _values(pair.gear)["root_diameter"] == pytest.approx(66.66, rel=1e-12)


def test_tips_are_left_where_that_is_asked_for():
    pair = GearPair(**KHK, tip_shortening="none")
    assert _values(pair.pinion)["outside_diameter"] == pytest.approx(45.6, rel=1e-12)
    assert _values(pair.gear)["outside_diameter"] == pytest.approx(80.16, rel=1e-12)


@pytest.mark.parametrize("tips", [{"tip_diameter": (45.0, 79.8)}, {"addendum": (4.5, 3.9)}])
def test_tips_that_are_given_are_not_shortened(tips):
    pair = GearPair(**KHK, **tips)
    assert _values(pair.pinion)["outside_diameter"] == pytest.approx(45.0, rel=1e-12)
    assert _values(pair.gear)["outside_diameter"] == pytest.approx(79.8, rel=1e-12)


def test_the_centre_distance_gives_the_shifts_back():
    pair = GearPair(**{**KHK, "profile_shift": None, "centre_distance": 56.4999})
    found = _values(pair)
    assert found["sum_of_profile_shifts"] == pytest.approx(0.96, abs=2e-5)
    assert found["centre_distance"] == 56.4999
    assert found["backlash"] == pytest.approx(0.0, abs=1e-12)
    assert _values(pair.pinion)["profile_shift"] == _values(pair.gear)["profile_shift"]


def test_a_published_helical_pair():
    """KHK's guide, helical gears in the normal system: m_n 3, 20°, β 30°, z 12/60, x 0.09809 and 0."""
    pair = GearPair(
        kind="helical", teeth=(12, 60), module=3.0, face_width=30.0, helix_angle=30.0, profile_shift=(0.09809, 0.0)
    )
    found = _values(pair)
    assert found["working_pressure_angle"] == pytest.approx(23.1126, abs=0.6e-4)
    assert found["centre_distance_modification"] == pytest.approx(0.09744, abs=1e-5)
    assert found["centre_distance"] == pytest.approx(125.0, abs=0.6e-4)
    assert _values(pair.pinion)["transverse_pressure_angle"] == pytest.approx(22.79588, abs=0.6e-5)
    assert _values(pair.pinion)["base_diameter"] == pytest.approx(38.322, abs=0.6e-3)
    assert _values(pair.gear)["outside_diameter"] == pytest.approx(213.842, abs=0.6e-3)
    assert _values(pair.pinion)["outside_diameter"] == pytest.approx(48.153, abs=1e-3)


def test_a_published_internal_pair():
    """KHK's guide: m 3, z 16/24, x 0 and 0.5 in its sense, which is −0.5 in that of ISO 21771."""
    pair = GearPair(kind="internal", teeth=(16, 24), module=3.0, face_width=20.0, profile_shift=(0.0, -0.5))
    found = _values(pair)
    assert found["working_pressure_angle"] == pytest.approx(31.0937, abs=1e-4)
    assert found["centre_distance"] == pytest.approx(13.1683, abs=0.6e-4)
    assert found["centre_distance_modification"] == pytest.approx(0.38942, abs=0.6e-5)
    assert found["pinion_working_diameter"] == pytest.approx(52.673, abs=0.6e-3)
    assert found["gear_working_diameter"] == pytest.approx(79.010, abs=0.6e-3)
    assert _values(pair.gear)["root_diameter"] == pytest.approx(82.5, rel=1e-12)


def test_a_published_rack_and_pinion():
    """KHK's guide: m 3, z 12, x 0.6 on a rack whose pitch line is 32 above its back: the axis 51.8 above that."""
    pair = GearPair(kind="rack", teeth=(12, 10), module=3.0, face_width=20.0, profile_shift=0.6, rack_height=32.0)
    found = _values(pair)
    assert found["centre_distance"] + pair.gear.back == pytest.approx(51.8, rel=1e-12)
    assert found["travel"] == pytest.approx(36.0 * np.pi, rel=1e-12)
    assert _values(pair.pinion)["outside_diameter"] == pytest.approx(45.6, rel=1e-12)


def test_the_distance_of_a_rack_gives_the_pinions_shift_alone():
    pair = GearPair(kind="rack", teeth=(20, 9), module=2.0, face_width=10.0, centre_distance=20.6)
    assert _values(pair.pinion)["profile_shift"] == pytest.approx(0.3, rel=1e-12)
    assert _values(pair)["sum_of_profile_shifts"] == pytest.approx(0.3, rel=1e-12)
    assert _values(pair)["backlash"] == 0.0


@pytest.mark.parametrize("kind", ["spur", "helical", "internal", "rack"])
def test_inches_are_millimetres_over_25_4(kind):
    helix = {"helix_angle": 15.0} if kind == "helical" else {}
    teeth = (20, 70) if kind == "internal" else (20, 30)
    metric = GearPair(kind=kind, teeth=teeth, module=2.54, face_width=25.4, **helix, profile_shift=0.1)
    imperial = GearPair(
        kind=kind, teeth=teeth, diametral_pitch=10.0, face_width=1.0, **helix, profile_shift=0.1, length_unit="in"
    )
    for name, size in metric.sizes().items():
        scale = 25.4 if size.unit == "length" else 1.0
        assert imperial.sizes()[name].value * scale == pytest.approx(size.value, rel=1e-9, abs=1e-12), name


def test_overlap_is_of_the_common_face_and_of_one_half_of_herringbone_teeth():
    """The axial pitch goes so many times into the common face width."""
    helical = GearPair(kind="helical", teeth=(20, 30), module=2.0, face_width=(25.0, 18.0), helix_angle=20.0)
    axial = _values(helical.pinion)["axial_pitch"]
    assert _values(helical)["overlap_ratio"] == pytest.approx(18.0 / axial, rel=1e-12)
    double = GearPair(kind="herringbone", teeth=(20, 30), module=2.0, face_width=30.0, helix_angle=20.0)
    found = _values(double)
    assert found["overlap_ratio"] == pytest.approx(15.0 / axial, rel=1e-12)
    assert found["total_contact_ratio"] == pytest.approx(found["contact_ratio"] + found["overlap_ratio"], rel=1e-12)


@pytest.mark.parametrize("kind", ["helical", "herringbone", "internal", "rack"])
def test_hands_go_together(kind):
    for hand, mate in (("right", "left"), ("left", "right")):
        teeth = (20, 60) if kind == "internal" else (20, 30)
        pair = GearPair(kind=kind, teeth=teeth, module=2.0, face_width=10.0, helix_angle=20.0, hand=hand)
        assert (pair.pinion.hand, pair.gear.hand) == (hand, hand if kind == "internal" else mate)


def test_placements_turn_the_mate_by_the_ratio():
    spur, ring = GearPair(**KHK), GearPair(kind="internal", teeth=(20, 60), module=2.0, face_width=10.0)
    rack = GearPair(kind="rack", teeth=(20, 9), module=2.0, face_width=10.0)
    for pair, ratio, x in ((spur, -12 / 24, 56.49987), (ring, 20 / 60, -40.0), (rack, 0.0, 20.0)):
        (pinion, gear), (turned_pinion, turned_gear) = pair.placements(), pair.placements(30.0)
        np.testing.assert_allclose(pinion, np.eye(4), atol=1e-15)
        assert _angle(turned_pinion) == pytest.approx(30.0)
        assert _angle(turned_gear @ np.linalg.inv(gear)) == pytest.approx(30.0 * ratio)
        assert turned_gear[0, 3] == pytest.approx(x, abs=1e-5)
        assert np.array_equal(turned_gear[2], [0.0, 0.0, 1.0, 0.0])
    way = rack.placements(30.0)[1][1, 3] - rack.placements()[1][1, 3]
    assert way == pytest.approx(2.0 * np.pi * 20.0 / 12.0)


def _angle(matrix):
    return float(np.degrees(np.arctan2(matrix[1, 0], matrix[0, 0])))


def test_what_is_unusual_of_either_member_is_said_once():
    pair = GearPair(teeth=(20, 30), module=2.0, face_width=10.0, addendum=(2.0, 1.1))
    assert [remark for remark in pair.remarks if "addendum = 1.1 mm" in remark]
    both = GearPair(teeth=(20, 30), module=2.0, face_width=10.0, addendum=1.1)
    assert len([remark for remark in both.remarks if "addendum" in remark]) == 1


def test_undercut_that_shortens_contact_is_said():
    assert any("undercut" in remark for remark in GearPair(teeth=(10, 60), module=2.0, face_width=10.0).remarks)
    assert not GearPair(teeth=(20, 60), module=2.0, face_width=10.0).remarks


@pytest.mark.parametrize("root", ["radial", "fillet"])
def test_sliding_without_bounds_is_left_out(root):
    """Radial roots let contact go down to the base circles, on either member, where sliding has no bounds."""
    found = _values(GearPair(teeth=(7, 7), module=0.5, face_width=2.0, backlash=0.025, root=root))
    assert ("gear_specific_sliding" in found) == ("pinion_specific_sliding" in found) == (root == "fillet")
    assert all(np.isfinite(value) for value in found.values())

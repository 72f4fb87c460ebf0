"""What bevel gears and pairs refuse, with the limit and the way out; a limit that is told can be used."""

import re

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.errors import ParameterError

GEAR = {"teeth": 24, "module": 3.0, "mate_teeth": 36, "face_width": 16.0}
PAIR = {"teeth": (20, 40), "module": 3.0, "face_width": 20.0}
HUB = {"bore": 14.0, "hub_diameter": 32.0}
WEB = {**HUB, "rim_diameter": 40.0, "web_thickness": 7.0}
MILLED = {"trace": "circular", "spiral_angle": 35.0, "cutter_radius": 50.0}
HOBBED = {"trace": "epicycloid", "spiral_angle": 30.0, "cutter_radius": 70.0, "blade_groups": 5}


def problems_of(base, more):
    with pytest.raises(ParameterError) as refusal:
        (BevelPair if base is PAIR else BevelGear)(**{**base, **more})
    return {problem.subject: problem.message for problem in refusal.value.problems}


def builds(base, more):
    """Whether what is accepted is a sound solid."""
    element = (BevelPair if base is PAIR else BevelGear)(**{**base, **more})
    parts = (element.pinion, element.gear) if base is PAIR else (element,)
    return all(part.boundary.patches and part.properties().volume > 0.0 for part in parts)


REFUSED = [
    (GEAR, {**MILLED, "cutter_radius": 6.0}, "cutter_radius", ("arc of this cutter", "cutter_radius at least")),
    (
        GEAR,
        {"trace": "involute", "spiral_angle": 20.0, "face_width": 25.0},
        "spiral_angle",
        ("base circle", "at least"),
    ),
    (GEAR, {"trace": "skew", "spiral_angle": 70.0}, "spiral_angle", ("straight lines", "at most")),
    (GEAR, {"teeth": 8, "taper": "uniform"}, "addendum", ("comes to a point", "inner end", "less than")),
    (GEAR, {"crown_tip_radius": 2.0}, "crown_tip_radius", ("at most", "round all over")),
    (GEAR, {"crown_tip_radius": 2.0, "taper": "uniform"}, "crown_tip_radius", ("at most 0.599", "inner end", "land")),
    (
        GEAR,
        {"addendum_angle": 10.0, "pitch_angle": 3.0, "mate_teeth": None, "face_width": 90.0},
        "addendum",
        ("no flank",),
    ),
    (GEAR, {"standard": "iso-23509", "iso_method": 0, "bore": 60.0}, "bore", ("roots",)),
    (GEAR, {"bore": 60.0}, "bore", ("cuts into the tooth roots", "less than")),
    (GEAR, {"mounting_distance": 120.0}, "mounting_distance", ("beyond", "axis", "less than", "hub_diameter")),
    (GEAR, {"mounting_distance": 120.0, "bore": 18.0}, "mounting_distance", ("bore", "less than")),
    (GEAR, {"mounting_distance": 40.0}, "mounting_distance", ("cut the teeth", "more than")),
    (GEAR, {**HUB, "mounting_distance": 45.0}, "mounting_distance", ("inside the body", "at least")),
    (
        GEAR,
        {**HUB, "mounting_distance": 90.0, "hub_length": 20.0},
        "mounting_distance",
        ("beyond the hub", "joins them"),
    ),
    (GEAR, {"ends": "flat", "mounting_distance": 70.0}, "mounting_distance", ("flat ends", "conical", "hub_diameter")),
    (GEAR, {**HUB, "hub_diameter": 12.0}, "hub_diameter", ("no wall around the bore", "more than")),
    (GEAR, {**HUB, "hub_diameter": 90.0}, "hub_diameter", ("back face", "less than")),
    (GEAR, {**HUB, "hub_length": 2.0}, "hub_length", ("inside the body", "at least")),
    (GEAR, {**WEB, "rim_diameter": 44.0}, "rim_diameter", ("no rim", "less than")),
    (GEAR, {**WEB, "rim_diameter": 30.0}, "rim_diameter", ("no web", "more than hub_diameter")),
    (GEAR, {**WEB, "web_thickness": 40.0}, "web_thickness", ("thicker than the body", "at most")),
    (GEAR, {**WEB, "web_holes": 4, "web_hole_diameter": 9.0}, "web_hole_diameter", ()),
    (GEAR, {"bore": 14.0, "keyway_width": 5.0, "keyway_depth": 20.0}, "keyway_depth", ("corners", "tooth roots")),
    (GEAR, {**HUB, "keyway_width": 5.0, "keyway_depth": 9.5}, "hub_diameter", ("bore and keyway", "more than")),
    (GEAR, {"bore": 3.0, "keyway": "din-6885"}, "keyway", ("DIN 6885", "over", "keyway_width")),
    (GEAR, {"normal_backlash": 12.0}, "normal_backlash", ("leaves no tooth",)),
    (GEAR, {"normal_backlash": 0.1, "backlash": 0.1}, "backlash", ("normal_backlash", "only one")),
    (GEAR, {"crowning": 4.0}, "crowning", ("leaves no tooth", "less than 1.668 mm")),
    (GEAR, {"tip_relief": 0.05, "tip_relief_height": 9.0}, "tip_relief_height", ("below the flank", "less than")),
    (GEAR, {"tip_relief_height": 1.0}, "tip_relief_height", ("goes with tip_relief",)),
    (GEAR, {"taper": "uniform", "addendum_angle": 1.0}, "addendum_angle", ("taper", "only one")),
    (GEAR, {"taper": "uniform", "dedendum_angle": 1.0}, "dedendum_angle", ("taper", "only one")),
    (GEAR, {"taper": "duplex"}, "taper", ("iso-23509", "uniform")),
    (GEAR, {"standard": "equal-addendum", "taper": "tilted"}, "taper", ("iso-23509", "uniform")),
    (GEAR, {"standard": "gleason-spiral"}, "standard", ("usually 35°", "gleason-straight")),
    (GEAR, {"standard": "gleason-straight", **MILLED}, "standard", ("without spiral angle", "gleason-spiral")),
    (GEAR, {"standard": "gleason-straight", "mate_teeth": None, "pitch_angle": 30.0}, "standard", ("mate_teeth",)),
    (GEAR, {"standard": "gleason-straight", "addendum": 3.0}, "addendum", ("explicit",)),
    (GEAR, {"standard": "gleason-straight", "dedendum_angle": 3.0}, "dedendum_angle", ("explicit",)),
    (GEAR, {"standard": "iso-23509", **HOBBED, "taper": "duplex"}, "taper", ("uniform",)),
    (GEAR, {"profile_shift": 0.3}, "profile_shift", ("equal-addendum or iso-23509",)),
    (GEAR, {"ends": "spherical", **HUB}, "hub_diameter", ("plane faces", "conical", "flat", "leave it out")),
    (GEAR, {"ends": "spherical", "mounting_distance": 60.0}, "mounting_distance", ("plane faces",)),
    (GEAR, {"ends": "flat", "mate_teeth": None, "pitch_angle": 89.5}, "ends", ("conical",)),
    (GEAR, {"hub_length": 30.0}, "hub_length", ("give hub_diameter",)),
    (GEAR, {"root": "radial", "crown_tip_radius": 0.3}, "crown_tip_radius", ("fillet",)),
    (PAIR, {"normal_backlash": 12.0}, "normal_backlash", ("leaves no tooth",)),
    (PAIR, {"standard": "gleason-spiral"}, "standard", ("usually 35°",)),
    (PAIR, {"bore": (10.0, 90.0)}, "gear bore", ("cuts into the tooth roots",)),
    (PAIR, {"mounting_distance": (150.0, None)}, "pinion mounting_distance", ("beyond",)),
]


@pytest.mark.parametrize(("base", "more", "subject", "words"), REFUSED, ids=lambda value: str(value)[:60])
def test_what_cannot_be_is_refused_with_the_way_out(base, more, subject, words):
    found = problems_of(base, more)
    named = {known.split(" = ")[0]: message for known, message in found.items()}
    assert subject in named, found
    for word in words:
        assert word in named[subject]


def test_several_are_told_in_one_error():
    found = problems_of(
        GEAR, {"bore": 60.0, "crowning": 4.0, "backlash": 0.1, "normal_backlash": 0.1, "tip_relief_height": 1.0}
    )
    names = {subject.split(" = ")[0] for subject in found}
    assert names >= {"bore", "crowning", "backlash", "tip_relief_height"}
    found = problems_of(GEAR, {"ends": "spherical", **HUB, "keyway_width": 4.0, "keyway_depth": 2.0})
    assert {subject.split(" = ")[0] for subject in found} == {"hub_diameter", "keyway_width", "keyway_depth"}


LIMITS = [
    (GEAR, {**MILLED}, "cutter_radius", 6.0),
    (GEAR, {"trace": "involute", "face_width": 25.0}, "spiral_angle", 20.0),
    (GEAR, {"trace": "skew"}, "spiral_angle", 70.0),
    (GEAR, {"crown_tip_radius": 0.2, "teeth": 12, "taper": "uniform", "tooth_form": "octoid"}, "addendum", 4.5),
    (GEAR, {}, "crown_tip_radius", 2.0),
    (GEAR, {"taper": "uniform"}, "crown_tip_radius", 2.0),
    (GEAR, {"crowning": 0.05}, "crown_tip_radius", 2.0),
    (GEAR, {"ends": "flat", "addendum_angle": 1.0, "dedendum_angle": 5.0}, "crown_tip_radius", 2.0),
    (GEAR, {}, "bore", 60.0),
    (GEAR, {"ends": "flat"}, "bore", 60.0),
    (GEAR, {"ends": "spherical"}, "bore", 60.0),
    (GEAR, {"taper": "uniform"}, "bore", 60.0),
    (GEAR, {}, "mounting_distance", 120.0),
    (GEAR, {}, "mounting_distance", 40.0),
    (GEAR, {"bore": 18.0}, "mounting_distance", 120.0),
    (GEAR, HUB, "mounting_distance", 45.0),
    (GEAR, {**HUB, "hub_length": 20.0}, "mounting_distance", 90.0),
    (GEAR, HUB, "hub_diameter", 12.0),
    (GEAR, HUB, "hub_diameter", 90.0),
    (GEAR, {**HUB, "keyway_width": 5.0, "keyway_depth": 2.3}, "hub_diameter", 12.0),
    (GEAR, HUB, "hub_length", 2.0),
    (GEAR, {**HUB, "hub_diameter": 45.0, "mounting_distance": 60.0}, "hub_length", 60.0),
    (GEAR, WEB, "rim_diameter", 44.0),
    (GEAR, WEB, "rim_diameter", 30.0),
    (GEAR, WEB, "web_thickness", 40.0),
    (GEAR, {"tip_relief": 0.05, "crown_tip_radius": 0.3}, "tip_relief_height", 9.0),
    (GEAR, {"teeth": 60, "mate_teeth": 12, "root": "radial"}, "circular_thickness", 8.0),
]


@pytest.mark.parametrize(("base", "more", "name", "wrong"), LIMITS, ids=lambda value: str(value)[:60])
def test_a_limit_that_is_told_can_be_used_and_no_more(base, more, name, wrong):
    """What is told is rounded to the safe side: it is accepted, and builds; a thousandth beyond it is refused."""
    message = next(
        text for subject, text in problems_of(base, {**more, name: wrong}).items() if subject.startswith(name)
    )
    side, number = re.search(r"(at most|at least|less than|more than)[^0-9]*([0-9.]+[0-9])", message).groups()
    limit = float(number)
    beyond = 1.002 if side in ("at most", "less than") else 0.998
    inside = limit if side.startswith("at") else limit * (2.0 - beyond)
    assert builds(base, {**more, name: inside})
    problems_of(base, {**more, name: limit * beyond})


CHANGING = [
    ({"teeth": 18, "mate_teeth": 40}, ("undercut begins partway", "cone distance", 'root = "radial"')),
    ({"teeth": 40, "mate_teeth": 60, "root": "radial"}, ("roots pass", "partway", 'root = "fillet"')),
]


@pytest.mark.parametrize(("more", "words"), CHANGING, ids=lambda value: str(value)[:60])
def test_teeth_that_change_their_kind_partway_are_refused_before_they_are_built(more, words):
    (subject, message), *others = problems_of(GEAR, {**more, "taper": "uniform"}).items()
    assert subject.startswith("dedendum")
    assert not others
    for word in words:
        assert word in message
    assert builds(GEAR, {**more, "taper": "standard"})


@pytest.mark.parametrize(
    "more", [{"taper": "uniform"}, {"crowning": 0.03, "circular_thickness": 3.6}, {"dedendum_angle": 1.0}], ids=str
)
def test_usual_tip_radii_leave_room_where_teeth_vary(more):
    """Where a quarter of the module does not fit at one end: the largest that does would leave no land there."""
    gear = BevelGear(teeth=40, module=2.0, pitch_angle=85.0, face_width=9.0, pressure_angle=25.0, **more)
    assert gear.generating_tip_radius < 0.5
    lands = [tooth.fillet.crown_tip.land for tooth in gear.bevel_teeth.looked_at.values()]
    assert min(lands) > 1e-4 * max(lands)
    assert gear.boundary.patches


def test_a_pair_s_members_are_sound_when_the_pair_is():
    pair = BevelPair(**PAIR, standard="iso-23509", **{**HOBBED, "cutter_radius": 60.0})
    assert pair.clearance > 0.0
    for part in (pair.pinion, pair.gear):
        assert np.isclose(part.proportions.addendum_angle, 0.0)
        assert part.boundary.patches


NO_TEETH = [
    (
        BevelGear,
        {"teeth": 20, "mate_teeth": 10, "face_width": 10.0, "taper": "uniform", "ends": "spherical"},
        "face_width",
    ),
    (
        BevelGear,
        {
            "teeth": 36,
            "pitch_angle": 90.0,
            "face_width": 15.087,
            "ends": "spherical",
            "root": "radial",
            "tooth_form": "octoid",
            "dedendum_angle": 15.34656,
        },
        "face_width",
    ),
    (BevelGear, {"teeth": 39, "pitch_angle": 90.0, "face_width": 8.0, "ends": "flat"}, "ends"),
    (BevelGear, {"teeth": 20, "mate_teeth": 40, "face_width": 6.0, "bore": 1e-7}, "bore"),
    (
        BevelPair,
        {"teeth": (3, 3), "module": 1.25, "whole_depth": 4.0, "face_width": 0.59, "root": "radial"},
        "whole_depth",
    ),
]


@pytest.mark.parametrize(("element", "given", "name"), NO_TEETH, ids=str)
def test_sizes_far_from_any_gear_s_are_refused_as_parameters(element, given, name):
    with pytest.raises(ParameterError) as refusal:
        element(**{"module": 1.0, **given})
    assert refusal.value.element == element.__name__
    assert [problem.subject.split(" ")[0] for problem in refusal.value.problems] == [name]


@pytest.mark.parametrize(
    ("more", "names"),
    [
        ({"pressure_angle": 40.0}, ["gear_addendum", "working_depth"]),
        ({"pressure_angle": 35.0}, ["whole_depth"]),
        ({"pressure_angle": 40.0, "standard": "equal-addendum"}, ["standard"]),
        ({"pressure_angle": 40.0, "standard": "equal-addendum", "profile_shift": 0.1}, ["profile_shift"]),
    ],
    ids=str,
)
def test_pairs_are_told_of_parameters_that_they_have(more, names):
    found = problems_of(PAIR, more)
    assert sorted({subject.split(" ")[0] for subject in found}) == names
    assert all("it makes" in message and "mm: the" in message for message in found.values())


def test_contact_ends_where_undercut_does():
    """Of 8 and 40 teeth: 1.61 from tip to tip, 0.90 of it on flanks that are there; the pair says so."""
    pair = BevelPair(teeth=(8, 40), module=3.0, face_width=14.0)
    assert pair.sizes()["contact_ratio"].value == pytest.approx(0.90033, abs=1e-5)
    assert any("contact ratio is 0.9" in remark for remark in pair.remarks)
    assert any("8 teeth are undercut" in remark for remark in pair.remarks)


def test_a_keyway_takes_its_slot_and_nothing_else():
    given = {**GEAR, "bore": 20.0, "mounting_distance": 60.0, "hub_diameter": 34.0}
    plain, keyed = BevelGear(**given), BevelGear(**given, keyway="din-6885")
    assert plain.body.front == keyed.body.front
    sizes = keyed.sizes()
    width, radius = sizes["keyway_width"].value, 10.0
    floor = radius + sizes["keyway_depth"].value
    # the rectangle from the floor to the bore's chord, less the segment between chord and bore
    chord = np.sqrt(radius**2 - width**2 / 4.0)
    segment = radius**2 * np.arcsin(width / 2.0 / radius) - width / 2.0 * chord
    slot = (width * (floor - chord) - segment) * (keyed.body.back - keyed.body.front)
    assert plain.properties().volume - keyed.properties().volume == pytest.approx(slot, rel=1e-9)


def test_zerol_teeth_take_gleasons_proportions_for_straight_ones():
    zerol = {"trace": "circular", "cutter_radius": 60.0, "standard": "gleason-straight"}
    assert builds(PAIR, zerol)
    (message,) = problems_of(PAIR, {**zerol, "standard": "gleason-spiral"}).values()
    assert "gleason-straight" in message

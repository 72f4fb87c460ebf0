"""Pairs that cannot run are refused with what is wrong, a limit that is true, and the way out."""

import re

import pytest

from gearwright.elements.cylindrical.gear_pair import GearPair
from gearwright.errors import ParameterError

SPUR = {"teeth": (20, 30), "module": 2.0, "face_width": 10.0}
HELICAL = {**SPUR, "kind": "helical", "helix_angle": 15.0}
HERRINGBONE = {**HELICAL, "kind": "herringbone"}
INTERNAL = {**SPUR, "kind": "internal", "teeth": (20, 60)}
RACK = {**SPUR, "kind": "rack", "teeth": (20, 8)}
BASES = {"spur": SPUR, "helical": HELICAL, "herringbone": HERRINGBONE, "internal": INTERNAL, "rack": RACK}
MISSING = ...


def _refusal(of, **changes):
    values = {**BASES[of], **changes}
    with pytest.raises(ParameterError) as caught:
        GearPair(**{name: value for name, value in values.items() if value is not MISSING})
    assert caught.value.element == "GearPair"
    return caught.value


CASES = [
    ("spur", {"kind": "spurr"}, "kind = 'spurr'", ("choose one of", "did you mean spur")),
    ("spur", {"teeth": (20, 2)}, "teeth = (20, 2)", ("at least 3 each",)),
    ("spur", {"teeth": 20}, "teeth = 20", ("two values", "pinion first")),
    ("spur", {"module": MISSING}, "module", ("give one of",)),
    ("spur", {"diametral_pitch": 12.7}, "module = 2 mm", ("give one of",)),
    ("spur", {"helix_angle": 10.0}, "helix_angle = 10°", ("does not apply with kind = 'spur'", "leave it out")),
    ("spur", {"hand": "left"}, "hand = 'left'", ("does not apply",)),
    ("spur", {"outer_diameter": 90.0}, "outer_diameter = 90 mm", ("with internal",)),
    ("spur", {"fillet_radius": 0.5}, "fillet_radius = 0.5 mm", ("internal or rack",)),
    ("helical", {"rack_height": 9.0}, "rack_height = 9 mm", ("with rack",)),
    ("internal", {"rack_height": 9.0}, "rack_height = 9 mm", ("with rack",)),
    ("rack", {"tip_diameter": (44.0, 64.0)}, "tip_diameter = (44 mm, 64 mm)", ("does not apply",)),
    ("rack", {"outer_diameter": 90.0}, "outer_diameter = 90 mm", ("with internal",)),
    ("helical", {"helix_angle": MISSING}, "helix_angle", ("is needed",)),
    ("herringbone", {"helix_angle": MISSING}, "helix_angle", ("is needed",)),
    ("herringbone", {"face_width": (10.0, 12.0)}, "face_width = (10 mm, 12 mm)", ("mid-face", "one value")),
    ("rack", {"profile_shift": (0.2, 0.3)}, "profile_shift = (0.2, 0.3)", ("a rack has none", "pinion's")),
    ("rack", {"bore": (8.0, 8.0)}, "bore = (8 mm, 8 mm)", ("a rack has none",)),
    ("rack", {"tip_relief": (0.02, 0.02)}, "tip_relief = (0.02 mm, 0.02 mm)", ("a rack has none",)),
    ("internal", {"bore": (8.0, 8.0)}, "bore = (8 mm, 8 mm)", ("an internal gear has none",)),
    ("internal", {"rack_tip_radius": (0.5, 0.5)}, "rack_tip_radius = (0.5 mm, 0.5 mm)", ("an internal gear has none",)),
    ("internal", {"teeth": (20, 20)}, "teeth = (20, 20)", ("more teeth than its pinion",)),
    ("internal", {"teeth": (30, 20)}, "teeth = (30, 20)", ("more teeth than its pinion",)),
    ("internal", {"teeth": (57, 60)}, "teeth = (57, 60)", ("interference", "larger difference")),
    (
        "spur",
        {"teeth": (8, 60), "root": "radial"},
        "teeth = (8, 60)",
        ("interference", "gear's tips", "pinion's teeth"),
    ),
    ("rack", {"teeth": (10, 8), "root": "radial"}, "teeth = (10, 8)", ("interference", "gear's tips")),
    ("spur", {"centre_distance": 46.5}, "centre_distance = 46.5 mm", ("too near", "more than 46.9847 mm")),
    ("spur", {"centre_distance": 60.0}, "centre_distance = 60 mm", ("3.71 modules", "50 mm")),
    ("rack", {"centre_distance": 26.0}, "centre_distance = 26 mm", ("3 modules", "20 mm")),
    ("internal", {"centre_distance": 46.0}, "centre_distance = 46 mm", ("modules", "40 mm")),
    ("internal", {"centre_distance": 37.0}, "centre_distance = 37 mm", ("too near",)),
    (
        "spur",
        {"centre_distance": 56.0, "profile_shift": 0.0},
        "centre_distance = 56 mm",
        ("do not meet", "nearer"),
    ),
    ("spur", {"profile_shift": -1.0}, "profile_shift = -1.0", ("their sum must be more than -1.0237",)),
    ("internal", {"profile_shift": (0.0, 1.4)}, "profile_shift = (0.0, 1.4)", ("sum must be less than 0.8189",)),
    ("spur", {"profile_shift": (1.3, 0.0)}, "pinion profile_shift = 1.3", ("leaves no dedendum", "1.25")),
    ("spur", {"profile_shift": (0.0, 1.3)}, "gear profile_shift = 1.3", ("leaves no dedendum",)),
    ("spur", {"teeth": (200, 300), "profile_shift": -4.0, "dedendum": 12.0}, "addendum", ("leaves no addendum",)),
    ("spur", {"centre_distance": 54.9}, "centre_distance = 54.9 mm", ("1.57 modules of each", "50 mm")),
    ("rack", {"centre_distance": 23.0}, "centre_distance = 23 mm", ("1.5 modules of the pinion", "20 mm")),
    ("spur", {"addendum": 2.6}, "addendum = 2.6 mm", ("reach", "shorter addendum", "0.1 mm beyond")),
    ("spur", {"circular_thickness": (3.3, 3.0)}, "centre_distance", ("0.01681 mm thicker", "thinner teeth")),
    ("spur", {"bore": (10.0, 56.0)}, "gear bore = 56 mm", ("less than the root diameter, 55 mm",)),
    ("spur", {"tip_relief_height": 1.0}, "tip_relief_height = 1 mm", ("goes with tip_relief",)),
    ("spur", {"tip_relief": (0.1, 0.0), "tip_relief_height": (1.0, 1.0)}, "gear tip_relief_height", ("goes with",)),
]


@pytest.mark.parametrize(("kind", "changes", "subject", "words"), CASES, ids=[f"{c[0]} {c[1]}" for c in CASES])
def test_refused_with_what_why_and_the_way_out(kind, changes, subject, words):
    error = _refusal(kind, **changes)
    own = [problem for problem in error.problems if problem.subject.startswith(subject)]
    assert own, str(error)
    assert any(all(word in problem.message for word in words) for problem in own), str(error)
    assert "nan" not in str(error)


def test_all_problems_are_named_together():
    error = _refusal(
        "herringbone", helix_angle=MISSING, face_width=(10.0, 12.0), backlash=-1.0, rack_height=3.0, bore=(1.0, 0.0)
    )
    subjects = {problem.subject.split(" = ")[0] for problem in error.problems}
    assert subjects == {"helix_angle", "face_width", "backlash", "rack_height", "bore"}


def test_both_members_are_named_where_each_is_wrong():
    error = _refusal("spur", bore=(36.0, 56.0))
    assert [problem.subject for problem in error.problems] == ["pinion bore = 36 mm", "gear bore = 56 mm"]


JAMMED = [
    ("spur", {"centre_distance": 49.1, "profile_shift": 0.0}, -1),
    ("spur", {"centre_distance": 49.1, "profile_shift": (0.31, -0.17)}, -1),
    ("helical", {"centre_distance": 51.0, "profile_shift": (0.31, 0.17)}, -1),
    ("helical", {"teeth": (17, 23), "centre_distance": 41.1, "circular_thickness": (3.5, 3.1)}, -1),
    ("internal", {"centre_distance": 40.4, "profile_shift": 0.0}, 1),
    ("internal", {"centre_distance": 40.2, "profile_shift": (0.1, 0.03)}, 1),
    ("rack", {"centre_distance": 19.7, "profile_shift": 0.0}, -1),
    ("rack", {"centre_distance": 20.3, "profile_shift": 0.37}, -1),
]


@pytest.mark.parametrize(("kind", "changes", "side"), JAMMED)
def test_the_distance_quoted_for_a_jam_is_true(kind, changes, side):
    """Followed to the letter it is accepted, with next to no backlash; a hundred thousandth nearer it jams again."""
    message = _refusal(kind, **changes).problems[0].message
    assert "thicker than the pitch" in message
    word = "at least" if side < 0 else "at most"
    limit = float(re.search(rf"a distance of {word} ([0-9.]+) mm", message).group(1))
    shifts = {} if "circular_thickness" not in changes else {"profile_shift": 0.0}
    pair = GearPair(**{**BASES[kind], **shifts, **changes, "centre_distance": limit})
    assert -1e-12 <= pair.sizes()["backlash"].value < 1e-3
    again = _refusal(kind, **{**shifts, **changes, "centre_distance": limit * (1.0 + side * 1e-5)})
    assert "thicker than the pitch" in again.problems[0].message


def test_the_excess_of_a_jam_is_what_the_teeth_are_too_thick():
    values = {"centre_distance": 49.5, "profile_shift": 0.0}
    excess = float(re.search(r"together ([0-9.]+) mm", _refusal("spur", **values).problems[0].message).group(1))
    thickness = GearPair(**SPUR).pinion.sizes()["circular_thickness"].value
    on_pitch_circles = excess * 50.0 / 49.5
    for share, fits in ((1.001, True), (0.999, False)):
        thin = {**values, "circular_thickness": (thickness, thickness - share * on_pitch_circles)}
        if fits:
            GearPair(**{**SPUR, **thin})
        else:
            _refusal("spur", **thin)


def test_the_least_distance_quoted_is_true():
    """Just outside it involutes have a line of action, and other reasons are given."""
    limit = float(re.search(r"more than ([0-9.]+)", str(_refusal("spur", centre_distance=46.0))).group(1))
    assert "too near" in str(_refusal("spur", centre_distance=limit * (1.0 - 3e-6)))
    assert "too near" not in str(_refusal("spur", centre_distance=limit * (1.0 + 1e-9)))


@pytest.mark.parametrize("kind", ["spur", "helical", "internal", "rack"])
def test_how_far_tips_reach_beyond_roots(kind):
    """The gear's dedendum is 1.25 modules, 2.5 mm."""
    error = _refusal(kind, addendum_coefficient=(1.26, 0.8))
    assert "the pinion's tips reach the gear's roots, 0.02 mm beyond" in str(error)


@pytest.mark.parametrize("shift", [0.4, (0.4, 0.0)])
def test_a_rack_needs_no_second_value(shift):
    pair = GearPair(**RACK, profile_shift=shift, bore=8.0, tip_relief=(0.02, 0.0))
    assert pair.sizes()["centre_distance"].value == pytest.approx(20.8)


def test_one_relief_height_does_for_the_member_that_is_relieved():
    pair = GearPair(**SPUR, tip_relief=(0.02, 0.0), tip_relief_height=1.0)
    assert pair.pinion.relief is not None
    assert pair.gear.relief is None


@pytest.mark.parametrize(("kind", "word", "way"), [("spur", "more than", -1.0), ("internal", "less than", 1.0)])
def test_the_sum_of_shifts_quoted_is_true(kind, word, way):
    """Just beyond it there is no distance; just before it other reasons are given."""
    shifts = {"spur": -0.8, "internal": 0.7}[kind]
    quoted = re.search(rf"sum must be {word} (-?[0-9.]+)", str(_refusal(kind, profile_shift=shifts)))
    limit = float(quoted.group(1))
    assert "no centre distance" in str(_refusal(kind, profile_shift=(limit + 2e-4 * way, 0.0)))
    assert "no centre distance" not in str(_refusal(kind, profile_shift=(limit, 0.0), dedendum=0.1))


@pytest.mark.parametrize(
    "values",
    [
        {"kind": "internal", "teeth": (20, 50), "addendum_coefficient": 1.1},
        {"kind": "internal", "teeth": (8, 38), "addendum_coefficient": 1.1},
        {"teeth": (8, 100), "root": "radial"},
    ],
    ids=["internal", "small pinion", "radial roots"],
)
def test_relief_hides_no_interference(values):
    """What is relieved begins on the involute, which cuts as before."""
    given = {"module": 1.0, "face_width": 1.0, "tip_shortening": "none", **values}
    for relief in ({}, {"tip_relief": 0.05, "tip_relief_height": 0.05}):
        with pytest.raises(ParameterError, match="interference"):
            GearPair(**given, **relief)

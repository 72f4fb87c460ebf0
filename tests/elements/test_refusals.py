"""Impossible parameters are refused with all problems at once: what, the limit, why, and the way out."""

import re

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.errors import ParameterError

SPUR = {"teeth": 16, "module": 8.0, "face_width": 50.0}
BEVEL = {"teeth": 20, "pitch_angle": 45.0, "module": 4.0, "face_width": 15.0, "root": "radial", "ends": "spherical"}
PAIR = {"teeth": (16, 20), "module": 4.0, "face_width": 15.0, "root": "radial", "ends": "spherical"}
BASES = {SpurGear: SPUR, BevelGear: BEVEL, BevelPair: PAIR}
ALL = tuple(BASES)
MISSING = ...


def _refusal(element, **changes):
    values = {**BASES[element], **changes}
    with pytest.raises(ParameterError) as caught:
        element(**{name: value for name, value in values.items() if value is not MISSING})
    assert caught.value.element == element.__name__
    return caught.value


def _refusals(cases):
    """Cases (elements, changes, subject, words of the message) as one parameter set an element."""
    return [
        pytest.param(element, *case[1:], id=f"{element.__name__} {', '.join(f'{k}={v}' for k, v in case[1].items())}")
        for case in cases
        for element in (case[0] if isinstance(case[0], tuple) else (case[0],))
    ]


NUMBERS = ["face_width", "pressure_angle", "backlash", "module"]
SINGLE_VALUES = [
    *[(ALL, {name: float("nan")}, f"{name} = nan", ("finite",)) for name in NUMBERS],
    *[(ALL, {name: float("inf")}, f"{name} = inf", ("finite",)) for name in NUMBERS],
    *[(ALL, {name: "15"}, f"{name} = '15'", ("a number is needed",)) for name in NUMBERS],
    *[(ALL, {name: True}, f"{name} = True", ("a number is needed", "bool")) for name in NUMBERS],
    *[(ALL, {name: [15.0, 16.0, 17.0]}, f"{name} = (15", ("one value",)) for name in NUMBERS],
    *[(ALL, {name: -1.0}, f"{name} = -1", ()) for name in NUMBERS],
    *[(ALL, {name: None}, name, ("needed",)) for name in ("face_width", "pressure_angle", "backlash", "teeth")],
    (ALL, {"face_width": 0.0}, "face_width = 0 mm", ("greater than 0",)),
    (ALL, {"backlash": -0.1}, "backlash = -0.1 mm", ("at least 0",)),
    (ALL, {"pressure_angle": 60.0}, "pressure_angle = 60°", ("less than 60",)),
    (ALL, {"pressure_angle": 0.0}, "pressure_angle = 0°", ("greater than 0",)),
    (ALL, {"bore": 0.0}, "bore = 0 mm", ("greater than 0",)),
    (ALL, {"root": "filet"}, "root = 'filet'", ("radial",)),
    (ALL, {"root": None}, "root", ("radial",)),
    (ALL, {"length_unit": "cm"}, "length_unit = 'cm'", ("mm", "in")),
    (ALL, {"length_unit": ("mm", "in")}, "length_unit", ("one value",)),
    (ALL, {"module": MISSING}, "module", ("give one of", "diametral_pitch")),
    (ALL, {"diametral_pitch": 2.0}, "module = ", ("give one of", "diametral_pitch")),
    ((BevelGear, BevelPair), {"trace": "curvic"}, "trace = 'curvic'", ("straight", "epicycloid")),
    ((BevelGear, BevelPair), {"trace": "circular"}, "cutter_radius", ("is needed", "1.1 to 1.4 ×", "mm")),
    ((BevelGear, BevelPair), {"trace": "circular", "cutter_radius": 0.0}, "cutter_radius = 0", ("greater than 0",)),
    ((BevelGear, BevelPair), {"cutter_radius": 60.0}, "cutter_radius = 60 mm", ("circular or epicycloid",)),
    ((BevelGear, BevelPair), {"blade_groups": 5}, "blade_groups = 5", ("epicycloid", "leave it out")),
    (
        (BevelGear, BevelPair),
        {"trace": "circular", "cutter_radius": 60.0, "blade_groups": 5},
        "blade_groups = 5",
        ("but with epicycloid",),
    ),
    (
        (BevelGear, BevelPair),
        {"trace": "epicycloid", "cutter_radius": 60.0, "spiral_angle": 30.0},
        "blade_groups",
        ("is needed", "such as 5"),
    ),
    (
        (BevelGear, BevelPair),
        {"trace": "epicycloid", "cutter_radius": 60.0, "blade_groups": 0},
        "blade_groups = 0",
        ("at least 1",),
    ),
    *[
        ((BevelGear, BevelPair), {"trace": trace}, "spiral_angle = 0°", ("needs one", "straight", "zerol"))
        for trace in ("skew", "logarithmic", "involute")
    ],
    ((BevelGear, BevelPair), {"hand": "up"}, "hand = 'up'", ("right", "left")),
    ((BevelGear, BevelPair), {"ends": "round"}, "ends = 'round'", ("conical", "spherical", "flat")),
    ((BevelGear, BevelPair), {"spiral_angle": 35.0}, "spiral_angle = 35°", ("straight", "logarithmic", "circular")),
    (
        (BevelGear, BevelPair),
        {"trace": "logarithmic", "spiral_angle": 76.0},
        "spiral_angle = 76°",
        ("at most 75",),
    ),
    ((SpurGear, BevelGear), {"teeth": 2}, "teeth = 2", ("at least 3",)),
    ((SpurGear, BevelGear), {"teeth": 16.5}, "teeth = 16.5", ("whole number",)),
    ((SpurGear, BevelGear), {"teeth": (16, 20)}, "teeth = (16, 20)", ("one value",)),
    ((SpurGear, BevelGear), {"teeth": 10_001}, "teeth = 10001", ("at most 10000",)),
    (BevelPair, {"teeth": (16, 2)}, "teeth = (16, 2)", ("at least 3 each",)),
    (BevelPair, {"teeth": 16}, "teeth = 16", ("two values", "pinion first")),
    (BevelPair, {"teeth": (16,)}, "teeth = (16)", ("two members", "pinion first")),
    (BevelPair, {"teeth": (16, 20, 24)}, "teeth = (16, 20, 24)", ("two members",)),
    (BevelPair, {"teeth": (16, None)}, "teeth = (16, None)", ("whole number",)),
    (BevelPair, {"bore": (10.0, 20.0, 30.0)}, "bore = (10 mm, 20 mm, 30 mm)", ("two members",)),
    (BevelPair, {"shaft_angle": 180.0}, "shaft_angle = 180°", ("less than 180",)),
    (BevelPair, {"shaft_angle": None}, "shaft_angle", ("number is needed",)),
]

TOGETHER = [
    (BevelGear, {"face_width": 60.0}, "face_width = 60 mm", ("cone distance, 56.56 mm", "17 mm", "usual", "the most")),
    (BevelPair, {"face_width": 60.0}, "face_width = 60 mm", ("cone distance, 51.22 mm",)),
    (SpurGear, {"addendum": 20.0}, "addendum = 20 mm", ("comes to a point", "less than", "thicker tooth")),
    (BevelGear, {"addendum": 20.0}, "addendum = 20 mm", ("comes to a point", "less than", "thicker tooth")),
    (SpurGear, {"dedendum": 64.0}, "dedendum = 64 mm", ("less than the pitch radius, 64 mm",)),
    (BevelGear, {"dedendum": 70.0}, "dedendum = 70 mm", ("pass the axis", "less than 56.56 mm")),
    (
        SpurGear,
        {"circular_thickness": 24.0},
        "circular_thickness = 24 mm",
        ("neighbouring teeth meet", "half the pitch"),
    ),
    (SpurGear, {"dedendum": 35.0}, "dedendum = 35 mm", ("rack", "point before its tip", "less than 17.26 mm")),
    (SpurGear, {"rack_tip_radius": 6.0}, "rack_tip_radius = 6 mm", ("at most 3.775 mm", "round all over")),
    (SpurGear, {"rack_tip_coefficient": 0.6}, "rack_tip_coefficient = 0.6", ("at most", "0.4719 modules")),
    (SpurGear, {"root": "radial", "rack_tip_radius": 1.0}, "rack_tip_radius = 1 mm", ("fillets", "Leave it out")),
    (SpurGear, {"profile_shift": 1.3}, "profile_shift = 1.3", ("no dedendum", "less than", "1.25")),
    (SpurGear, {"tip_diameter": 120.0}, "tip_diameter = 120 mm", ("no addendum",)),
    (SpurGear, {"tip_diameter": 160.0}, "tip_diameter = 160 mm", ("comes to a point",)),
    (SpurGear, {"tip_diameter": 150.0, "addendum": 8.0}, "tip_diameter = 150 mm", ("says the same as addendum",)),
    (SpurGear, {"dedendum": 9.0, "dedendum_coefficient": 1.2}, "dedendum = 9 mm", ("dedendum_coefficient",)),
    (SpurGear, {"teeth": 4, "dedendum": 14.0}, "teeth = 4", ("undercut", "nothing is left", "larger profile shift")),
    (SpurGear, {"span_teeth": 7}, "span_teeth = 7", ("do not touch the flanks", "1 to 3 is possible")),
    (SpurGear, {"pin_diameter": 4.0}, "pin_diameter = 4 mm", ("do not touch", "13.82 mm is usual")),
    (SpurGear, {"tip_chamfer": 7.0}, "tip_chamfer = 7 mm", ("nothing of the tip",)),
    (SpurGear, {"tip_relief": 0.1, "tip_relief_height": 30.0}, "tip_relief_height = 30 mm", ("below the flank",)),
    (SpurGear, {"tip_relief": 9.0}, "tip_relief = 9 mm", ("nothing of the tip", "less than")),
    (SpurGear, {"tip_relief_height": 3.0}, "tip_relief_height = 3 mm", ("goes with tip_relief",)),
    (BevelGear, {"circular_thickness": 12.0}, "circular_thickness = 12 mm", ("neighbouring teeth meet",)),
    (SpurGear, {"backlash": 26.0}, "backlash = 26 mm", ("no tooth", "less than 25.13 mm")),
    (BevelGear, {"backlash": 100.0}, "backlash = 100 mm", ("no tooth", "less than 12.56 mm")),
    (BevelPair, {"backlash": 100.0}, "backlash = 100 mm", ("no tooth", "less than 12.56 mm")),
    (SpurGear, {"bore": 120.0}, "bore = 120 mm", ("root", "less than", "108 mm")),
    (BevelGear, {"bore": 60.0}, "bore = 60 mm", ("root", "small end", "less than", "53.38 mm")),
    (BevelPair, {"bore": (45.0, 10.0)}, "pinion bore = 45 mm", ("39.54 mm",)),
    (BevelPair, {"bore": (10.0, 55.0)}, "gear bore = 55 mm", ("51.9 mm",)),
    (BevelGear, {"pitch_angle": MISSING}, "pitch_angle", ("either the pitch angle, or mate_teeth",)),
    (BevelGear, {"mate_teeth": 20}, "pitch_angle = 45°", ("either the pitch angle, or mate_teeth",)),
    (BevelGear, {"shaft_angle": 80.0}, "shaft_angle = 80°", ("goes with mate_teeth",)),
    (
        BevelGear,
        {"pitch_angle": MISSING, "mate_teeth": 10, "shaft_angle": 150.0},
        "shaft_angle = 150°",
        ("126.2°", "internal bevel", "smaller shaft angle"),
    ),
    (BevelPair, {"shaft_angle": 170.0}, "shaft_angle = 170°", ("136.8°", "internal bevel", "closer to each other")),
    (BevelPair, {"whole_depth": 8.0}, "whole_depth = 8 mm", ("working depth, 8 mm", "clearance")),
    (BevelPair, {"gear_addendum": 8.0}, "gear_addendum = 8 mm", ("working depth, 8 mm", "pinion's addendum")),
    (
        BevelPair,
        {"teeth": (9, 40)},
        "gear_addendum",
        ("interference", "gear's tip", "at most", "more teeth or a larger pressure angle"),
    ),
    (BevelPair, {"teeth": (40, 9)}, "working_depth", ("interference", "pinion's tip", "at most", "more teeth")),
    (
        BevelPair,
        {"circular_thickness": (6.5, 6.2)},
        "circular_thickness = (6.5 mm, 6.2 mm)",
        ("interference", "12.7 mm thick", "12.57 mm", "thinner"),
    ),
]


@pytest.mark.parametrize(("element", "changes", "subject", "words"), _refusals(SINGLE_VALUES + TOGETHER))
def test_refused_with_what_why_and_the_way_out(element, changes, subject, words):
    error = _refusal(element, **changes)
    own = [problem for problem in error.problems if problem.subject.startswith(subject)]
    assert len(own) == 1, str(error)
    assert all(word in own[0].message for word in words), own[0].message
    assert "nan" not in own[0].message
    assert not re.search(r"(less than|at most) -", own[0].message), "no length is less than a negative one"
    assert str(error).startswith(f"{element.__name__} cannot be built from these parameters:\n  ")


@pytest.mark.parametrize("element", ALL, ids=lambda element: element.__name__)
def test_all_problems_are_named_together(element):
    wrong = {
        "teeth": (2, 2) if element is BevelPair else 2,
        "face_width": -1.0,
        "pressure_angle": "20",
        "backlash": float("nan"),
        "bore": True,
        "root": "cut",
        "length_unit": "ft",
        "diametral_pitch": 3.0,
    }
    if element is not SpurGear:
        wrong |= {"trace": "wavy", "hand": "both", "ends": "none"}
    subjects = [problem.subject.split(" = ")[0] for problem in _refusal(element, **wrong).problems]
    assert sorted(subjects) == sorted(name if name != "diametral_pitch" else "module" for name in wrong)


def test_limits_are_named_together_too():
    error = _refusal(SpurGear, addendum=20.0, circular_thickness=24.0, teeth=2, bore=500.0)
    assert {problem.subject.split(" = ")[0] for problem in error.problems} >= {"teeth"}
    error = _refusal(BevelGear, face_width=60.0, teeth=20, bore=-1.0, pressure_angle=90.0)
    assert {problem.subject.split(" = ")[0] for problem in error.problems} >= {"bore", "pressure_angle"}
    error = _refusal(BevelPair, teeth=(16, 2), face_width=90.0)
    assert {problem.subject.split(" = ")[0] for problem in error.problems} >= {"teeth", "face_width"}


def test_interference_is_found_for_both_members():
    error = _refusal(BevelPair, pressure_angle=5.0)
    assert [problem.subject for problem in error.problems] == ["working_depth", "gear_addendum"]


LIMITS = [
    (SpurGear, "addendum", 30.0, {}),
    (SpurGear, "dedendum", 70.0, {"root": "radial"}),
    (SpurGear, "rack_tip_radius", 9.0, {}),
    (SpurGear, "tip_relief_height", 20.0, {"tip_relief": 0.05}),
    (SpurGear, "tip_relief", 9.0, {}),
    (SpurGear, "profile_shift", 2.0, {"addendum": 3.0}),
    (SpurGear, "bore", 200.0, {}),
    (SpurGear, "circular_thickness", 24.0, {"addendum": 2.0}),
    (SpurGear, "circular_thickness", 24.0, {"root": "radial"}),
    (SpurGear, "circular_thickness", 25.0, {"root": "radial", "backlash": 1.0}),
    (SpurGear, "backlash", 30.0, {"addendum": 0.001, "dedendum": 2.0}),
    (BevelGear, "addendum", 30.0, {}),
    (BevelGear, "addendum", 30.0, {"pitch_angle": 90.0}),
    (BevelGear, "addendum", 30.0, {"backlash": 0.5, "pressure_angle": 14.5}),
    (BevelGear, "dedendum", 70.0, {}),
    (BevelGear, "bore", 200.0, {}),
    (BevelGear, "bore", 200.0, {"pitch_angle": 90.0}),
    (BevelGear, "circular_thickness", 24.0, {}),
    (BevelGear, "circular_thickness", 24.0, {"backlash": 1.0}),
    (BevelGear, "face_width", 60.0, {}),
    (BevelGear, "backlash", 30.0, {"addendum": 0.001}),
    (BevelGear, "spiral_angle", 80.0, {"trace": "logarithmic"}),
    (BevelGear, "pitch_angle", 99.0, {}),
    (BevelPair, "face_width", 60.0, {}),
    (BevelPair, "bore", 60.0, {}),
    (BevelPair, "gear_addendum", 4.0, {"teeth": (12, 40), "working_depth": 5.0}),
]


@pytest.mark.parametrize(("element", "name", "wrong", "others"), LIMITS)
def test_limits_quoted_are_true(element, name, wrong, others):
    """Two thousandths inside the limit the part is built, and its volume positive; as much outside it is refused."""
    first = _refusal(element, **others, **{name: wrong}).problems[0]
    assert name.split("_")[-1] in first.subject
    quoted = re.search(r"(?:less than|at most|more than)[^0-9]*([0-9.]+)", first.message)
    limit = float(quoted.group(1))
    inside = element(**{**BASES[element], **others, name: limit * 0.998})
    for part in (inside.pinion, inside.gear) if element is BevelPair else (inside,):
        assert part.properties().volume > 0.0
    again = _refusal(element, **others, **{name: limit * 1.002}).problems[0]
    assert quoted.group(0) in again.message


def test_whole_depth_may_be_just_more_than_the_working_depth():
    assert BevelPair(**PAIR, whole_depth=8.001).pinion.properties().volume > 0.0


def test_teeth_may_be_numpy_integers_and_lengths_numpy_floats():
    gear = SpurGear(teeth=np.int64(16), module=np.float64(8.0), face_width=50)
    assert gear.properties().volume == SpurGear(**SPUR).properties().volume


def test_a_float_is_no_number_of_teeth():
    assert "whole number" in str(_refusal(SpurGear, teeth=16.0))


def test_lists_do_for_tuples():
    by_list, by_tuple = (BevelPair(**{**PAIR, "teeth": teeth}) for teeth in ([16, 20], (16, 20)))
    assert by_list.gear.properties().volume == by_tuple.gear.properties().volume

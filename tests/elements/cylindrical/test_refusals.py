"""Cylindrical gears that do not exist are refused by the parameter to change, and the limits quoted are true."""

import re

import pytest

from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.elements.cylindrical.rack import Rack
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.errors import ParameterError

BASES = {
    SpurGear: {"teeth": 16, "module": 8.0, "face_width": 50.0},
    HelicalGear: {"teeth": 17, "module": 2.0, "face_width": 9.0, "helix_angle": 20.0},
    HerringboneGear: {"teeth": 17, "module": 2.0, "face_width": 9.0, "helix_angle": 20.0},
    InternalGear: {"teeth": 40, "module": 2.0, "face_width": 6.0},
    Rack: {"teeth": 5, "module": 4.0, "face_width": 10.0},
}
TWISTED = (HelicalGear, HerringboneGear, InternalGear, Rack)


def _refusal(element, **changes):
    with pytest.raises(ParameterError) as caught:
        element(**{name: value for name, value in {**BASES[element], **changes}.items() if value is not ...})
    assert caught.value.element == element.__name__
    return caught.value


CASES = [
    *[(kind, {"transverse_module": 2.0}, "module", "give one of module") for kind in TWISTED],
    *[(kind, {"module": ...}, "module", "transverse_module (mm) and diametral_pitch") for kind in TWISTED],
    *[(kind, {"helix_angle": 81.0}, "helix_angle = 81°", "at most 80") for kind in TWISTED],
    *[(kind, {"helix_angle": -5.0}, "helix_angle = -5°", "at least 0") for kind in TWISTED],
    *[(kind, {"hand": "up"}, "hand = 'up'", "right, left") for kind in TWISTED],
    *[(kind, {"helix_angle": None}, "helix_angle", "needed") for kind in (HelicalGear, HerringboneGear)],
    *[
        (kind, {"addendum": 1.5, "addendum_coefficient": 0.9}, "addendum = 1.5 mm", "says the same as")
        for kind in BASES
    ],
    *[(kind, {"basic_rack": "jis"}, "basic_rack = 'jis'", "iso-53-a") for kind in BASES],
    (SpurGear, {"profile_shift": -1.0}, "addendum", "leaves no addendum"),
    (SpurGear, {"profile_shift": -3.0, "addendum": 1.0}, "profile_shift = -3", "no tooth on the pitch circle"),
    (SpurGear, {"addendum": 0.5, "dedendum": 0.5}, "rack_tip_radius", "no involute between fillet and tip"),
    (SpurGear, {"teeth": 3, "pressure_angle": 5.0}, "teeth = 3", "undercut until nothing is left"),
    (SpurGear, {"tip_chamfer": 20.0}, "tip_chamfer = 20 mm", "less than"),
    (SpurGear, {"crowning": 5.0}, "crowning = 5 mm", "nothing of the tips at the ends; less than 2.224 mm"),
    (SpurGear, {"pin_diameter": 40.0}, "pin_diameter = 40 mm", "13.82 mm is usual"),
    (HelicalGear, {"span_teeth": 30}, "span_teeth = 30", "1 to 4 is possible"),
    (HelicalGear, {"bore": 60.0}, "bore = 60 mm", "root"),
    (InternalGear, {"addendum": 9.0}, "addendum = 9 mm", "below the base circle"),
    (InternalGear, {"tip_diameter": 60.0}, "tip_diameter = 60 mm", "below the base circle"),
    (InternalGear, {"circular_thickness": 0.5}, "addendum", "comes to a point"),
    (InternalGear, {"dedendum": 5.0}, "dedendum = 5 mm", "flanks of a space meet"),
    (InternalGear, {"fillet_radius": 2.0}, "fillet_radius = 2 mm", "at most 0.8222 mm"),
    (InternalGear, {"root": "radial", "fillet_radius": 1.0}, "fillet_radius = 1 mm", 'root = "radial" has none'),
    (InternalGear, {"outer_diameter": 85.0}, "outer_diameter = 85 mm", "greater than the root diameter, 85 mm"),
    (InternalGear, {"tip_chamfer": 5.0}, "tip_chamfer = 5 mm", "higher than the flank"),
    (InternalGear, {"tip_chamfer": 3.0}, "tip_chamfer = 3 mm", "nothing of the tip"),
    (InternalGear, {"profile_shift": 1.25}, "profile_shift = 1.25", "no dedendum"),
    (InternalGear, {"pin_diameter": 9.0}, "pin_diameter = 9 mm", "3.36 mm is usual"),
    (InternalGear, {"teeth": 18}, "addendum", "more teeth"),
    (Rack, {"dedendum": 9.0}, "circular_thickness", "neighbouring teeth meet"),
    (Rack, {"circular_thickness": 12.0}, "circular_thickness = 12 mm", "less than 8.926 mm"),
    (Rack, {"fillet_radius": 3.0}, "fillet_radius = 3 mm", "at most 1.887 mm"),
    (
        Rack,
        {"dedendum": 0.1, "fillet_radius": 0.2, "addendum": 0.01},
        "fillet_radius = 0.2 mm",
        "no straight flank; a smaller one",
    ),
    (Rack, {"rack_height": 5.0}, "rack_height = 5 mm", "greater than the dedendum, 5 mm"),
    (Rack, {"backlash": 13.0}, "backlash = 13 mm", "no tooth"),
]


@pytest.mark.parametrize(("element", "changes", "subject", "words"), CASES)
def test_refused_by_what_to_change(element, changes, subject, words):
    error = _refusal(element, **changes)
    own = [problem for problem in error.problems if problem.subject.startswith(subject)]
    assert len(own) == 1, str(error)
    assert words in own[0].message


LIMITS = [
    (SpurGear, "crowning", 5.0, {}),
    (SpurGear, "tip_chamfer", 20.0, {"pressure_angle": 5.0, "addendum": 2.0, "root": "radial"}),
    (SpurGear, "circular_thickness", 26.0, {"backlash": 1.0, "root": "radial", "dedendum": 0.01, "addendum": 0.01}),
    (HelicalGear, "rack_tip_radius", 3.0, {}),
    (HelicalGear, "addendum", 9.0, {}),
    (HelicalGear, "tip_relief_height", 9.0, {"tip_relief": 0.02}),
    (HelicalGear, "crowning", 5.0, {}),
    (InternalGear, "addendum", 9.0, {}),
    (InternalGear, "addendum", 9.0, {"helix_angle": 20.0}),
    (InternalGear, "dedendum", 9.0, {"root": "radial"}),
    (InternalGear, "fillet_radius", 2.0, {}),
    (InternalGear, "fillet_radius", 2.0, {"dedendum": 2.0}),
    (InternalGear, "crowning", 2.0, {}),
    (InternalGear, "tip_relief", 2.0, {}),
    (InternalGear, "tip_relief_height", 9.0, {"tip_relief": 0.02}),
    (InternalGear, "backlash", 9.0, {"addendum": 0.001}),
    (InternalGear, "outer_diameter", 20.0, {}),
    (Rack, "addendum", 9.0, {}),
    (Rack, "circular_thickness", 12.0, {}),
    (Rack, "circular_thickness", 12.0, {"backlash": 0.5}),
    (Rack, "fillet_radius", 3.0, {"helix_angle": 25.0}),
    (Rack, "backlash", 15.0, {"addendum": 0.001, "fillet_radius": 0.1}),
    (Rack, "rack_height", 1.0, {}),
]


@pytest.mark.parametrize(("element", "name", "wrong", "others"), LIMITS)
def test_limits_quoted_are_true(element, name, wrong, others):
    """Two thousandths inside the limit the part is built, and its volume positive; as much outside it is refused."""
    (problem,) = (one for one in _refusal(element, **others, **{name: wrong}).problems if name in one.subject)
    quoted = re.search(r"(less than|at most|greater than)[^0-9]*([0-9.]+)", problem.message)
    limit = float(quoted.group(2))
    step = -0.002 if quoted.group(1) == "greater than" else 0.002
    part = element(**{**BASES[element], **others, name: limit * (1.0 - step)})
    assert part.properties().volume > 0.0
    again = _refusal(element, **others, **{name: limit * (1.0 + step)})
    assert any(quoted.group(0) in one.message for one in again.problems)


@pytest.mark.parametrize("element", [SpurGear, InternalGear], ids=lambda element: element.__name__)
def test_crowned_teeth_need_a_land_at_the_root(element):
    name, tooth = ("rack_tip_radius", "fillet") if element is SpurGear else ("fillet_radius", None)
    plain = element(**BASES[element]).tooth
    largest = plain.fillet.rack_tip.largest_radius if tooth else plain.largest_fillet_radius
    error = _refusal(element, crowning=0.02, **{name: largest})
    assert "crowning = 0.02 mm" in str(error)
    assert "needs a land at the root" in str(error)
    assert element(**BASES[element], crowning=0.02, **{name: 0.99 * largest}).properties().volume > 0.0


@pytest.mark.parametrize(
    ("values", "subject", "words"),
    [
        (
            {"teeth": 3, "addendum_coefficient": 0.5, "crowning": 0.4},
            "crowning = 0.4 mm",
            "waists of the undercut teeth",
        ),
        (
            {"teeth": 24, "module": 2.0, "tip_relief": 0.1, "tip_relief_height": 2.0, "pin_diameter": 4.2},
            "pin",
            "unrelieved",
        ),
        (
            {"teeth": 24, "module": 2.0, "tip_relief": 0.1, "tip_relief_height": 2.0, "span_teeth": 4},
            "span",
            "do not touch",
        ),
        ({"teeth": 24, "module": 2.0, "dedendum_coefficient": 0.5, "pin_diameter": 3.456}, "pin", "stand on the roots"),
        (
            {"teeth": 12, "pressure_angle": 45.0, "profile_shift": 1.0},
            "profile_shift = 1",
            "no space between the teeth",
        ),
        ({"teeth": 1e-320}, "teeth", "whole number"),
        ({"teeth": 1e308}, "teeth", "whole number"),
        ({"profile_shift": 1e308}, "profile_shift", "at most 5"),
    ],
    ids=lambda value: ", ".join(value) if isinstance(value, dict) else "",
)
def test_gears_that_once_were_built_or_broke(values, subject, words):
    with pytest.raises(ParameterError) as caught:
        SpurGear(**{"teeth": 20, "module": 1.0, "face_width": 10.0, **values})
    (problem,) = caught.value.problems
    assert problem.subject.startswith(subject)
    assert words in problem.message


def test_the_limit_of_crowning_at_a_waist_is_true():
    gear = SpurGear(teeth=3, module=1.0, face_width=10.0, addendum_coefficient=0.5, crowning=0.24)
    assert gear.properties().volume > 0.0


@pytest.mark.parametrize(
    "values",
    [
        {"teeth": 12, "module": 2.0, "pressure_angle": 14.5, "basic_rack": "agma-full-radius"},
        {"teeth": 4, "module": 1.0, "pressure_angle": 14.5, "basic_rack": "agma-full-radius"},
        {"teeth": 12, "module": 1.0, "basic_rack": "iso-53-d", "dedendum_coefficient": 2.0},
    ],
    ids=["14.5°", "14.5°, four teeth", "deep"],
)
def test_racks_round_all_over_are_sound(values):
    """Where rounding left a land of 1e-16."""
    rack = Rack(face_width=5.0, **values)
    rack.profile.require_simple()
    assert rack.polyhedron().properties().volume == pytest.approx(rack.properties().volume, rel=1e-3)

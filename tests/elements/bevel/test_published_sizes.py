"""Sizes of a pair against a maker's tables, from Python and from the command line.

KHK, Gear Technical Reference, tables for straight bevel gears: m = 3, z = 20/40, Σ = 90°, b = 22, by Gleason and with
standard heights; to the digits given there.
"""

import json

import pytest

from gearwright.cli import main
from gearwright.elements.bevel.bevel_pair import BevelPair

PAIR = {"teeth": (20, 40), "module": 3.0, "face_width": 22.0}
PUBLISHED = {
    "equal-addendum": {
        "pitch_angle": (26.56505, 63.43495),
        "cone_distance": (67.08204, 67.08204),
        "addendum": (3.0, 3.0),
        "dedendum": (3.75, 3.75),
        "addendum_angle": (2.56064, 2.56064),
        "dedendum_angle": (3.19960, 3.19960),
        "face_angle": (29.12569, 65.99559),
        "outside_diameter": (65.3666, 122.6833),
        "crown_to_apex": (58.6584, 27.3167),
        "axial_face_width": (19.2374, 8.9587),
        "inner_tip_diameter": (43.9292, 82.4485),
    },
    "gleason-straight": {
        "pitch_angle": (26.56505, 63.43495),
        "cone_distance": (67.08204, 67.08204),
        "addendum": (4.035, 1.965),
        "dedendum": (2.529, 4.599),
        "outside_diameter": (67.2180, 121.7575),
        "crown_to_apex": (58.1955, 28.2425),
    },
}
every_row = pytest.mark.parametrize(
    ("standard", "name"), [(standard, name) for standard, rows in PUBLISHED.items() for name in rows]
)


def _digits(name):
    return 0.6e-5 if name.endswith("angle") or name == "cone_distance" else 0.6e-4


@every_row
def test_sizes_of_both_members(standard, name):
    pair = BevelPair(**PAIR, standard=standard)
    found = [member.sizes()[name].value for member in (pair.pinion, pair.gear)]
    assert found == pytest.approx(PUBLISHED[standard][name], abs=_digits(name))


@pytest.mark.parametrize("standard", PUBLISHED)
def test_the_command_line_says_the_same(standard, capsys):
    words = ["bevel", "--teeth", "20", "40", "--module", "3", "--face-width", "22", "--standard", standard, "--json"]
    assert main(words) == 0
    captured = capsys.readouterr()
    found = json.loads(captured.out)
    for name, values in PUBLISHED[standard].items():
        sizes = [found[member]["sizes"][name]["value"] for member in ("pinion", "gear")]
        assert sizes == pytest.approx(values, abs=_digits(name))
    assert found["pair"]["sizes"]["gear_ratio"]["value"] == 2.0


def test_gleason_s_roots_run_parallel_to_the_mate_s_tips():
    """θ_a1 = θ_f2 and θ_a2 = θ_f1: the clearance is the same along the face."""
    pair = BevelPair(**PAIR, standard="gleason-straight")
    one, other = pair.pinion.sizes(), pair.gear.sizes()
    assert one["addendum_angle"].value == pytest.approx(other["dedendum_angle"].value, rel=1e-12)
    assert other["addendum_angle"].value == pytest.approx(one["dedendum_angle"].value, rel=1e-12)
    assert pair.clearance == pytest.approx(0.188 * 3.0, rel=1e-12)

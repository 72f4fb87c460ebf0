"""Programmes: what is read, and what is refused with its place."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearwright.elements.cams.laws import FIXED_LAWS
from gearwright.elements.cams.programme import displacement, read_programme

THESIS = "dwell 36, rise 72, dwell 144, return 108"


def _problems(text, total=30.0):
    return read_programme(text, total, "mm")[1]


def test_the_thesis_s_programme():
    steps, problems = read_programme(THESIS, 30.0, "degrees")
    assert not problems
    assert [(s.kind, s.angle, s.start, s.change) for s in steps] == [
        ("dwell", 36.0, 0.0, 0.0),
        ("rise", 72.0, 0.0, 30.0),
        ("dwell", 144.0, 30.0, 0.0),
        ("return", 108.0, 30.0, -30.0),
    ]


def test_amounts_part_the_way():
    steps, problems = read_programme(" Rise 72 20 ,rise 30.5° 1e1, return 150 , dwell 107.5", 30.0, "mm")
    assert not problems
    assert [s.change for s in steps] == [20.0, 10.0, -30.0, 0.0]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", 'part 1, "": it begins with none of dwell, rise, return'),
        (
            "rise 180, retrun 180",
            'part 2, "retrun 180": it begins with none of dwell, rise, return; did you mean return?',
        ),
        ("rise, return 360", 'part 1, "rise": a rise has an angle in degrees and, if it does not go all the way'),
        ("dwell 36 5, rise 144, return 180", 'part 1, "dwell 36 5": a dwell has an angle in degrees, separated'),
        ("rise -20, return 380", 'part 1, "rise -20": "-20" is not a number greater than 0'),
        ("rise nan, return 180", '"nan" is not a number'),
        ("rise 0, return 360", '"0" is not a number greater than 0'),
        ("rise 1e999, return 3", '"1e999" is not a number'),
        ("rise 180 20 dwell 30, return 150", "parts are separated by commas"),
        ("return 180, rise 180", 'part 1, "return 180": the follower is at the start already, at 0 mm'),
        ("rise 90, rise 90, return 180", 'part 2, "rise 90": the follower is at the top already, at 30 mm'),
        ("rise 90 40, return 270", 'part 1, "rise 90 40": only 30 mm are left to go from 0 mm'),
        ("rise 90, return 270 31", 'part 2, "return 270 31": only 30 mm are left to go from 30 mm'),
        ("rise 180, return 190", "its angles make 370°, 10° too many; a turn of the cam is 360°"),
        ("rise 180, return 170", "its angles make 350°, 10° too few"),
        ("dwell 360", "nothing moves; a rise and a return are needed"),
        ("rise 180, return 180 10", "it ends 20 mm above its start; end it with a return"),
        ("rise 180 10, return 180", "it reaches 10 of 30 mm; let a rise reach the top"),
    ],
)
def test_refusals(text, said):
    (problem,) = _problems(text)
    assert said in problem


def test_several_parts_are_refused_together():
    assert [p[:6] for p in _problems("dwel 20, rise x, dwell 100, back 3")] == ["part 1", "part 2", "part 4"]


@settings(max_examples=200, deadline=None)
@given(st.text(alphabet="riseturndwl 0123456789.,°-e", max_size=40))
def test_any_text_is_read_or_refused(text):
    steps, problems = read_programme(text, 30.0, "mm")
    assert problems or sum(step.angle for step in steps) == pytest.approx(360.0)


@pytest.mark.parametrize("law", FIXED_LAWS)
def test_a_displacement_is_periodic_and_its_velocity_continuous(law):
    steps, _ = read_programme("rise 100 12, dwell 40, rise 60, return 160", 30.0, "mm")
    found = displacement(steps, [FIXED_LAWS[law]] * 3, 1.0)
    for place in [0.0, *np.radians([100.0, 140.0, 200.0, 360.0])]:
        before, after = (found.derivatives(place + shift) for shift in (-1e-9, 1e-9))
        np.testing.assert_allclose(before[:2], after[:2], atol=1e-6)
    np.testing.assert_allclose(found.derivatives(np.radians([100.0, 140.0, 200.0]))[0], [12.0, 12.0, 30.0])
    np.testing.assert_allclose(found.derivatives(np.array([1.0, 1.0 + 4.0 * np.pi])).T[0], found.derivatives(1.0))

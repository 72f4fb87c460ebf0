"""Tooth traces of bevel gears from their parameters: sizes, mates, and limits that are true."""

import re
from dataclasses import replace

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.bevel.spiral import Spiral
from gearwright.errors import ParameterError

PAIR = {"teeth": (16, 20), "module": 4.0, "face_width": 16.0}
GEAR = {"teeth": 16, "mate_teeth": 20, "module": 4.0, "face_width": 16.0}
TRACES = {
    "skew": {"spiral_angle": 35.0},
    "logarithmic": {"spiral_angle": 35.0},
    "circular": {"spiral_angle": 35.0, "cutter_radius": 50.0},
    "involute": {"spiral_angle": 40.0},
    "epicycloid": {"spiral_angle": 35.0, "cutter_radius": 50.0, "blade_groups": 5},
}
every_trace = pytest.mark.parametrize("trace", TRACES)


@every_trace
@pytest.mark.parametrize("shaft_angle", [60.0, 90.0, 110.0])
def test_mates_have_one_trace_on_the_crown_gear_and_opposite_hands(trace, shaft_angle):
    pair = BevelPair(**PAIR, trace=trace, **TRACES[trace], shaft_angle=shaft_angle)
    pinion, gear = pair.pinion, pair.gear
    assert (pinion.hand, gear.hand) == ("right", "left")
    r = np.linspace(pinion.inner_distance, pinion.cone_distance, 9)
    crown = [one.tooth_trace.turn(r) * np.sin(one.pitch_cone_angle) for one in (pinion, gear)]
    np.testing.assert_allclose(crown[0], -crown[1], rtol=0.0, atol=1e-14)
    assert crown[0][-1] > 0.05


@every_trace
def test_spiral_angles_of_toe_mean_and_heel_are_those_of_the_flank_s_trace(trace):
    """Between the line that the turn of the section draws on the pitch cone and its generators."""
    gear = BevelGear(**GEAR, trace=trace, **TRACES[trace])
    sizes = gear.sizes()
    places = np.array([gear.inner_distance, gear.mean_distance, gear.cone_distance])
    h = np.array([1e-4, 0.0, -1e-4])
    turned = gear.tooth_trace.turn(places + h + 1e-4) - gear.tooth_trace.turn(places + h - 1e-4)
    steepness = (places + h) * np.sin(gear.pitch_cone_angle) * turned / 2e-4
    found = [sizes[f"{name}_spiral_angle"].value for name in ("inner", "mean", "outer")]
    np.testing.assert_allclose(found, np.degrees(np.arctan(steepness)), atol=2e-3)
    assert found[1] == pytest.approx(TRACES[trace]["spiral_angle"], rel=1e-15)
    assert sizes["outer_spiral_angle"].symbol == "β_e"


def test_sizes_are_those_published():
    """r_m 81.273, b 25.4, β_m 35°, r_c 114.3: 33.94556° and 36.84579°."""
    pitch_angle = 30.0
    module = 2.0 * (81.273 + 12.7) * np.sin(np.radians(pitch_angle)) / 20
    gear = BevelGear(
        teeth=20,
        module=module,
        pitch_angle=pitch_angle,
        face_width=25.4,
        trace="circular",
        spiral_angle=35.0,
        cutter_radius=114.3,
    )
    sizes = gear.sizes()
    assert sizes["inner_spiral_angle"].value == pytest.approx(33.94556, abs=5e-6)
    assert sizes["outer_spiral_angle"].value == pytest.approx(36.84579, abs=5e-6)


def test_a_face_hobbed_crown_gear_turns_by_a_pitch_while_the_cutter_turns_by_a_blade_group():
    """The trace is drawn by a blade on a cutter that turns z_p/z₀ times as fast, at 30° to the mean radius."""
    values = {"spiral_angle": 30.0, "cutter_radius": 55.0, "blade_groups": 7, "hand": "left"}
    gear = BevelGear(teeth=21, module=3.0, pitch_angle=40.0, face_width=14.0, trace="epicycloid", **values)
    mean, sine = gear.mean_distance, np.sin(np.radians(40.0))
    faster = (21 / sine) / 7
    normal_module = 2.0 * mean * np.cos(np.radians(30.0)) * sine / 21
    lead = np.arcsin(7 * normal_module / (2.0 * 55.0))
    centre = mean + 55.0j * np.exp(1j * (np.radians(30.0) - lead))
    t = np.linspace(-0.05, 0.05, 21)
    points = np.exp(1j * t) * (centre + (mean - centre) * np.exp(1j * faster * t))
    np.testing.assert_allclose(gear.tooth_trace.turn(np.abs(points)), -np.angle(points) / sine, atol=1e-13)
    steepness = np.gradient(np.angle(points), np.abs(points), edge_order=2)[10] * mean
    assert np.degrees(np.arctan(steepness)) == pytest.approx(30.0, abs=0.01)


def test_straight_teeth_have_no_spiral_angles():
    assert not [name for name in BevelGear(**GEAR).sizes() if "spiral" in name]


def test_descriptions_tell_zerol_teeth_from_straight_ones():
    zerol = {"trace": "circular", "cutter_radius": 50.0}
    assert "right-hand spiral 0°" in BevelGear(**GEAR, **zerol).description
    assert "spiral" not in BevelGear(**GEAR).description
    assert "circular spiral 0°" in BevelPair(**PAIR, **zerol).description
    assert "straight" in BevelPair(**PAIR).description


def _refused(element, values):
    with pytest.raises(ParameterError) as caught:
        element(**values)
    (problem,) = caught.value.problems
    return problem


LIMITS = [
    {"trace": "circular", "spiral_angle": 35.0, "cutter_radius": 5.0},
    {"trace": "circular", "spiral_angle": 0.0, "cutter_radius": 6.0},
    {"trace": "circular", "spiral_angle": 70.0, "cutter_radius": 30.0},
    {"trace": "circular", "spiral_angle": 75.0, "cutter_radius": 60.0},
    {"trace": "epicycloid", "spiral_angle": 35.0, "cutter_radius": 9.0, "blade_groups": 13},
    {"trace": "epicycloid", "spiral_angle": 35.0, "cutter_radius": 9.0, "blade_groups": 1},
    {"trace": "involute", "spiral_angle": 20.0},
    {"trace": "skew", "spiral_angle": 60.0},
]


@pytest.mark.parametrize("values", LIMITS, ids=str)
@pytest.mark.parametrize("element", [BevelGear, BevelPair])
def test_limits_told_are_accepted_and_just_beyond_them_nothing_is(element, values):
    values = {**(GEAR if element is BevelGear else PAIR), **values}
    problem = _refused(element, values)
    assert problem.subject.startswith("spiral_angle" if "cutter_radius" not in values else "cutter_radius")
    told = re.findall(r"(\w+) (at least|at most) ([0-9.]+)", problem.message)
    assert told
    for name, side, number in told:
        limit = float(number)
        inside = element(**{**values, name: limit})
        gear = inside if element is BevelGear else inside.gear
        assert gear.properties().volume > 0.0
        assert max(abs(gear.sizes()[f"{end}_spiral_angle"].value) for end in ("inner", "outer")) <= 80.0
        beyond = limit * (0.998 if side == "at least" else 1.002)
        assert f"{name} {side} {number}" in _refused(element, {**values, name: beyond}).message


def test_the_involute_s_limit_is_its_base_circle():
    """b (1 − cos β/2) = R_e (1 − cos β)."""
    message = _refused(BevelGear, {**GEAR, "trace": "involute", "spiral_angle": 20.0}).message
    told = float(re.search(r"face_width at most ([0-9.]+) mm", message).group(1))
    cosine, outer = np.cos(np.radians(20.0)), BevelGear(**GEAR).cone_distance
    assert told == pytest.approx(outer * (1.0 - cosine) / (1.0 - cosine / 2.0), rel=2e-4)


def test_a_body_beyond_its_cone_distances_needs_a_longer_trace():
    """A cutter just large enough for the face is too small for a body that goes a few per cent beyond."""
    spiral = Spiral(
        trace="circular",
        spiral_angle=35.0,
        hand="right",
        cutter_radius=15.0,
        blade_groups=None,
        teeth=16,
        pitch_angle=0.67,
        cone_distance=51.2,
        face_width=16.0,
    )
    assert spiral.fits
    assert not replace(spiral, stretch=(1.0, 1.1)).fits
    assert not replace(spiral, stretch=(0.6, 1.0)).fits
    assert replace(spiral, stretch=(1.0, 1.001)).fits


def test_where_nothing_alone_would_do_two_changes_are_told():
    values = {"trace": "epicycloid", "spiral_angle": 74.5, "cutter_radius": 1.2, "blade_groups": 36}
    message = _refused(BevelGear, {**GEAR, "face_width": 40.0, **values}).message
    assert "narrower face and a cutter_radius of about 31.2 mm" in message
    message = _refused(BevelGear, {**GEAR, "face_width": 46.0, "trace": "involute", "spiral_angle": 0.3}).message
    assert "narrower face and a spiral_angle of 35°" in message


@pytest.mark.parametrize("unit", ["mm", "in"])
def test_usual_cutters_are_told_and_fit(unit):
    scale = 1.0 if unit == "mm" else 1.0 / 25.4
    values = {**GEAR, "face_width": 16.0 * scale, "length_unit": unit, "trace": "circular", "spiral_angle": 35.0}
    message = _refused(BevelGear, values).message
    least, most = map(float, re.search(rf"here ([0-9.]+) to ([0-9.]+) {unit}", message).groups())
    mean = BevelGear(**{**values, "cutter_radius": least}).mean_distance
    assert BevelGear(**{**values, "cutter_radius": most}).properties().volume > 0.0
    assert (least / mean, most / mean) == pytest.approx((1.1, 1.4), rel=1e-3)


def test_a_missing_cutter_is_told_beside_other_problems():
    """Though the mean cone distance is not known."""
    for element, values in ((BevelGear, GEAR), (BevelPair, PAIR)):
        with pytest.raises(ParameterError) as caught:
            element(**{**values, "module": -1.0, "trace": "epicycloid"})
        assert [p.subject.split(" ")[0] for p in caught.value.problems] == ["module", "cutter_radius", "blade_groups"]

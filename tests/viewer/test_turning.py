"""How members move, as the viewer is told, is how they mesh at any turn."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.viewer.turning import STEP, Turning

PAIRS = {
    "spur": gw.GearPair(teeth=(17, 30), module=2, face_width=10),
    "internal": gw.GearPair(teeth=(18, 54), module=2, face_width=10, kind="internal"),
    "rack": gw.GearPair(teeth=(17, 30), module=2, face_width=10, kind="rack"),
    "bevel": gw.BevelPair(teeth=(16, 20), module=4, face_width=15, shaft_angle=75),
}
# of the gear, in degrees about its own axis for one of the pinion; z of all but the rack points as the pinion's does
RATIOS = {"spur": -17 / 30, "internal": 18 / 54, "rack": 0.0, "bevel": -16 / 20}


def turnings(pair):
    return [Turning.between(*two) for two in zip(pair.placements(), pair.placements(STEP), strict=True)]


def placed(at_rest, turning, degrees):
    angle = np.radians(turning.spin * degrees)
    moved = np.eye(4)
    moved[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    moved[:3, 3] = np.array(turning.slide) * degrees
    return at_rest @ moved


@pytest.mark.parametrize("degrees", [-180.0, -33.3, 7.0, 180.0])
@pytest.mark.parametrize("name", PAIRS)
def test_spin_and_slide_give_the_placements_at_every_turn(name, degrees):
    pair = PAIRS[name]
    for at_rest, turning, wanted in zip(pair.placements(), turnings(pair), pair.placements(degrees), strict=True):
        np.testing.assert_allclose(placed(at_rest, turning, degrees), wanted, atol=1e-9)


@pytest.mark.parametrize("name", PAIRS)
def test_the_gear_follows_by_the_ratio_of_teeth(name):
    pinion, gear = turnings(PAIRS[name])
    assert pinion == Turning(spin=pytest.approx(1.0, abs=1e-11))
    assert gear.spin == pytest.approx(RATIOS[name], abs=1e-11)


def test_a_rack_slides_by_the_arc_of_the_pitch_circle():
    pair = PAIRS["rack"]
    _, rack = turnings(pair)
    assert np.linalg.norm(rack.slide) * 360.0 == pytest.approx(np.pi * 2.0 * 17.0, rel=1e-9)


def test_a_short_rack_runs_only_until_half_of_it_has_passed():
    # its 6 teeth are as long as 6/24 of a turn of the pinion: half of that either way
    pair = gw.GearPair(teeth=(24, 6), module=2, face_width=10, kind="rack")
    _, rack = turnings(pair)
    assert rack.most(np.ptp(pair.gear.polyhedron().vertices, axis=0)) == pytest.approx(45.0, rel=1e-6)
    assert turnings(PAIRS["spur"])[1].most(np.array([60.0, 60.0, 10.0])) == 180.0

"""Lines of contact of pairs on parallel axes lie on the driving flanks of both members, where these are placed."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.boundary.nearness import Skin
from gearwright.contact.plane_of_action import lines_of_action, lines_over_a_pitch

PAIRS = {
    "spur": gw.GearPair(teeth=(16, 25), module=2, face_width=10),
    "shifted": gw.GearPair(teeth=(12, 24), module=3, face_width=20, profile_shift=(0.4, 0.3)),
    "helical": gw.GearPair(teeth=(17, 31), module=2, face_width=30, kind="helical", helix_angle=25, hand="left"),
    "herringbone": gw.GearPair(teeth=(17, 31), module=2, face_width=30, kind="herringbone", helix_angle=20),
    "internal": gw.GearPair(teeth=(20, 63), module=2, face_width=10, kind="internal"),
    "rack": gw.GearPair(teeth=(24, 12), module=2, face_width=10, kind="rack"),
}


def distances(pair: gw.GearPair, turn: float) -> list[float]:
    lines = lines_of_action(pair, turn)
    points = np.concatenate([a + np.linspace(0.02, 0.98, 5)[:, None] * (b - a) for a, b in lines])
    found = []
    for member, placement in zip((pair.pinion, pair.gear), pair.placements(turn), strict=True):
        own = (points - placement[:3, 3]) @ placement[:3, :3]
        found.append(float(np.abs(Skin.of(member.boundary).signed_distance(own, 0.01)).max()))
    return found


@pytest.mark.parametrize("name", PAIRS)
def test_lines_lie_on_both_flanks(name):
    pair = PAIRS[name]
    for turn in (0.0, 3.7, -8.1):
        assert max(distances(pair, turn)) < 1e-9


@pytest.mark.parametrize("name", ["spur", "helical"])
def test_their_mean_length_is_the_contact_ratio_times_the_face_along_the_helix(name):
    pair = PAIRS[name]
    steps, pitch = lines_over_a_pitch(pair, 400)
    mean = np.mean([sum(np.linalg.norm(b - a) for a, b in lines) for lines in steps])
    gear = pair.pinion.sizes()
    lean = np.cos(np.radians(gear["base_helix_angle"].value))
    assert pitch == pytest.approx(360 / pair.teeth[0])
    assert mean == pytest.approx(pair.sizes()["contact_ratio"].value * pair.face_width / lean, rel=3e-3)


def test_they_move_on_with_the_pinion():
    pair = PAIRS["spur"]
    (first, *_), (later, *_) = lines_of_action(pair, 0.0), lines_of_action(pair, 1.0)
    moved = later[0] - first[0]
    base = pair.pinion.sizes()["base_diameter"].value / 2
    assert np.linalg.norm(moved) == pytest.approx(base * np.radians(1.0), rel=1e-9)
    assert moved[1] > 0  # the way the pinion's flank moves on the side of the gear

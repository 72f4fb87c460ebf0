"""Flanks of placed pairs, turned until they touch: ratio, contact ratio, sliding and backlash, found from points."""

import numpy as np
import pytest

from gearwright.elements.cylindrical.gear_pair import GearPair

from .running import Running

PAIRS = {
    "spur, shifted": {"teeth": (12, 24), "module": 3.0, "face_width": 20.0, "profile_shift": (0.6, 0.36)},
    "spur, negative sum": {"teeth": (40, 50), "module": 2.0, "face_width": 12.0, "centre_distance": 89.2},
    "spur, in inches, 25°": {
        "teeth": (18, 31),
        "diametral_pitch": 8.0,
        "face_width": 1.0,
        "pressure_angle": 25.0,
        "length_unit": "in",
        "centre_distance": 3.1,
    },
    "helical": {"kind": "helical", "teeth": (17, 24), "module": 3.0, "face_width": 20.0, "helix_angle": 25.0},
    "helical, left, shifted": {
        "kind": "helical",
        "teeth": (15, 38),
        "transverse_module": 2.5,
        "face_width": 22.0,
        "helix_angle": 14.0,
        "hand": "left",
        "profile_shift": (0.4, -0.1),
    },
    "herringbone": {
        "kind": "herringbone",
        "teeth": (20, 33),
        "module": 2.0,
        "face_width": 30.0,
        "helix_angle": 30.0,
    },
    "internal": {"kind": "internal", "teeth": (20, 60), "module": 2.0, "face_width": 20.0},
    "internal, shifted": {
        "kind": "internal",
        "teeth": (20, 60),
        "module": 2.0,
        "face_width": 20.0,
        "profile_shift": (0.3, -0.6),
    },
    "internal, helical, at a distance": {
        "kind": "internal",
        "teeth": (19, 52),
        "module": 2.0,
        "face_width": 20.0,
        "helix_angle": 20.0,
        "hand": "left",
        "centre_distance": 34.8,
    },
    "rack": {"kind": "rack", "teeth": (20, 9), "module": 2.0, "face_width": 20.0},
    "rack, helical, shifted": {
        "kind": "rack",
        "teeth": (13, 8),
        "module": 2.0,
        "face_width": 20.0,
        "helix_angle": 18.0,
        "profile_shift": 0.3,
    },
}
STRAIGHT = [name for name, values in PAIRS.items() if "helix_angle" not in values]
TURNS = (np.arange(4) + 0.37) / 4.0
LEVELS = {True: (0.0,), False: (0.0, 0.7)}
TOUCH = 1e-9
"""Radians (of a rack: lengths) that a touch is told from a gap by: gaps grow with the square of the way beyond it."""


def _levels(name):
    return LEVELS[name in STRAIGHT]


def _plays(pair, level=0.0, turns=TURNS):
    """Plays (n, 2) either way over a pitch, as arcs (lengths) on the gear's pitch circle."""
    radius = 1.0 if pair.kind == "rack" else pair.gear.pitch_radius
    return np.array([Running(pair, level).plays(turn) for turn in turns]) * radius


@pytest.mark.parametrize("name", PAIRS)
def test_flanks_touch_at_every_turn(name):
    """Without backlash both flanks of a tooth touch, at exactly the place that the teeth numbers give the mate."""
    pair = GearPair(**PAIRS[name])
    for level in _levels(name):
        np.testing.assert_allclose(_plays(pair, level), 0.0, atol=1e-12 * pair.pinion.pitch_radius)


@pytest.mark.parametrize("name", PAIRS)
def test_backlash_opens_both_flanks_alike(name):
    """Half the backlash from each member: the mate may move by j/2 either way from the middle, on its pitch circle."""
    pair = GearPair(**PAIRS[name], backlash=0.04 * (2.0 if name != "spur, in inches, 25°" else 0.1))
    for level in _levels(name):
        plays = _plays(pair, level, TURNS[:2])
        np.testing.assert_allclose(plays, np.array([-1.0, 1.0]) * pair.backlash / 2.0 + 0.0 * plays, rtol=1e-9)


@pytest.mark.parametrize(
    ("name", "away"),
    [("spur, shifted", 0.2), ("helical", 0.3), ("internal", -0.2), ("internal, helical, at a distance", -0.1)],
)
def test_axes_apart_keep_the_ratio_and_give_the_backlash_told(name, away):
    """Involutes run at any distance; the play is j_wt on the working circle, j_bn along the normal in space."""
    near = GearPair(**PAIRS[name])
    shifts = tuple(near.axes.shifts)
    pair = GearPair(**{**PAIRS[name], "profile_shift": shifts, "centre_distance": near.mesh.centre_distance + away})
    plays = np.array([Running(pair).plays(turn) for turn in TURNS])
    assert np.ptp(plays, axis=0) == pytest.approx(0.0, abs=1e-12)
    sizes = pair.sizes()
    play = float(plays[0, 1] - plays[0, 0])
    assert play * sizes["gear_working_diameter"].value / 2.0 == pytest.approx(sizes["backlash"].value, rel=1e-9)
    assert _along_the_normal(pair) == pytest.approx(sizes["normal_backlash"].value, rel=1e-9)
    assert sizes["backlash"].value > 0.01


@pytest.mark.parametrize("name", ["spur, shifted", "helical", "internal, shifted", "rack, helical, shifted"])
def test_normal_backlash(name):
    pair = GearPair(**PAIRS[name], backlash=0.1)
    assert _along_the_normal(pair) == pytest.approx(pair.sizes()["normal_backlash"].value, rel=1e-9)


@pytest.mark.parametrize(
    ("kind", "thickness", "more"),
    [
        ("spur", (3.3, 2.7), {}),
        ("spur", (3.0, 3.4), {"profile_shift": (0.0, 0.3)}),
        ("helical", (3.2, 2.9), {"helix_angle": 15.0}),
        ("internal", (3.2, 2.9), {}),
        ("internal", (2.9, 2.6), {"profile_shift": (0.0, -0.4), "backlash": 0.4}),
        ("rack", (3.2, 2.9), {}),
    ],
)
def test_given_thicknesses_make_the_backlash_told(kind, thickness, more):
    values = {"kind": kind, "teeth": (20, 60), "module": 2.0, "face_width": 10.0, **more}
    pair = GearPair(**values, circular_thickness=thickness)
    plays = np.array([Running(pair).plays(turn) for turn in TURNS[:2]])
    assert np.ptp(plays, axis=0) == pytest.approx(0.0, abs=1e-12)
    sizes = pair.sizes()
    radius = 1.0 if kind == "rack" else sizes["gear_working_diameter"].value / 2.0
    assert (plays[0, 1] - plays[0, 0]) * radius == pytest.approx(sizes["backlash"].value, rel=1e-9)
    assert plays[0, 1] == pytest.approx(-plays[0, 0], rel=1e-9)


@pytest.mark.parametrize(
    ("values", "radius"),
    [
        ({"teeth": (20, 30), "tip_diameter": (43.0, 63.0)}, 31.5),
        ({"kind": "internal", "teeth": (30, 70), "tip_diameter": (63.0, 137.4)}, 68.7),
    ],
)
def test_given_tip_diameters_bound_the_flanks(values, radius):
    pair = GearPair(**values, module=2.0, face_width=10.0)
    gear = Running(pair).contacts(0.1)[0].flanks[1]
    ends = np.linalg.norm(gear.points(np.array([0.0, 1.0])) - gear.placement[:2, 3], axis=1)
    assert (min(ends) if pair.kind == "internal" else max(ends)) == pytest.approx(radius, rel=1e-12)


def _along_the_normal(pair):
    """Play of one flank after the other, each along the contact's normal in space."""
    running, found = Running(pair), {}
    for contact in sorted(running.contacts(0.2), key=lambda one: -abs(one.play)):
        gear = contact.flanks[1]
        u = np.array(contact.u_gear)
        normal = gear.patch.area_vector(u, np.array(0.0))
        seat, image = gear.placement, gear.image
        c, s = np.cos(image), np.sin(image)
        normal = seat[:3, :3] @ (np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ normal)
        way = np.array([0.0, contact.play])
        if not running.rack:
            x, y = gear.points(u) - seat[:2, 3]
            way = contact.play * np.array([-y, x])
        found[contact.side] = float(way @ normal[:2]) / float(np.linalg.norm(normal))
    return sum(found.values())


@pytest.mark.parametrize("kind", ["spur", "internal", "rack"])
def test_relieved_flanks_lag(kind):
    """A relieved tooth meets its mate late: the driven member lags at some turns, and never runs ahead."""
    values = {"kind": kind, "teeth": (20, 50 if kind == "internal" else 30), "module": 3.0, "face_width": 10.0}
    amount = 0.03
    pair = GearPair(**values, tip_relief=(amount, 0.0), tip_relief_height=4.0)
    plays = _plays(pair, turns=(np.arange(8) + 0.4) / 8.0)
    assert np.all(plays[:, 1] > -1e-11)
    assert np.all(plays[:, 0] < 1e-11)
    assert 0.005 < plays[:, 1].max() < 2.0 * amount
    assert np.ptp(plays[:, 1]) > 0.005


def _in_contact(running, found, turn):
    contact = running.contact_of(found, turn)
    return contact is not None and contact.inside and abs(contact.play) < TOUCH


def _last(running, found, turn, step):
    """The turn, in pitches, at which two flanks cease to touch, going from one at which they do."""
    good, bad = turn, turn + step
    while _in_contact(running, found, bad):
        good, bad = bad, bad + step
    for _ in range(26):
        middle = (good + bad) / 2.0
        good, bad = (middle, bad) if _in_contact(running, found, middle) else (good, middle)
    return good


def _meeting(pair, turn=0.2):
    """A pair of flanks in touch, and the turns between which they are."""
    running = Running(pair)
    found = next(one for one in running.contacts(turn) if one.inside and abs(one.play) < TOUCH and one.side > 0)
    return running, found, sorted(_last(running, found, turn, step) for step in (-0.4, 0.4))


UNDERCUT = {"teeth": (11, 30), "module": 3.0, "face_width": 10.0}
CHAMFERED = {"teeth": (20, 30), "module": 3.0, "face_width": 10.0, "tip_chamfer": (0.5, 0.3)}


@pytest.mark.parametrize("values", [*PAIRS.values(), UNDERCUT, CHAMFERED], ids=[*PAIRS, "undercut", "chamfered"])
def test_contact_lasts_as_long_as_the_contact_ratio_says(values):
    """Two flanks touch while the pinion turns by ε_α pitches."""
    pair = GearPair(**values)
    _, _, (first, last) = _meeting(pair)
    assert last - first == pytest.approx(pair.sizes()["contact_ratio"].value, rel=3e-5)


@pytest.mark.parametrize("name", ["spur, shifted", "helical", "internal, shifted", "rack"])
def test_specific_sliding(name):
    """One less the ratio of the ways that contact takes along both flanks, in their own frames."""
    pair = GearPair(**PAIRS[name])
    running, found, turns = _meeting(pair)
    sizes = pair.sizes()
    near_root = running.contact_of(found, turns[0] + 1e-3)
    ends = turns if np.linalg.norm(near_root.point) < pair.mesh.working_radius else turns[::-1]
    for turn, member, size in ((ends[0], 0, "pinion_specific_sliding"), (ends[1], 1, "gear_specific_sliding")):
        inward = np.sign(sum(turns) / 2.0 - turn)
        at = [_sliding(running, found, turn + inward * step)[member] for step in (0.02, 0.04, 0.06)]
        extrapolated = 3.0 * at[0] - 3.0 * at[1] + at[2]
        assert extrapolated == pytest.approx(sizes[size].value, rel=0.02)
    middle = _sliding(running, found, sum(turns) / 2.0)
    radius = float(np.linalg.norm(running.contact_of(found, sum(turns) / 2.0).point))
    string = float(np.sqrt(radius**2 - pair.pinion.toothing.base_radius**2))
    assert pair.mesh.specific_sliding(string) == pytest.approx(middle, abs=1e-4)


def _sliding(running, found, turn, step=5e-3):
    ways = []
    contacts = [running.contact_of(found, turn + way) for way in (-step, step)]
    for member in (0, 1):
        u = np.array([one.u_pinion if member == 0 else one.u_gear for one in contacts])
        path = found.flanks[member].points(np.linspace(*u, 200))
        ways.append(float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()))
    return 1.0 - ways[1] / ways[0], 1.0 - ways[0] / ways[1]

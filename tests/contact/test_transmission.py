"""Transmission error: none where theory says so, and the tightest of all points where it does not."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright import GeometryError
from gearwright.contact.approach import Approach
from gearwright.contact.mesh import mesh_of
from gearwright.contact.misalignment import Misalignment
from gearwright.contact.path import ContactPath
from gearwright.contact.transmission import least_backlash, running_error, transmission_error
from gearwright.elements.bevel.bevel_pair import BevelPair

from .octoid import with_octoids
from .surfaces import greatest_lead

BASIC = {"teeth": (16, 20), "module": 4.0, "face_width": 10.0}
SPIRAL = {"trace": "logarithmic", "spiral_angle": 35.0}
PAIRS = {
    "Σ 90°": BASIC,
    "Σ 45°": {**BASIC, "shaft_angle": 45.0},
    "Σ 60°": {**BASIC, "shaft_angle": 60.0},
    "Σ 110°": {"teeth": (20, 31), "module": 3.0, "face_width": 10.0, "shaft_angle": 110.0},
    "Σ 135°": {
        "teeth": (25, 25),
        "module": 3.0,
        "face_width": 10.0,
        "shaft_angle": 135.0,
        "pressure_angle": 25.0,
        "working_depth": 5.0,
    },
}
every_pair = pytest.mark.parametrize("name", PAIRS)
every_side = pytest.mark.parametrize("side", ["drive", "coast"])
ASKEW = {"shaft_angle_error": 0.1, "mounting_errors": (0.06, -0.04), "offset_error": 0.05}


def _tilted(degrees):
    return Misalignment(shaft_angle=np.radians(degrees))


@every_side
@every_pair
@pytest.mark.parametrize("error", [-0.2, 0.0, 0.1])
def test_spherical_involutes_run_true_at_any_shaft_angle(name, side, error):
    found = transmission_error(BevelPair(**PAIRS[name]), shaft_angle_error=error, side=side)
    assert found.peak_to_peak < 1e-12
    if error:
        assert found.lead.mean() * error < -1e-4 * error**2  # a larger angle takes the teeth apart


@every_side
@pytest.mark.parametrize("error", [0.0, 0.1])
def test_spirals_run_true_as_well(side, error):
    found = transmission_error(BevelPair(**BASIC, **SPIRAL), shaft_angle_error=error, side=side, samples=12)
    assert found.peak_to_peak < 1e-12
    assert (abs(found.lead.mean()) > 1e-4) == (error != 0.0)


@every_pair
def test_octoids_run_true_only_at_their_own_shaft_angle(name):
    mesh = with_octoids(BevelPair(**PAIRS[name]))
    assert running_error(mesh).peak_to_peak < 1e-12
    one, two = (running_error(mesh, _tilted(error)).peak_to_peak for error in (0.1, 0.2))
    assert one > 2e-6
    assert two > 1.5 * one


@every_side
@every_pair
@pytest.mark.parametrize("octoid", ["pinion", "gear"])
def test_an_octoid_does_not_run_true_with_an_involute(name, octoid, side):
    found = running_error(with_octoids(BevelPair(**PAIRS[name]), (octoid,)), side=side)
    assert 3e-5 < found.peak_to_peak < 3e-4


@pytest.mark.parametrize("octoid", ["pinion", "gear"])
def test_where_they_touch_inside_both_flanks_they_have_one_tangent(octoid):
    """The flanks of a mixed pair: at most turns on an edge, at the others tangent to each other."""
    mesh = with_octoids(BevelPair(**BASIC), (octoid,))
    found = running_error(mesh)
    turns = found.pinion_turn + mesh.pitch * found.tooth
    approach, step = Approach(mesh=mesh), 1e-5
    level = mesh.pinion.level(found.polar, found.distance)
    inside = mesh.pinion.height_room(found.polar, level) > step
    inside &= approach.room(turns, level, found.polar) > step
    assert inside.sum() >= 10
    at = turns[inside], level[inside], found.polar[inside]
    ahead, back = (approach.lead(at[0], at[1], at[2] + one) for one in (step, -step))
    np.testing.assert_allclose((ahead - back) / (2.0 * step), 0.0, atol=1e-5)
    assert np.all(ahead + back < 2.0 * found.lead[inside])


@every_side
@pytest.mark.parametrize("more", [{}, SPIRAL, {**SPIRAL, "hand": "left"}], ids=["straight", "right", "left"])
@pytest.mark.parametrize("shaft_angle", [60.0, 90.0])
def test_the_lead_is_that_of_the_tightest_point_of_the_solids(side, more, shaft_angle):
    """Askew in every way. The grid cannot find a tighter point, and comes as near as its spacing lets it."""
    pair = BevelPair(**BASIC, **more, shaft_angle=shaft_angle)
    found = transmission_error(pair, **ASKEW, samples=4, side=side)
    sense = 1.0 if side == "drive" else -1.0
    brute = np.array([greatest_lead(pair, sense * turn, side, *ASKEW.values()) for turn in found.pinion_turn])
    assert np.all(brute <= found.lead + 5e-8)  # 3e-8 is left where the gear's end limits the contact
    assert np.all(brute >= found.lead - 8e-6)  # halved where the grid along the face is
    assert found.peak_to_peak > 1e-5


FORMS = [("involute", "involute"), ("octoid", "octoid")]
VARIED = {
    "uniform depth": {"taper": "uniform", "teeth": (24, 30)},
    "Gleason": {"standard": "gleason-straight"},
    "ISO 23509": {"standard": "iso-23509", "taper": "uniform", **SPIRAL},
    "flat ends": {"ends": "flat"},
    "radial roots": {"root": "radial"},
}


@pytest.mark.parametrize("forms", FORMS, ids=lambda forms: forms[0])
@pytest.mark.parametrize("side", ["drive", "coast"])
@every_pair
def test_pairs_of_one_form_run_true(name, side, forms):
    """The package's own octoid against itself; the one above is written for comparison, and runs true with it."""
    pair = BevelPair(**PAIRS[name], tooth_form=forms)
    assert transmission_error(pair, side=side).peak_to_peak < 1e-12
    if forms[0] == "octoid":
        assert running_error(with_octoids(pair, ("gear",)), side=side).peak_to_peak < 1e-12
        assert transmission_error(pair, shaft_angle_error=0.1, side=side).peak_to_peak > 2e-6


@pytest.mark.parametrize("forms", FORMS, ids=lambda forms: forms[0])
@pytest.mark.parametrize("name", VARIED)
def test_depths_roots_and_ends_leave_the_flanks_alone(name, forms):
    found = transmission_error(BevelPair(**{**BASIC, **VARIED[name]}, tooth_form=forms), samples=16)
    assert found.peak_to_peak < 1e-12
    np.testing.assert_allclose(found.lead, 0.0, atol=1e-12)


def test_two_forms_step_from_tooth_to_tooth():
    found = {}
    for forms in [("involute", "octoid"), ("octoid", "involute")]:
        pair = BevelPair(**BASIC, tooth_form=forms, backlash=0.05)
        error = transmission_error(pair)
        member = ("gear",) if forms[1] == "octoid" else ("pinion",)
        same = running_error(with_octoids(BevelPair(**BASIC, backlash=0.05), member))
        np.testing.assert_allclose(error.lead, same.lead, atol=1e-12)
        found[forms] = error.peak_to_peak
    assert all(5e-5 < one < 3e-4 for one in found.values())


@pytest.mark.parametrize("more", [{}, SPIRAL], ids=["straight", "spiral"])
def test_crowned_teeth_touch_at_mid_face_and_run_true_there(more):
    """Exactly so between spheres; on cones levels of both members part by a part in 1000, and the error is tiny."""
    pair = BevelPair(**BASIC, **more, crowning=0.02, ends="spherical")
    found = transmission_error(pair, samples=12)
    assert found.peak_to_peak < 1e-12
    np.testing.assert_allclose(found.distance, pair.pinion.mean_distance, atol=1e-3)
    on_cones = transmission_error(replace(pair, ends="conical"), samples=12)
    assert 1e-10 < on_cones.peak_to_peak < 1e-7
    np.testing.assert_allclose(on_cones.distance, pair.pinion.mean_distance, atol=0.1)
    apart = [transmission_error(one, offset_error=0.04, samples=12) for one in (pair, BevelPair(**BASIC, **more))]
    assert np.ptp(apart[0].distance) < 4.0
    assert apart[1].distance.max() > 51.0  # without crowning the ends of the teeth carry
    assert apart[0].distance.max() < 50.0


@pytest.mark.parametrize("form", ["involute", "octoid"])
@pytest.mark.parametrize("power", ["linear", "parabolic"])
def test_relief_takes_its_amount_off_at_the_tip(form, power):
    """Off along the normal great circle, which turns the gear by the amount over R_e sin γ₂ cos a for involutes."""
    given = {**BASIC, "tooth_form": form, "tip_relief_form": power}
    plain, relieved = BevelPair(**given), BevelPair(**given, tip_relief=(0.02, 0.0))
    mesh = mesh_of(relieved)
    tip = np.array([mesh.pinion.heights[1]])
    turn, level = ContactPath(mesh=mesh_of(plain)).turn(tip), np.array([mesh.pinion.outer])
    lead = Approach(mesh=mesh).lead(turn, level, tip)
    arm = plain.gear.pitch_radius * np.cos(np.radians(20.0))
    assert -float(lead[0]) == pytest.approx(0.02 / arm, rel=0.03)
    error = transmission_error(relieved)
    assert 0.0 < error.peak_to_peak < 0.02 / arm
    assert error.lead.max() == pytest.approx(0.0, abs=1e-12)  # where flanks without relief touch it runs true


@pytest.mark.parametrize(
    "given",
    [{"crowning": (0.02, 0.0)}, {"taper": "uniform", "teeth": (24, 31), "module": 3.0}],
    ids=["crowned", "uniform"],
)
def test_so_it_is_of_teeth_that_vary(given):
    pair = BevelPair(**{**BASIC, **SPIRAL, **given})
    found = transmission_error(pair, **ASKEW, samples=3)
    brute = np.array([greatest_lead(pair, turn, "drive", *ASKEW.values()) for turn in found.pinion_turn])
    assert np.all(brute <= found.lead + 1e-9)
    assert np.all(brute >= found.lead - 8e-6)  # halved where the grid along the face is


@pytest.mark.parametrize("error", ASKEW)
def test_each_error_of_mounting_tells(error):
    """Each alone moves the curve by far more than the grid of the test above leaves open."""
    pair = BevelPair(**BASIC, **SPIRAL)
    without = {name: value for name, value in ASKEW.items() if name != error}
    full, less = (transmission_error(pair, **one, samples=4) for one in (ASKEW, without))
    assert np.abs(full.lead - less.lead).min() > 1e-4


def test_lengths_scale():
    small, large = BevelPair(**BASIC, **SPIRAL), BevelPair(teeth=(16, 20), module=8.0, face_width=20.0, **SPIRAL)
    one = transmission_error(small, mounting_errors=(0.05, 0.02), offset_error=-0.03, samples=3)
    two = transmission_error(large, mounting_errors=(0.10, 0.04), offset_error=-0.06, samples=3)
    np.testing.assert_allclose(two.lead, one.lead, atol=1e-12)


@every_pair
def test_backlash_is_the_play_between_the_sides(name):
    pair = BevelPair(**PAIRS[name], backlash=0.08)
    drive, coast = (transmission_error(pair, side=side, samples=8) for side in ("drive", "coast"))
    assert least_backlash(drive, coast) == pytest.approx(0.08 / pair.gear.pitch_radius, rel=1e-11)
    np.testing.assert_allclose(drive.lead, -0.04 / pair.gear.pitch_radius, rtol=1e-10)


def test_a_thicker_tooth_leads_by_what_it_is_thicker():
    """Thickness alone shifts the curve and keeps its shape: the error is free of the play, the lead is not."""
    pair = BevelPair(**BASIC)
    mesh = with_octoids(pair, ("gear",))
    thin = replace(
        mesh, gear=replace(mesh.gear, flank=replace(mesh.gear.flank, thickness=pair.gear.tooth.thickness - 0.01))
    )
    full, less = running_error(mesh), running_error(thin)
    np.testing.assert_allclose(full.lead - less.lead, 0.005, rtol=1e-12)
    np.testing.assert_allclose(full.error, less.error, atol=1e-14)
    assert full.error.mean() == pytest.approx(0.0, abs=1e-16)


def test_contact_ends_where_the_path_of_contact_does():
    """The polar angles that touch span the active flank: some teeth at the tip, none below the form angle."""
    mesh = mesh_of(BevelPair(**BASIC))
    found = running_error(mesh, samples=256)
    assert set(found.tooth) <= {-2, -1, 0, 1}
    assert np.ptp(found.polar) > np.radians(2.0)
    assert found.polar.min() >= mesh.pinion.heights[0]


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"samples": 1}, "samples = 1: at least 2 turns"),
        ({"side": "left"}, "side = 'left': drive, .* or coast"),
        ({"offset_error": float("nan")}, "errors of mounting: finite"),
        ({"mounting_errors": (20.0, 0.0)}, "no flank reaches its mate: the errors of mounting are larger"),
    ],
)
def test_what_cannot_run_is_refused(given, text):
    with pytest.raises(GeometryError, match=text):
        transmission_error(BevelPair(**BASIC), **given)

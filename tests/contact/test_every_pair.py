"""Laws of running that hold for every pair: the catalog's examples, and any others."""

import numpy as np
import pytest

from gearwright import ParameterError
from gearwright.contact.lines import contact_ratios
from gearwright.contact.transmission import transmission_error
from gearwright.elements.bevel.bevel_pair import BevelPair

from ..examples import EXAMPLES
from .test_transmission import BASIC


def any_pairs(count):
    """So many pairs of the many that can be built: teeth, shaft angles, spirals, backlash."""
    random = np.random.default_rng(5)
    while count:
        given = {
            "teeth": tuple(sorted(random.integers(6, 60, 2).tolist())),
            "module": 4.0,
            "face_width": random.uniform(5.0, 30.0),
            "shaft_angle": random.uniform(20.0, 150.0),
            "pressure_angle": random.choice([14.5, 20.0, 25.0]),
            "backlash": random.choice([0.0, 0.1]),
        }
        if random.random() < 0.4:
            given |= {"trace": "logarithmic", "spiral_angle": random.uniform(5.0, 50.0), "hand": "left"}
        try:
            yield BevelPair(**given)
            count -= 1
        except ParameterError:
            continue


def _ratio_above_fillets(pair):
    """From the turns of the crown gear at which each tip, or already its mate's fillet, ends the contact."""
    teeth = pair.teeth_on_sphere(pair.pinion.mean_distance)
    turns = [
        min(float(one.flank.parameter_at(one.face_angle)), -float(mate.flank.parameter_at(mate.form_angle)))
        for one, mate in (teeth, teeth[::-1])
    ]
    return sum(turns) / (2.0 * np.pi * np.sin(pair.pinion.pitch_cone_angle) / pair.teeth[0])


def runs_true(pair):
    """On both sides, at its own shaft angle and at another, and touches from fillet or tip to tip or fillet."""
    for side, error in (("drive", 0.0), ("coast", 0.0), ("drive", 0.05)):
        found = transmission_error(pair, shaft_angle_error=error, samples=6, side=side)
        assert found.peak_to_peak < 1e-12
        if not error:
            np.testing.assert_allclose(found.lead, -pair.backlash / 2.0 / pair.gear.pitch_radius, atol=1e-12)
    expected = _ratio_above_fillets(pair)
    assert pair.sizes()["contact_ratio"].value == pytest.approx(expected, rel=1e-13)
    # where a fillet ends the contact, at the very foot of a flank, slopes are quotients of roundings
    tips = sum(float(one.flank.parameter_at(one.face_angle)) for one in pair.teeth_on_sphere(pair.pinion.mean_distance))
    at_foot = expected < tips / (2.0 * np.pi * np.sin(pair.pinion.pitch_cone_angle) / pair.teeth[0]) - 1e-9
    assert contact_ratios(pair).transverse == pytest.approx(expected, abs=1e-7 if at_foot else 1e-10)


@pytest.mark.parametrize("name", EXAMPLES["bevel pair"])
def test_every_example_runs_true(name):
    runs_true(BevelPair(**EXAMPLES["bevel pair"][name]))


def test_any_pair_runs_true():
    for pair in any_pairs(12):
        runs_true(pair)


def test_teeth_too_short_to_take_over_fall_behind_for_the_rest_of_the_pitch():
    """Below a contact ratio of 1 the gear is where it should be for that part of the pitch, and never ahead."""
    pair = BevelPair(**BASIC, working_depth=3.6)
    ratio = pair.sizes()["contact_ratio"].value
    assert 0.7 < ratio < 0.95
    found = transmission_error(pair, samples=400)
    assert np.mean(np.abs(found.lead) < 1e-9) == pytest.approx(ratio, abs=0.006)
    assert found.lead.max() < 1e-12
    assert found.peak_to_peak > 1e-5

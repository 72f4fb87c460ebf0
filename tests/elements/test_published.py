"""Sizes and mass properties against published numbers, to the digits given.

Al-Daccak 1989, table 3.1 (a 16/20 pair) and ch. 4.5.2 (a spur gear); values exact for these shapes.
"""

import numpy as np
import pytest

from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair
from gearwright.elements.cylindrical.spur_gear import SpurGear

from ..examples import README_PAIR, SHARP

SPIRAL = {"trace": "logarithmic", "spiral_angle": 35.0}


@pytest.mark.parametrize("trace", [{}, SPIRAL], ids=["straight", "spiral"])
@pytest.mark.parametrize(
    ("member", "volume", "height", "axial", "across"),
    [
        ("gear", 113.004198793, 4.637163090, 1226.504128, 3103.661014),
        ("pinion", 65.711456506, 5.081712010, 445.041075738, 1938.848461383),
    ],
)
def test_mass_properties_of_the_16_20_pair(member, volume, height, axial, across, trace):
    """About the apex, in inches."""
    found = getattr(BevelPair(**README_PAIR, **trace), member).properties()
    assert found.volume == pytest.approx(volume, abs=0.6e-9)
    assert found.centroid == pytest.approx([0.0, 0.0, height], abs=0.6e-9)
    digits = 0.6e-6 if member == "gear" else 0.6e-9
    assert np.diag(found.inertia) == pytest.approx([across, across, axial], abs=digits)
    assert np.array_equal(found.products, [0.0, 0.0, 0.0])
    assert found.method == "exact"


@pytest.mark.parametrize("member", ["gear", "pinion"])
def test_spiral_and_straight_are_equal_to_rounding(member):
    straight, spiral = (getattr(BevelPair(**README_PAIR, **trace), member).properties() for trace in ({}, SPIRAL))
    np.testing.assert_allclose(spiral.volume, straight.volume, rtol=1e-13)
    np.testing.assert_allclose(spiral.centroid, straight.centroid, rtol=1e-13)
    np.testing.assert_allclose(spiral.inertia, straight.inertia, rtol=1e-13)


@pytest.mark.parametrize(
    ("member", "pitch", "base", "azimuth"),
    [("gear", 51.340192, 47.203946, 1.319639), ("pinion", 38.659808, 35.945916, 1.077398)],
)
def test_angles_of_the_16_20_pair(member, pitch, base, azimuth):
    gear = getattr(BevelPair(**README_PAIR), member)
    sizes = gear.sizes()
    assert sizes["pitch_angle"].value == pytest.approx(pitch, abs=0.6e-6)
    assert sizes["base_angle"].value == pytest.approx(base, abs=0.6e-6)
    assert np.degrees(gear.tooth.pitch_azimuth) == pytest.approx(azimuth, abs=0.6e-6)


def test_engagement_of_the_16_20_pair():
    pair = BevelPair(**README_PAIR)
    sizes = pair.sizes()
    assert sizes["contact_ratio"].value == pytest.approx(1.33423, abs=0.6e-5)
    assert sizes["gear_face_angle_limit"].value == pytest.approx(57.855, abs=0.6e-3)
    assert sizes["pinion_face_angle_limit"].value == pytest.approx(50.653, abs=0.6e-3)
    assert pair.gear.sizes()["face_angle"].value == pytest.approx(54.915, abs=0.6e-3)
    assert pair.pinion.sizes()["face_angle"].value == pytest.approx(42.234, abs=0.6e-3)
    assert sizes["cone_distance"].value == pytest.approx(np.sqrt(41.0), rel=1e-15)
    assert sizes["clearance"].value == pytest.approx(0.05, rel=1e-12)
    assert sizes["gear_ratio"].value == 1.25


def test_mass_properties_of_the_spur_gear():
    found = SpurGear(teeth=16, module=8.0, face_width=50.0, addendum=8.0, dedendum=10.0, root="radial").properties()
    assert found.volume == pytest.approx(622714.450588, abs=0.6e-6)
    assert found.inertia[2, 2] == pytest.approx(1.30757375e9, rel=0.5e-8)
    assert found.centroid[2] == pytest.approx(25.0, rel=1e-14)


def test_mass_properties_of_the_spur_gear_with_its_root_on_the_base_circle():
    dedendum = 64.0 * (1.0 - np.cos(np.radians(20.0)))
    gear = SpurGear(teeth=16, module=8.0, face_width=50.0, addendum=8.0, dedendum=float(dedendum), root="radial")
    found = gear.properties()
    assert found.volume == pytest.approx(6.69403e5, abs=0.6)
    assert found.inertia[2, 2] == pytest.approx(1.46008e9, abs=0.6e4)


def test_sizes_of_a_20_40_pair_of_module_3():
    """KHK stock gears m3 20/40, b22, standard depths, from the maker's catalogue."""
    pair = BevelPair(teeth=(20, 40), module=3.0, face_width=22.0, working_depth=6.0, whole_depth=6.75)
    assert pair.sizes()["cone_distance"].value == pytest.approx(67.08204, abs=0.6e-5)
    expected = {
        "pinion": {
            "pitch_angle": 26.56505,
            "face_angle": 29.12569,
            "addendum_angle": 2.56064,
            "dedendum_angle": 3.19960,
        },
        "gear": {"pitch_angle": 63.43495, "face_angle": 65.99559, "addendum_angle": 2.56064, "dedendum_angle": 3.19960},
    }
    for member, angles in expected.items():
        sizes = getattr(pair, member).sizes()
        for name, value in angles.items():
            assert sizes[name].value == pytest.approx(value, abs=0.6e-5), (member, name)


@pytest.mark.parametrize(
    ("pitch_angle", "volume", "height", "along", "across"),
    [
        (45.0, 79595.425446065846538, 40.896228809459721487, 3315646.9026341334256, 24655610.923308311231),
        (3.0, 95612.359902903463463, 753.85809364535907547, 3191950.7384891559373, 37720814.170954513755),
    ],
)
def test_error_bound_is_honest(pitch_angle, volume, height, along, across):
    """Against integrals over azimuth taken with 40 digits, of z20 m4 b20: central ∫z² and ∫x²."""
    found = BevelGear(teeth=20, module=4.0, pitch_angle=pitch_angle, face_width=20.0, **SHARP).properties()
    second = np.diag([across, across, along])
    assert found.volume == pytest.approx(volume, rel=2e-15)
    assert found.centroid[2] == pytest.approx(height, rel=2e-15)
    error = np.linalg.norm(found.central_second - second) / np.linalg.norm(second)
    assert error <= found.error_bound
    assert found.error_bound < 1e-11

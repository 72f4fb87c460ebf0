"""Sizes of bevel gears by way of virtual gears: against cylindrical gears, spherical teeth and racks."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.elements.bevel.meshing import contact_ratio
from gearwright.elements.standards.bevels.depth_data import DepthData
from gearwright.elements.standards.bevels.design import BevelDesign
from gearwright.elements.standards.bevels.equal_addendum import equal_addendum
from gearwright.elements.standards.bevels.gleason import gleason_straight
from gearwright.elements.standards.bevels.iso_23509 import iso_23509
from gearwright.elements.standards.bevels.member import bevel_members
from gearwright.elements.standards.bevels.pair_sizes import pair_sizes
from gearwright.elements.standards.bevels.tooth_sizes import tooth_sizes


def design(teeth=(20, 40), module=3.0, shaft=90.0, width=20.0, spiral=0.0, pressure=20.0):
    return BevelDesign(
        teeth=teeth,
        module=module,
        shaft_angle=np.radians(shaft),
        face_width=width,
        pressure_angle=np.radians(pressure),
        spiral_angle=np.radians(spiral),
    )


def values(sizes):
    return {name: size.value for name, size in sizes.items()}


@pytest.mark.parametrize("spiral", [0.0, 25.0])
def test_on_nearly_parallel_axes_bevel_gears_are_cylindrical_ones(spiral):
    """Σ = 2e-5°: R_e is 1e8 times the module, and nothing is left of the cones."""
    given = design((18, 41), 3.0 / np.cos(np.radians(spiral)), 2e-5, 20.0, spiral)
    depths = DepthData(profile_shift=0.25)
    members = bevel_members(given, iso_23509(given, taper="uniform", depths=depths))
    both = {"teeth": (18, 41), "module": 3, "face_width": 20, "profile_shift": (0.25, -0.25)}
    pair = gw.GearPair(**both, **({"kind": "helical", "helix_angle": spiral} if spiral else {}))
    names = {
        "circular_thickness": "circular_thickness",
        "mean_normal_thickness": "normal_thickness",
        "mean_chordal_thickness": "chordal_thickness",
        "mean_chordal_height": "chordal_height",
        "tip_thickness": "tip_thickness",
        "transverse_pressure_angle": "transverse_pressure_angle",
        "pitch_diameter": "pitch_diameter",
    }
    for member, gear in zip(members, (pair.pinion, pair.gear), strict=True):
        found = values(tooth_sizes(member)) | {"pitch_diameter": member.pitch_diameter}
        expected = values(gear.sizes())
        for name, other in names.items():
            assert found[name] == pytest.approx(expected[other], rel=1e-6), name
    found, expected = values(pair_sizes(*members)), values(pair.sizes())
    assert found["contact_ratio"] == pytest.approx(expected["contact_ratio"], rel=1e-6)
    assert found["face_overlap"] == pytest.approx(values(pair.pinion.sizes())["face_overlap"], rel=1e-6, abs=1e-12)
    assert found["modified_contact_ratio"] ** 2 == pytest.approx(
        found["contact_ratio"] ** 2 + found["face_overlap"] ** 2
    )


@pytest.mark.parametrize("teeth", [(16, 20), (20, 40), (25, 60)])
@pytest.mark.parametrize("shaft", [60.0, 90.0])
def test_virtual_gears_come_near_to_teeth_on_the_sphere(teeth, shaft):
    """Tredgold's approximation is good to 3 in a thousand for contact ratios, to 6.5 in a thousand modules at tips."""
    given = design(teeth, 2.0, shaft, 8.0)
    members = bevel_members(given, equal_addendum(given))
    exact = gw.BevelPair(teeth=teeth, module=2, shaft_angle=shaft, face_width=8, root="radial")
    ratio = values(pair_sizes(*members))["contact_ratio"]
    assert ratio == pytest.approx(contact_ratio(exact.pinion.tooth, exact.gear.tooth), rel=3e-3)
    for member, gear in zip(members, (exact.pinion, exact.gear), strict=True):
        mine, theirs = values(tooth_sizes(member)), values(gear.sizes())
        assert mine["tip_thickness"] == pytest.approx(theirs["tip_thickness"], abs=0.0065 * 2.0)
        tooth, pitch = gear.tooth, gear.pitch_radius
        chord = 2.0 * pitch * np.sin(tooth.thickness / 2.0)
        assert mine["chordal_thickness"] == pytest.approx(chord, rel=1e-12)


def test_a_crown_gears_virtual_gear_is_a_rack():
    """A rack's teeth of half angle α stand h out of the pitch plane: path h/sin α, tip s − 2h tan α."""
    given = design((20, 40), 3.0, 120.0, 20.0)
    members = bevel_members(given, equal_addendum(given))
    crown = values(tooth_sizes(members[1]))
    assert "virtual_teeth" not in crown
    assert all(np.isfinite(value) for value in crown.values())
    near = design((20, 40), 3.0, 119.999, 20.0)
    almost = bevel_members(near, equal_addendum(near))
    assert "virtual_teeth" in values(tooth_sizes(almost[1]))
    assert crown["tip_thickness"] == pytest.approx(values(tooth_sizes(almost[1]))["tip_thickness"], rel=1e-4)
    assert crown["tip_thickness"] == pytest.approx(1.5 * np.pi - 6.0 * np.tan(np.radians(20.0)))
    assert crown["chordal_height"] == pytest.approx(3.0)
    ratios = [values(pair_sizes(*pair))["contact_ratio"] for pair in (members, almost)]
    assert ratios[0] == pytest.approx(ratios[1], rel=1e-5)
    # the pinion's share, with virtual radius r = d/(2 cos 30°) and h = m in modules of the mean section
    radius, angle = 10.0 / np.cos(np.radians(30.0)), np.radians(20.0)
    own = np.sqrt((radius + 1.0) ** 2 - (radius * np.cos(angle)) ** 2) - radius * np.sin(angle)
    assert ratios[0] * np.pi * np.cos(angle) == pytest.approx(own + 1.0 / np.sin(angle))


@pytest.mark.parametrize("spiral", [0.0, 35.0])
def test_virtual_teeth_fill_the_back_cone(spiral):
    """The back cone is R tan δ long, and the virtual gear, of that radius, has the same module."""
    given = design((20, 40), 3.0, 90.0, 20.0, spiral)
    for member in bevel_members(given, iso_23509(given, taper="uniform")):
        found = values(tooth_sizes(member))
        radius = member.cone_distance * np.tan(member.pitch_angle)
        assert found["virtual_teeth"] * member.module == pytest.approx(2.0 * radius)
        # seen along the tooth, a cylinder of radius r leaning by β has the curvature cos²β/r
        normal = 2.0 * radius / np.cos(np.radians(spiral)) ** 2
        assert found["normal_virtual_teeth"] * member.module * np.cos(np.radians(spiral)) == pytest.approx(normal)


def test_long_pinion_addenda_thin_its_tips_and_thicken_the_gears():
    given = design((12, 36), 3.0, 90.0, 18.0)
    plain, shifted = (
        [values(tooth_sizes(member))["tip_thickness"] for member in bevel_members(given, pair)]
        for pair in (equal_addendum(given), gleason_straight(given))
    )
    assert shifted[0] < plain[0]
    assert shifted[1] > plain[1]

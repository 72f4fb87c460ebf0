"""A spur gear's surface is what its parameters say, measured on points of its boundary."""

import numpy as np
import pytest

from gearwright.curves.involute import Involute
from gearwright.elements.cylindrical.spur_gear import SpurGear

from ..examples import built, parts_of
from ..laws.contact import unmapped

every_spur = pytest.mark.parametrize("part", parts_of("spur gear"), ids=str)
U = np.linspace(0.0, 1.0, 2001)


def _flanks(gear):
    return [patch for patch in gear.boundary.patches if isinstance(unmapped(patch.curve), Involute)]


def _plane(patch):
    points = patch.point(U, 0.0 * U)
    return np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])


@every_spur
def test_normals_of_flanks_touch_the_base_circle(part):
    """r_b = r cos a, whatever the point: the law of gearing."""
    gear = built(part)
    base = gear.pitch_radius * np.cos(np.radians(gear.pressure_angle))
    u = np.linspace(0.05, 0.95, 9)
    for patch in _flanks(gear):
        points, tangent = patch.point(u, 0.0 * u), patch.partials(u, 0.0 * u)[0]
        along = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
        np.testing.assert_allclose(np.abs(np.sum(along * points, axis=1)), base, rtol=1e-12)


@every_spur
def test_thickness_on_the_pitch_circle(part):
    gear = built(part)
    half = []
    for patch in _flanks(gear):
        radius, turned = _plane(patch)
        order = np.argsort(radius)
        half.append(np.interp(gear.pitch_radius, radius[order], turned[order]))
    m, x = gear.sizes()["module"].value, gear.profile_shift
    nominal = m * (np.pi / 2.0 + 2.0 * x * np.tan(np.radians(gear.pressure_angle)))
    nominal = nominal if gear.circular_thickness is None else gear.circular_thickness
    assert (half[1] - half[0]) * gear.pitch_radius == pytest.approx(nominal - gear.backlash / 2.0, rel=1e-5)
    assert half[0] == pytest.approx(-half[1], rel=1e-9)


@every_spur
def test_diameters_and_width(part):
    gear, sizes = built(part), built(part).sizes()
    outline = [patch for patch in gear.boundary.patches if patch.name.startswith("loop 1.")]
    radii = np.concatenate([_plane(patch)[0] for patch in outline])
    assert 2.0 * radii.max() == pytest.approx(sizes["outside_diameter"].value, rel=1e-14)
    assert 2.0 * radii.min() == pytest.approx(sizes["root_diameter"].value, rel=1e-14)
    assert sizes["pitch_diameter"].value == pytest.approx(gear.teeth * sizes["module"].value)
    heights = np.concatenate([patch.point(U, U)[:, 2] for patch in outline])
    assert [heights.min(), heights.max()] == [0.0, gear.face_width]


@every_spur
def test_tip_thickness(part):
    gear = built(part)
    tips = [p for p in gear.boundary.patches if np.ptp(_plane(p)[0]) < 1e-12 and p.name.startswith("loop 1.")]
    tip = max(tips, key=lambda patch: _plane(patch)[0].max())
    width = np.ptp(_plane(tip)[1]) * _plane(tip)[0].max()
    assert width == pytest.approx(gear.sizes()["tip_thickness"].value, rel=1e-12)


def test_standard_proportions():
    sizes = SpurGear(teeth=20, module=3.0, face_width=10.0).sizes()
    expected = {
        "module": 3.0,
        "pitch_diameter": 60.0,
        "outside_diameter": 66.0,
        "root_diameter": 52.5,
        "base_diameter": 60.0 * np.cos(np.radians(20.0)),
        "addendum": 3.0,
        "dedendum": 3.75,
        "circular_pitch": 3.0 * np.pi,
        "circular_thickness": 1.5 * np.pi,
    }
    assert {name: sizes[name].value for name in expected} == pytest.approx(expected)


def test_bore_takes_away_a_cylinder():
    plain, bored = (SpurGear(teeth=20, module=3.0, face_width=10.0, bore=bore) for bore in (None, 24.0))
    taken = plain.properties(), bored.properties()
    assert taken[0].volume - taken[1].volume == pytest.approx(np.pi * 12.0**2 * 10.0, rel=1e-12)
    axial = taken[0].inertia[2, 2] - taken[1].inertia[2, 2]
    assert axial == pytest.approx(np.pi / 2.0 * 12.0**4 * 10.0, rel=1e-12)


def test_inches():
    inches = SpurGear(teeth=20, diametral_pitch=8.0, length_unit="in", face_width=0.5)
    millimetres = SpurGear(teeth=20, module=25.4 / 8.0, face_width=12.7)
    assert inches.properties().volume * 25.4**3 == pytest.approx(millimetres.properties().volume, rel=1e-13)
    assert inches.sizes()["pitch_diameter"].value == pytest.approx(2.5)


def test_the_module_is_told_in_millimetres_whatever_lengths_are_in():
    told = [
        SpurGear(teeth=24, diametral_pitch=8.0, face_width=1.0, length_unit=unit).description for unit in ("mm", "in")
    ]
    assert told == ["z = 24, m = 3.175 mm"] * 2

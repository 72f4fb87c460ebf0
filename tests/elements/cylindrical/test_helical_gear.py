"""Helical and herringbone gears: a turned spur gear's moments, the lead, the hand, symmetry about mid-face."""

from dataclasses import replace

import numpy as np
import pytest

from gearwright.curves.involute import Involute
from gearwright.elements.cylindrical.helical_gear import HelicalGear
from gearwright.elements.cylindrical.herringbone_gear import HerringboneGear
from gearwright.elements.cylindrical.internal_gear import InternalGear
from gearwright.motions.ends import between
from gearwright.motions.straight import Straight
from gearwright.solids.solid import flux_moments
from gearwright.solids.swept import Swept

from ...laws.contact import unmapped
from .profiles import polar

WIDTH = 12.0
HELICAL = {
    "plain": HelicalGear(teeth=17, module=2.0, face_width=WIDTH, helix_angle=20.0),
    "undercut, left, bored": HelicalGear(
        teeth=8, module=3.0, face_width=WIDTH, helix_angle=35.0, hand="left", bore=7.0
    ),
    "relieved, full radius": HelicalGear(
        teeth=25,
        transverse_module=2.0,
        face_width=WIDTH,
        helix_angle=15.0,
        basic_rack="agma-full-radius",
        tip_relief=0.02,
        tip_chamfer=0.1,
    ),
    "internal": InternalGear(teeth=40, module=2.0, face_width=WIDTH, helix_angle=25.0),
}
every_helical = pytest.mark.parametrize("name", HELICAL)


@every_helical
def test_moments_are_those_of_the_straight_extrusion(name):
    """Turning the section as it rises moves no mass along the axis or away from it."""
    gear = HELICAL[name]
    straight = Swept(section=gear.profile, motion=Straight(), ends=between(0.0, WIDTH)).properties()
    found = gear.properties()
    assert found.volume == pytest.approx(straight.volume, rel=1e-14)
    np.testing.assert_allclose(found.inertia, straight.inertia, atol=1e-14 * straight.inertia[2, 2])
    np.testing.assert_allclose(found.centroid, [0.0, 0.0, WIDTH / 2.0], atol=1e-14 * WIDTH)


def test_polyhedra_converge_to_the_exact_inertia():
    gear = HELICAL["plain"]
    exact = gear.properties().inertia[2, 2]
    tolerances = np.array([0.02, 0.005, 0.00125])
    errors = [abs(gear.polyhedron(t).properties().inertia[2, 2] / exact - 1.0) for t in tolerances]
    assert errors[-1] < 2e-4
    assert 0.8 < np.polyfit(np.log(tolerances), np.log(errors), 1)[0] < 1.3


def _turns(gear, heights):
    """Azimuths of the middle of the first tooth's tip at fractions of the face width."""
    tips = [p for p in gear.boundary.patches if _on_tip(gear, p)]
    patch = min(tips, key=lambda p: float(p.point(np.array(0.5), np.array(0.0))[2]))
    points = patch.point(np.full(len(heights), 0.5), heights)
    return points[:, 2], np.unwrap(polar(points[:, :2])[1])


def _on_tip(gear, patch):
    ends = patch.point(np.array([0.0, 1.0]), np.zeros(2))
    return np.allclose(polar(ends[:, :2])[0], gear.toothing.tip_radius, rtol=1e-12)


@every_helical
def test_teeth_rise_along_the_lead_in_the_sense_of_the_hand(name):
    """A right-hand helix turns counter-clockwise as it rises."""
    gear = HELICAL[name]
    z, azimuth = _turns(gear, np.linspace(0.0, 1.0, 5))
    slope = np.diff(azimuth) / np.diff(z)
    sense = -1.0 if gear.hand == "left" else 1.0
    lead = gear.sizes()["lead"].value
    np.testing.assert_allclose(slope, sense * 2.0 * np.pi / lead, rtol=1e-9)
    pitch_radius = gear.sizes()["pitch_diameter"].value / 2.0
    assert np.degrees(np.arctan(abs(slope[0]) * pitch_radius)) == pytest.approx(gear.helix_angle, rel=1e-9)
    base = gear.sizes()["base_diameter"].value / 2.0
    assert np.degrees(np.arctan(abs(slope[0]) * base)) == pytest.approx(
        gear.sizes()["base_helix_angle"].value, rel=1e-9
    )
    assert gear.sizes()["axial_pitch"].value == pytest.approx(lead / gear.teeth, rel=1e-14)
    pitches = abs(azimuth[-1] - azimuth[0]) / (2.0 * np.pi / gear.teeth)
    assert gear.sizes()["face_overlap"].value == pytest.approx(pitches, rel=1e-9)


@pytest.mark.parametrize("name", ["plain", "undercut, left, bored", "internal"])
def test_the_normal_section_has_the_module_and_pressure_angle(name):
    """On the pitch cylinder: distance of neighbouring flanks across the teeth, and lean of the surface's normal."""
    gear = HELICAL[name]
    flank = next(p for p in gear.boundary.patches if isinstance(unmapped(p.curve), Involute))
    u = np.linspace(0.0, 1.0, 20001)
    radius = polar(flank.point(u, 0.0 * u)[:, :2])[0]
    order = np.argsort(radius)
    at = np.array(np.interp(gear.pitch_radius, radius[order], u[order]))
    point, normal = flank.point(at, np.array(0.0)), flank.area_vector(at, np.array(0.0))
    normal = normal / np.linalg.norm(normal)
    radial = np.array([point[0], point[1], 0.0]) / gear.pitch_radius
    assert np.degrees(np.arcsin(abs(normal @ radial))) == pytest.approx(20.0, abs=1e-5)
    across = 2.0 * np.pi * gear.pitch_radius / gear.teeth * np.cos(np.radians(gear.helix_angle))
    assert across == pytest.approx(np.pi * gear.sizes()["module"].value, rel=1e-13)


@pytest.mark.parametrize("hand", ["right", "left"])
def test_herringbone_gears_have_the_moments_of_helical_ones_and_a_plane_of_symmetry(hand):
    shape = {"teeth": 19, "module": 2.0, "face_width": WIDTH, "helix_angle": 30.0, "hand": hand}
    helical, herringbone = HelicalGear(**shape), HerringboneGear(**shape)
    assert herringbone.properties().volume == pytest.approx(helical.properties().volume, rel=1e-14)
    one, other = (gear.properties().inertia for gear in (herringbone, helical))
    np.testing.assert_allclose(one, other, atol=1e-14 * other[2, 2])
    flux = flux_moments(herringbone.boundary)
    assert flux.volume == pytest.approx(helical.properties().volume, rel=1e-12)
    heights = np.linspace(0.0, 1.0, 9)
    z, azimuth = _turns(herringbone, heights)
    if z[-1] < WIDTH:
        upper = max(
            (p for p in herringbone.boundary.patches if _on_tip(herringbone, p)),
            key=lambda p: float(p.point(np.array(0.5), np.array(0.0))[2]),
        ).point(np.full(9, 0.5), heights)
        z, azimuth = np.append(z, upper[:, 2]), np.append(azimuth, polar(upper[:, :2])[1])
    order = np.argsort(z)
    z, azimuth = z[order], azimuth[order]
    rising = (1.0 if hand == "right" else -1.0) * np.tan(np.radians(30.0)) / herringbone.pitch_radius
    np.testing.assert_allclose(azimuth - azimuth[0], rising * np.minimum(z, WIDTH - z), atol=1e-12)


def test_hands_are_mirror_images():
    right = HELICAL["plain"]
    left = replace(right, hand="left")
    u, v = (a.ravel() for a in np.meshgrid(np.linspace(0.0, 1.0, 5), np.linspace(0.0, 1.0, 4)))
    clouds = [
        np.concatenate([p.pattern.images(p.point(u, v)).reshape(-1, 3) for p in gear.boundary.patches])
        for gear in (right, left)
    ]
    distance = np.linalg.norm(clouds[0][:400, None] * [1.0, -1.0, 1.0] - clouds[1][None], axis=-1).min(axis=1)
    assert distance.max() < 1e-12 * right.pitch_radius
    distance = np.linalg.norm(clouds[0][:400, None] - clouds[1][None], axis=-1).min(axis=1)
    assert distance.max() > 0.01


def test_a_helix_angle_of_nought_is_a_spur_gear():
    from gearwright.elements.cylindrical.spur_gear import SpurGear

    shape = {"teeth": 19, "module": 2.0, "face_width": WIDTH, "profile_shift": 0.2}
    spur = SpurGear(**shape)
    for kind in (HelicalGear, HerringboneGear):
        gear = kind(**shape, helix_angle=0.0)
        assert gear.properties().volume == spur.properties().volume
        assert {name: size.value for name, size in gear.sizes().items()} == {
            name: size.value for name, size in spur.sizes().items()
        }

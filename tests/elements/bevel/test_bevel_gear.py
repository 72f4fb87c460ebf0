"""A bevel gear's surface is what its parameters say, measured on points of its boundary."""

import numpy as np
import pytest

from gearwright.curves.spherical_involute import azimuth, roll_at_polar_angle
from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair

from ...examples import SHARP, SHARP_PARTS, built
from ...laws.contact import involute_patches

every_bevel = pytest.mark.parametrize("part", SHARP_PARTS, ids=str)
U, V = (a.ravel() for a in np.meshgrid(np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 5)))


def _spherical(points):
    """Cone distance, polar angle and azimuth."""
    distance = np.linalg.norm(points, axis=-1)
    return (
        distance,
        np.arctan2(np.hypot(points[..., 0], points[..., 1]), points[..., 2]),
        np.arctan2(points[..., 1], points[..., 0]),
    )


@every_bevel
def test_flanks_are_spherical_involutes_of_the_stated_thickness(part):
    gear = built(part)
    base, half = gear.tooth.base_cone_angle, gear.outer_thickness / gear.pitch_radius / 2.0
    at_pitch = azimuth(roll_at_polar_angle(gear.pitch_cone_angle, base), base)
    for patch, side in zip(involute_patches(gear), (-1.0, 1.0), strict=True):
        distance, polar, turned = _spherical(patch.point(U, V))
        own = turned - gear.tooth_trace.turn(distance)
        beyond = azimuth(roll_at_polar_angle(np.clip(polar, base, np.pi - base), base), base) - at_pitch
        np.testing.assert_allclose(side * own, half - beyond, atol=1e-9)
        assert polar.min() == pytest.approx(max(base, gear.tooth.root_angle), abs=1e-12)
        assert polar.max() == pytest.approx(gear.tooth.face_angle, abs=1e-12)
        assert distance.min() == pytest.approx(gear.inner_distance)
        assert distance.max() == pytest.approx(gear.cone_distance)


@every_bevel
def test_flanks_are_normal_to_the_base_cone_s_tangent_plane(part):
    """The great circle through a flank point along its normal touches the base cone, wherever the point is."""
    gear = built(part)
    for patch in involute_patches(gear):
        points = patch.point(np.linspace(0.05, 0.95, 7), np.ones(7))
        tangent = patch.partials(np.linspace(0.05, 0.95, 7), np.ones(7))[0]
        pole = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
        assert np.abs(np.sum(pole * points, axis=1)).max() < 1e-12 * gear.cone_distance
        # the great circle normal to the curve has the tangent for its pole, 90° − γ_b from the axis or 90° + γ_b
        np.testing.assert_allclose(np.abs(pole[:, 2]), np.sin(gear.tooth.base_cone_angle), atol=1e-12)


@every_bevel
def test_tip_and_root_lie_on_the_face_and_root_cones(part):
    gear = built(part)
    flat = [p for p in gear.boundary.patches if np.ptp(_spherical(p.point(U, V))[1]) < 1e-12]
    assert len(flat) == 2
    root, tip = sorted(float(_spherical(p.point(U, V))[1].mean()) for p in flat)
    assert tip == pytest.approx(gear.tooth.face_angle, abs=1e-12)
    assert root == pytest.approx(gear.tooth.root_angle, abs=1e-12)


@every_bevel
def test_diameters_and_tip_thickness(part):
    """The widest place of a tooth that leans beyond 90° is at 90°."""
    gear, sizes = built(part), built(part).sizes()
    u, v = (a.ravel() for a in np.meshgrid(np.linspace(0.0, 1.0, 4001), [0.0, 1.0]))
    outline = [patch for patch in gear.boundary.patches if patch.pattern.order == gear.teeth]
    outer = [patch.point(u[v == 1.0], v[v == 1.0]) for patch in outline]
    radii = [np.hypot(points[:, 0], points[:, 1]) for points in outer]
    assert 2.0 * max(r.max() for r in radii) == pytest.approx(sizes["outside_diameter"].value, rel=1e-6)
    flat = [p for p in outer if np.ptp(_spherical(p)[1]) < 1e-12]
    root, tip = sorted(flat, key=lambda points: _spherical(points)[1].mean())
    assert 2.0 * np.hypot(*root[0, :2]) == pytest.approx(sizes["root_diameter"].value, rel=1e-12)
    around = np.linalg.norm(np.diff(tip, axis=0), axis=1).sum()
    assert around == pytest.approx(sizes["tip_thickness"].value, rel=1e-6)
    assert sizes["pitch_diameter"].value == pytest.approx(gear.teeth * gear.outer_module)


def test_standard_proportions():
    sizes = BevelGear(teeth=20, module=3.0, pitch_angle=30.0, face_width=10.0).sizes()
    assert [sizes[name].value for name in ("addendum", "dedendum", "circular_thickness")] == pytest.approx(
        [3.0, 3.75, 1.5 * np.pi]
    )
    distances = [sizes[name].value for name in ("cone_distance", "mean_cone_distance", "inner_cone_distance")]
    assert distances == pytest.approx([60.0, 55.0, 50.0])
    pair = BevelPair(teeth=(20, 30), module=3.0, face_width=10.0)
    depths = [pair.sizes()[name].value for name in ("working_depth", "whole_depth", "clearance")]
    assert depths == pytest.approx([6.0, 6.75, 0.75])
    assert [one.sizes()["addendum"].value for one in (pair.pinion, pair.gear)] == pytest.approx([3.0, 3.0])


@every_bevel
def test_depths_at_the_outer_end_are_normal_to_the_pitch_line(part):
    """Tip and root cones pass the ends of addendum and dedendum on the normal to the pitch line."""
    gear = built(part)
    angle = gear.pitch_cone_angle
    along, normal = np.array([np.sin(angle), np.cos(angle)]), np.array([np.cos(angle), -np.sin(angle)])
    sizes = gear.sizes()
    for cone, depth in (("face_angle", sizes["addendum"].value), ("root_angle", -sizes["dedendum"].value)):
        point = gear.cone_distance * along + depth * normal
        assert np.degrees(np.arctan2(point[0], point[1])) == pytest.approx(sizes[cone].value, abs=1e-10)


@pytest.mark.parametrize(("hand", "sense"), [("right", 1.0), ("left", -1.0)])
@pytest.mark.parametrize("pitch_angle", [20.0, 60.0, 90.0])
def test_spiral_angle_is_the_one_asked_for_everywhere_and_of_the_right_hand(hand, sense, pitch_angle):
    """On the pitch cone, between tooth trace and generator; the outer half of a right-hand tooth leans clockwise
    seen from the apex, which is counter-clockwise about +z."""
    gear = BevelGear(
        teeth=24,
        module=3.0,
        pitch_angle=pitch_angle,
        face_width=12.0,
        trace="logarithmic",
        spiral_angle=35.0,
        hand=hand,
    )
    patch = involute_patches(gear)[0]
    u = np.linspace(0.0, 1.0, 2001)
    polar = _spherical(patch.point(u, np.zeros(2001)))[1]
    at_pitch = np.interp(gear.pitch_cone_angle, polar, u)
    v = np.linspace(0.0, 1.0, 5)
    points = patch.point(np.full(5, at_pitch), v)
    along = patch.partials(np.full(5, at_pitch), v)[1]
    radial = points / np.linalg.norm(points, axis=1, keepdims=True)
    around = np.cross([0.0, 0.0, 1.0], points)
    around /= np.linalg.norm(around, axis=1, keepdims=True)
    angle = np.degrees(np.arctan2(np.sum(along * around, axis=1), np.sum(along * radial, axis=1)))
    np.testing.assert_allclose(angle, sense * 35.0, atol=1e-4)


@every_bevel
def test_first_tooth_is_centred_on_x_at_the_mean_cone_distance(part):
    gear = built(part)
    rising, falling = involute_patches(gear)
    own = [patch.point(np.array(u), np.array(0.5)) for patch, u in ((rising, 1.0), (falling, 0.0))]
    assert np.linalg.norm(own[0]) == pytest.approx(gear.mean_distance)
    assert own[0][0] > 0.0
    np.testing.assert_allclose(own[0] * [1.0, -1.0, 1.0], own[1], atol=1e-12 * gear.cone_distance)


def test_bore_is_a_cylinder_through_the_body():
    gear = BevelGear(teeth=20, module=4.0, pitch_angle=50.0, face_width=15.0, bore=30.0, **SHARP)
    cylinder = [
        patch
        for patch in gear.boundary.patches
        if np.ptp(np.hypot(*np.moveaxis(patch.point(U, V), -1, 0)[:2])) < 1e-12 * gear.cone_distance
    ]
    assert len(cylinder) == 1
    points = cylinder[0].point(U, V)
    np.testing.assert_allclose(np.hypot(points[:, 0], points[:, 1]), 15.0, rtol=1e-14)
    assert [points[:, 2].min(), points[:, 2].max()] == pytest.approx(
        [np.sqrt(gear.inner_distance**2 - 225.0), np.sqrt(gear.cone_distance**2 - 225.0)]
    )
    inward = -points * [1.0, 1.0, 0.0]
    assert np.all(np.sum(cylinder[0].area_vector(U, V) * inward, axis=1) > 0.0)


def test_bore_takes_away_a_cylinder_between_spheres():
    """π ∫ over the bore of the height between the two spheres, in closed form."""
    plain, bored = (
        BevelGear(teeth=20, module=4.0, pitch_angle=50.0, face_width=15.0, bore=bore, **SHARP) for bore in (None, 30.0)
    )
    ends = plain.cone_distance, plain.inner_distance
    caps = [2.0 * np.pi / 3.0 * (r**3 - (r**2 - 225.0) ** 1.5) for r in ends]
    assert plain.properties().volume - bored.properties().volume == pytest.approx(caps[0] - caps[1], rel=1e-11)


def test_pitch_angle_and_mate_say_the_same():
    """tan δ = sin Σ/(z₂/z₁ + cos Σ)."""
    by_mate = BevelGear(teeth=18, mate_teeth=27, shaft_angle=60.0, module=3.0, face_width=15.0)
    by_angle = BevelGear(teeth=18, pitch_angle=by_mate.sizes()["pitch_angle"].value, module=3.0, face_width=15.0)
    assert by_mate.properties().volume == pytest.approx(by_angle.properties().volume, rel=1e-12)
    own, other = by_mate.pitch_cone_angle, np.radians(60.0) - by_mate.pitch_cone_angle
    assert np.sin(other) / np.sin(own) == pytest.approx(1.5)


def test_units():
    """One part in inches and in millimetres, by diametral pitch and by module."""
    inches = BevelGear(teeth=20, diametral_pitch=2.0, length_unit="in", pitch_angle=50.0, face_width=1.5)
    millimetres = BevelGear(teeth=20, module=12.7, pitch_angle=50.0, face_width=1.5 * 25.4)
    assert inches.properties().volume * 25.4**3 == pytest.approx(millimetres.properties().volume, rel=1e-13)
    mixed = BevelGear(teeth=20, module=12.7, length_unit="in", pitch_angle=50.0, face_width=1.5)
    assert mixed.properties().volume == pytest.approx(inches.properties().volume, rel=1e-13)


class TestPair:
    PAIR = BevelPair(
        teeth=(16, 20),
        module=4.0,
        face_width=15.0,
        working_depth=7.0,
        whole_depth=8.0,
        gear_addendum=3.0,
        backlash=0.2,
        circular_thickness=(6.5, 6.0),
        bore=(10.0, 20.0),
        trace="logarithmic",
        spiral_angle=30.0,
        hand="left",
    )

    def test_depths_are_shared_out(self):
        pinion, gear = self.PAIR.pinion.sizes(), self.PAIR.gear.sizes()
        assert [pinion["addendum"].value, gear["addendum"].value] == pytest.approx([4.0, 3.0])
        assert [pinion["dedendum"].value, gear["dedendum"].value] == pytest.approx([4.0, 5.0])

    def test_each_member_gets_its_own_values(self):
        pinion, gear = self.PAIR.pinion, self.PAIR.gear
        assert (pinion.bore, gear.bore) == (10.0, 20.0)
        assert (pinion.hand, gear.hand) == ("left", "right")
        assert (pinion.trace, gear.spiral_angle) == ("logarithmic", 30.0)
        thickness = [one.sizes()["circular_thickness"].value for one in (pinion, gear)]
        assert thickness == pytest.approx([6.4, 5.9])

    def test_pitch_cones_touch(self):
        pinion, gear = self.PAIR.pinion, self.PAIR.gear
        assert pinion.pitch_cone_angle + gear.pitch_cone_angle == pytest.approx(np.pi / 2.0)
        assert pinion.cone_distance == pytest.approx(gear.cone_distance, rel=1e-15)

    def test_one_value_goes_to_both(self):
        pair = BevelPair(teeth=(16, 20), module=4.0, face_width=15.0, bore=12.0)
        assert pair.pinion.bore == pair.gear.bore == 12.0

"""Pairs in motion: MuJoCo simulates what is written for it."""

from xml.etree import ElementTree as ET

import mujoco
import numpy as np
import pytest

import gearwright as gw

PAIRS = {
    "spur": gw.GearPair(kind="spur", teeth=(13, 27), module=2.0, face_width=6.0),
    "internal": gw.GearPair(kind="internal", teeth=(16, 44), module=1.5, face_width=5.0, helix_angle=15.0),
    "rack": gw.GearPair(kind="rack", teeth=(14, 40), module=2.0, face_width=6.0),
    "bevel in inches": gw.BevelPair(
        teeth=(16, 24), diametral_pitch=8.0, length_unit="in", face_width=0.5, shaft_angle=80.0
    ),
}
RATIOS = {"spur": -13 / 27, "internal": 16 / 44, "rack": 0.014, "bevel in inches": -16 / 24}
"""Of the gear's turn, or of the rack's travel in m, to the pinion's turn."""

every_pair = pytest.mark.parametrize("kind", PAIRS)


def simulated(pair, path, torque, seconds):
    """After a torque (N m) on the pinion for so long: both joints' values and speeds."""
    tolerance = 0.02 * float(np.linalg.norm(np.ptp(pair.pinion.properties().bounding_box, axis=0)))
    pair.save(path, tolerance, density="steel")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for _ in range(round(seconds / model.opt.timestep)):
        data.qfrc_applied[0] = torque
        mujoco.mj_step(model, data)
    return data


@every_pair
def test_a_torque_turns_both_members_at_the_ratio_of_the_teeth(tmp_path, kind):
    pair, ratio = PAIRS[kind], RATIOS[kind]
    torque, seconds = 1e-3, 0.4
    data = simulated(pair, tmp_path / "pair.xml", torque, seconds)
    assert data.ncon == 0
    metres = 25.4e-3 if pair.length_unit == "in" else 1e-3
    density = gw.density("steel", length_unit=pair.length_unit)
    pinion, gear = (member.properties(density) for member in (pair.pinion, pair.gear))
    first = pinion.inertia[2, 2] * metres**2
    second = gear.mass if kind == "rack" else gear.inertia[2, 2] * metres**2
    speed = torque * seconds / (first + ratio**2 * second)  # gravity does no work: both axes are principal, or level
    assert speed * seconds > 0.05  # it moves
    # the constraint does no work and the model no damping, so speeds are right to rounding
    assert data.qvel[0] == pytest.approx(speed, rel=1e-12)
    assert data.qvel[1] == pytest.approx(ratio * speed, rel=1e-12)
    # angles lag: MuJoCo leaves 1e-4 of the pinion's acceleration if it were free, times the time constant squared
    assert abs(data.qpos[1] / ratio - data.qpos[0]) < 1e-4 * (torque / first) * 0.004**2


def test_a_rack_stops_where_its_teeth_end(tmp_path):
    pair = gw.GearPair(kind="rack", teeth=(14, 5), module=2.0, face_width=6.0)
    pitch = 2e-3 * np.pi
    for torque, end in ((1e-3, 3.0 * pitch), (-1e-3, -2.0 * pitch)):
        data = simulated(pair, tmp_path / "pair.xml", torque, 3.0)
        assert data.qpos[1] == pytest.approx(end, abs=0.02 * pitch)  # the end is as soft as MuJoCo's ends are
        # there its outermost flank is at the pinion's axis
        pinned = pair.placements(np.degrees(end / 0.014))[1][1, 3] / 1e3
        assert (pinned - (2 - 0.5) * pitch) == pytest.approx(end)


def test_urdf_turns_at_the_ratio_in_mujoco(tmp_path):
    data = simulated(PAIRS["spur"], tmp_path / "pair.urdf", 1e-3, 0.4)
    assert data.ncon == 0
    assert data.qvel[1] / data.qvel[0] == pytest.approx(-13 / 27, rel=1e-3)  # the file cannot make the constraint stiff


@pytest.mark.parametrize("suffix", [".xml", ".urdf"])
def test_joints_are_at_0_where_the_pinion_is_turned(tmp_path, suffix):
    pair = PAIRS["rack"]
    mechanism = pair.mechanism("pair", "steel", 0.5, turn=30.0)
    for link, placement in zip(mechanism.links, pair.placements(30.0), strict=True):
        np.testing.assert_allclose(link.placement[:3, 3], placement[:3, 3] / 1e3, rtol=0, atol=1e-15)
        np.testing.assert_array_equal(link.placement[:3, :3], placement[:3, :3])
    travelled = 0.014 * np.pi / 6
    plain = pair.mechanism("pair", "steel", 0.5)
    np.testing.assert_allclose(np.add(mechanism.joints[1].range, travelled), plain.joints[1].range, atol=1e-15)


@every_pair
def test_the_motion_of_a_joint_is_that_of_the_placements(kind):
    pair = PAIRS[kind]
    joints, links = (getattr(pair.mechanism("pair", 1000, 1.0), name) for name in ("joints", "links"))
    value = np.radians(40.0)
    for joint, link, placement in zip(joints, links, pair.placements(40.0), strict=True):
        moved = link.placement @ joint.motion(value * (1.0 if joint.ratio is None else joint.ratio))
        metres = 25.4e-3 if pair.length_unit == "in" else 1e-3
        placement[:3, 3] *= metres
        np.testing.assert_allclose(moved, placement, rtol=0, atol=1e-14)


def test_a_part_alone_falls_free_and_keeps_turning_about_a_principal_axis(tmp_path):
    gear = gw.SpurGear(teeth=16, module=2.0, face_width=5.0)
    gear.save(tmp_path / "gear.xml", 0.5, density="brass")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "gear.xml"))
    data = mujoco.MjData(model)
    data.qvel[5] = 7.0
    for _ in range(250):
        mujoco.mj_step(model, data)
    assert data.qvel[2] == pytest.approx(-9.81 * 0.5, rel=1e-9)
    np.testing.assert_allclose(data.qvel[3:], (0.0, 0.0, 7.0), atol=1e-9)


def test_a_sum_of_solids_is_written_too(tmp_path):
    shaft = gw.extrude(gw.Section.circle(4.0), 30.0)
    shaft.save(tmp_path / "shaft.xml", density=2700.0)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "shaft.xml"))
    assert model.body("part").mass == pytest.approx(2700.0 * np.pi * 0.004**2 * 0.03, rel=1e-14)


def test_other_bodies_touch_each_member_once_and_the_members_do_not_touch(tmp_path):
    """A ball of 2 mm on a tip of the pinion and one in the middle of the gear's far side."""
    pair = PAIRS["spur"]
    pair.save(tmp_path / "pair.xml", 0.5, density="steel")
    tree = ET.parse(tmp_path / "pair.xml")  # noqa: S314  our own file
    for place in ("-0.0155 0 0.003", "0.068 0 0.003"):
        ball = ET.SubElement(tree.find("worldbody"), "body", {"pos": place})
        ET.SubElement(ball, "freejoint")
        ET.SubElement(ball, "geom", {"type": "sphere", "size": "0.002", "mass": "0.001"})
    tree.write(tmp_path / "balls.xml")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "balls.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data)
    touching = [sorted(model.body(model.geom_bodyid[g]).name for g in contact.geom) for contact in data.contact]
    assert sorted(touching) == [["", "gear"], ["", "pinion"]]
    assert {int(model.geom_group[g]) for contact in data.contact for g in contact.geom} == {0, 3}


def test_urdf_and_sdformat_say_where_a_rack_ends(tmp_path):
    pair = PAIRS["rack"]  # 40 teeth, 20 on either side of the pinion
    end = 20 * 2e-3 * np.pi
    pair.save(tmp_path / "pair.urdf", 0.5, density="steel")
    urdf = ET.parse(tmp_path / "pair.urdf").find("joint[@name='gear_joint']")  # noqa: S314  our own file
    assert urdf.get("type") == "prismatic"
    assert set(urdf.find("limit").keys()) == {"lower", "upper", "effort", "velocity"}
    assert [float(urdf.find("limit").get(name)) for name in ("lower", "upper")] == pytest.approx([-end, end])
    pair.save(tmp_path / "pair.sdf", 0.5, density="steel")
    sdf = ET.parse(tmp_path / "pair.sdf").find("model/joint[@name='gear_joint']")  # noqa: S314  our own file
    assert [float(sdf.findtext(f"axis/limit/{name}")) for name in ("lower", "upper")] == pytest.approx([-end, end])

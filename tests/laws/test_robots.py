"""Files for simulators hold every element as it is: mass and inertia, where it stands, how the pair moves.

MuJoCo reads MJCF and URDF; SDFormat is read here as its specification has it.
"""

from functools import cache
from xml.etree import ElementTree as ET

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import gearwright as gw
from gearwright import catalog
from gearwright.boundary.extent import rough_diagonal
from gearwright.solids.robots import save_mechanism

from ..examples import BY_NAME, EXAMPLES

METRES = {"mm": 1e-3, "in": 25.4e-3}
COARSE = 0.02  # of meshes, by the element's diagonal: what is stated does not depend on them
TURNS = (0.0, 1.0, -23.0, 170.0)  # of pinions, degrees
KNOWN_TO_MUJOCO = 5e-15
"""Relative: MuJoCo keeps the tensor as principal moments and a quaternion, both in doubles."""

BY_KIND = [(name, example) for name in BY_NAME for example in EXAMPLES[name]]
every_element = pytest.mark.parametrize(("name", "example"), BY_KIND, ids=lambda word: word)


@cache
def element_of(name, example):
    entry = BY_NAME[name]
    return catalog.load(entry.source)(**entry.settled, **EXAMPLES[name][example])


def members_of(element, name):
    return {"part": element} if BY_NAME[name].members == 1 else {"pinion": element.pinion, "gear": element.gear}


def in_si(member):
    """Mass, centroid and central inertia in kg and m, of steel."""
    metres = METRES[member.length_unit]
    body = member.properties(gw.density("steel", length_unit=member.length_unit))
    return body.mass, body.centroid * metres, body.central_inertia * metres**2


def placement_in_m(placement, unit):
    moved = placement.copy()
    moved[:3, 3] *= METRES[unit]
    return moved


@cache
def mechanism_of(name, example):
    element = element_of(name, example)
    diagonal = rough_diagonal(getattr(element, "pinion", element).boundary)
    return element.mechanism("robot", "steel", COARSE * diagonal)


def saved(name, example, path):
    save_mechanism(path, mechanism_of(name, example))
    return path


@pytest.mark.parametrize("suffix", [".xml", ".urdf"])
@every_element
def test_mujoco_finds_the_masses_the_inertia_and_the_motion(tmp_path, name, example, suffix):
    element = element_of(name, example)
    model = mujoco.MjModel.from_xml_path(str(saved(name, example, tmp_path / f"robot{suffix}")))
    members = members_of(element, name)
    assert [model.body(i).name for i in range(model.nbody)] == ["world", *members]
    for one, member in members.items():
        body = model.body(one)
        mass, centroid, inertia = in_si(member)
        assert model.body_mass[body.id] == mass
        np.testing.assert_allclose(body.ipos, centroid, rtol=0, atol=1e-15)
        w, x, y, z = body.iquat
        axes = Rotation.from_quat([x, y, z, w]).as_matrix()
        found = axes @ np.diag(body.inertia) @ axes.T
        np.testing.assert_allclose(found, inertia, rtol=0, atol=KNOWN_TO_MUJOCO * np.abs(inertia).max())
        _assert_mesh_is_the_member(model, body, member)
    if len(members) == 2:
        for turn in TURNS:
            _assert_stands_where_it_meshes(model, element, turn)


def _assert_mesh_is_the_member(model, body, member):
    """The box of the mesh in the body's frame is the member's to the tolerance."""
    (geom, *_) = [g for g in range(model.ngeom) if model.geom_bodyid[g] == body.id]
    mesh = model.geom_dataid[geom]
    first = model.mesh_vertadr[mesh]
    vertices = model.mesh_vert[first : first + model.mesh_vertnum[mesh]].astype(float)
    w, x, y, z = model.geom_quat[geom]
    placed = vertices @ Rotation.from_quat([x, y, z, w]).as_matrix().T + model.geom_pos[geom]
    box = member.properties().bounding_box * METRES[member.length_unit]
    found = np.stack([placed.min(axis=0), placed.max(axis=0)])
    np.testing.assert_allclose(found, box, rtol=0, atol=2.0 * COARSE * np.linalg.norm(np.ptp(box, axis=0)))


def _assert_stands_where_it_meshes(model, pair, turn):
    """The pinion's joint at the turn, the gear's where the file's ratio then has it."""
    assert model.neq == 1
    offset, ratio, *others = model.eq_data[0, :5]
    assert (offset, *others) == (0.0, 0.0, 0.0, 0.0)
    leader, follower = (model.joint(f"{one}_joint").id for one in ("pinion", "gear"))
    if model.eq_obj1id[0] == leader:
        ratio = 1.0 / ratio
    assert {model.eq_obj1id[0], model.eq_obj2id[0]} == {leader, follower}
    data = mujoco.MjData(model)
    value = np.radians(turn)
    data.qpos[model.jnt_qposadr[leader]] = value
    data.qpos[model.jnt_qposadr[follower]] = ratio * value
    mujoco.mj_kinematics(model, data)
    for one, placement in zip(("pinion", "gear"), pair.placements(turn), strict=True):
        wanted = placement_in_m(placement, pair.length_unit)
        np.testing.assert_allclose(data.body(one).xmat.reshape(3, 3), wanted[:3, :3], rtol=0, atol=1e-14)
        np.testing.assert_allclose(data.body(one).xpos, wanted[:3, 3], rtol=0, atol=1e-15)


def _posed(text):
    """x y z, then turns about the fixed axes x, y and z."""
    values = np.array([float(word) for word in text.split()])
    placement = np.eye(4)
    placement[:3, :3] = Rotation.from_euler("xyz", values[3:]).as_matrix()
    placement[:3, 3] = values[:3]
    return placement


@every_element
def test_sdformat_says_the_same(tmp_path, name, example):
    element = element_of(name, example)
    root = ET.parse(saved(name, example, tmp_path / "robot.sdf")).getroot()  # noqa: S314  our own file
    assert (root.tag, root.get("version")) == ("sdf", "1.11")
    (model,) = root
    assert (model.tag, model.get("name")) == ("model", "robot")
    members = members_of(element, name)
    names = [child.get("name") for child in model]
    assert len(set(names)) == len(names)  # siblings of any kind, as the specification asks
    links = {link.get("name"): link for link in model.findall("link")}
    assert list(links) == list(members)
    for one, member in members.items():
        assert [child.tag for child in links[one]] == ["pose", "inertial", "visual", "collision"]
        for mesh in links[one].iter("uri"):
            assert (tmp_path / mesh.text).is_file()
        _assert_inertia_about_the_origin(links[one].find("inertial"), member)
    if len(members) == 2:
        for turn in TURNS:
            _assert_sdf_stands_where_it_meshes(model, links, element, turn)


def _assert_inertia_about_the_origin(inertial, member):
    """By parallel axes from what is written: the tensor that the member has about its origin."""
    placement, mass = _posed(inertial.findtext("pose")), float(inertial.findtext("mass"))
    xx, xy, xz, yy, yz, zz = (float(inertial.findtext(f"inertia/i{n}")) for n in "xx xy xz yy yz zz".split())
    local = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    turned, arm = placement[:3, :3], placement[:3, 3]
    about_origin = turned @ local @ turned.T + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    metres = METRES[member.length_unit]
    body = member.properties(gw.density("steel", length_unit=member.length_unit))
    assert mass == body.mass
    wanted = body.inertia * metres**2
    np.testing.assert_allclose(about_origin, wanted, rtol=0, atol=1e-14 * np.abs(wanted).max())
    moments = np.linalg.eigvalsh(local)
    assert moments[0] > 0.0
    assert moments[2] < moments[0] + moments[1]


def _assert_sdf_stands_where_it_meshes(model, links, pair, turn):
    joints = {joint.findtext("child"): joint for joint in model.findall("joint")}
    assert [joint.findtext("parent") for joint in joints.values()] == ["world", "world"]
    mimic = joints["gear"].find("axis/mimic")
    assert mimic.get("joint") == joints["pinion"].get("name")
    leader = np.radians(turn)
    follower = float(mimic.findtext("multiplier")) * (leader - float(mimic.findtext("reference")))
    values = {"pinion": leader, "gear": follower + float(mimic.findtext("offset"))}
    for (one, value), placement in zip(values.items(), pair.placements(turn), strict=True):
        axis = value * np.array([float(word) for word in joints[one].findtext("axis/xyz").split()])
        moved = np.eye(4)
        if joints[one].get("type") == "prismatic":
            moved[:3, 3] = axis
        else:
            assert joints[one].get("type") == "continuous"
            moved[:3, :3] = Rotation.from_rotvec(axis).as_matrix()
        wanted = placement_in_m(placement, pair.length_unit)
        np.testing.assert_allclose(_posed(links[one].findtext("pose")) @ moved, wanted, rtol=0, atol=1e-14)


@every_element
def test_urdf_is_a_tree_with_the_inertia_of_every_part(tmp_path, name, example):
    element = element_of(name, example)
    root = ET.parse(saved(name, example, tmp_path / "robot.urdf")).getroot()  # noqa: S314  our own file
    assert (root.tag, root.get("name")) == ("robot", "robot")
    links = {link.get("name"): link for link in root.findall("link")}
    members = members_of(element, name)
    joints = root.findall("joint")
    assert list(links) == [*(["world"] if joints else []), *members]
    assert [joint.find("child").get("link") for joint in joints] == (list(members) if joints else [])
    assert {joint.find("parent").get("link") for joint in joints} <= {"world"}
    for one, member in members.items():
        for mesh in links[one].iter("mesh"):
            assert (tmp_path / mesh.get("filename")).is_file()
        inertial = links[one].find("inertial")
        mass, centroid, inertia = in_si(member)
        assert float(inertial.find("mass").get("value")) == mass
        arm = np.array([float(word) for word in inertial.find("origin").get("xyz").split()])
        np.testing.assert_array_equal(arm, centroid)
        assert inertial.find("origin").get("rpy") == "0.0 0.0 0.0"
        stated = inertial.find("inertia")
        components = [[float(stated.get(f"i{''.join(sorted(a + b))}")) for b in "xyz"] for a in "xyz"]
        np.testing.assert_array_equal(components, inertia)

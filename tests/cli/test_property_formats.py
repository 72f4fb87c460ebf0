"""Properties about other points, along other axes, as CSV and as inertial elements."""

import csv
import io
import json
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from .bodies import box, put

SIZE, AT = np.array([1.0, 2.0, 3.0]), np.array([10.0, 0.0, 0.0])
TURN = Rotation.from_rotvec([0.3, -0.4, 0.5]).as_matrix()


@pytest.fixture
def file(monkeypatch):
    put(monkeypatch, brick=[box("brick", SIZE, AT)], turned=[turned_box()])


def turned_box():
    body = box("turned", SIZE, AT)
    return type(body)(name="turned", vertices=body.vertices @ TURN.T, indices=body.indices, offsets=body.offsets)


def parsed(text):
    return ET.fromstring(text)  # noqa: S314  our own text


def document(run, *words):
    outcome = run("properties", *words, "--json")
    assert outcome.code == 0, outcome.err
    return json.loads(outcome.out)


def central(size):
    """Central inertia of a box, from the textbook."""
    x, y, z = np.square(size)
    return np.prod(size) / 12 * np.diag([y + z, z + x, x + y])


def test_inertia_about_a_point(run, file):
    found = document(run, "brick", "--about", "10.5", "1", "-3.5")
    arm = np.array([0.0, 0.0, 5.0])
    wanted = central(SIZE) + 6 * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    np.testing.assert_allclose(found["about"]["inertia"], wanted, atol=1e-12)
    assert found["about"]["point"] == [10.5, 1, -3.5]
    table = run("properties", "brick", "--about", "10.5", "1", "-3.5").out
    assert "Ixx about the point" in table
    assert "(10.5, 1, -3.5) mm" in table


def test_axes_of_the_file_are_the_default(run, file):
    found = document(run, "turned")
    np.testing.assert_allclose(found["central_inertia"], TURN @ central(SIZE) @ TURN.T, atol=1e-12)
    assert found["axes"]["name"] == "file"
    assert found["axes"]["quaternion"] == [1, 0, 0, 0]


def test_principal_axes_make_every_central_tensor_diagonal(run, file):
    found = document(run, "turned", "--axes", "principal", "--about", "0", "0", "0")
    np.testing.assert_allclose(found["central_inertia"], np.diag(found["principal_moments"]), atol=1e-13)
    np.testing.assert_allclose(list(found["central_products"].values()), 0, atol=1e-13)
    np.testing.assert_allclose(found["axes"]["rotation"], found["principal_axes"], atol=1e-15)
    np.testing.assert_allclose(found["about"]["inertia"], found["inertia"], atol=1e-11)
    np.testing.assert_allclose(found["centroid"], TURN @ (AT + SIZE / 2), atol=1e-13)


@pytest.mark.parametrize("as_", ["quaternion", "rows"])
def test_axes_given_are_columns_of_the_rotation(run, file, as_):
    x, y, z, w = Rotation.from_matrix(TURN).as_quat()
    given = [w, x, y, z] if as_ == "quaternion" else TURN.ravel()
    found = document(run, "turned", "--about", "1", "2", "3", f"--axes={','.join(map(repr, map(float, given)))}")
    # along the brick's own edges it is as if it had not been turned
    np.testing.assert_allclose(found["central_inertia"], central(SIZE), atol=1e-12)
    straight = document(run, "brick")
    for name in ("inertia", "second_moment"):
        np.testing.assert_allclose(found[name], straight[name], atol=1e-10)
    assert found["products"] == pytest.approx(straight["products"], abs=1e-10)
    point = document(run, "brick", "--about", *(repr(float(one)) for one in TURN.T @ [1, 2, 3]))["about"]["inertia"]
    np.testing.assert_allclose(found["about"]["inertia"], point, atol=1e-10)
    assert found["axes"]["name"] == "given"
    np.testing.assert_allclose(found["axes"]["rotation"], TURN, atol=1e-14)


def test_both_signs_are_there(run, file):
    found = document(run, "brick")
    assert found["products"]["xy"] == pytest.approx(6 * 10.5 * 1)
    assert found["inertia"][0][1] == pytest.approx(-6 * 10.5 * 1)
    assert "Ixy = −∫xy dm" in run("properties", "brick").out


def test_csv_has_a_row_for_each_body_and_one_for_all(run, monkeypatch):
    put(monkeypatch, pair=[box("a, b", [1, 1, 1]), box('"c"', [1, 1, 2], [3, 0, 0])], one=[box("d", [2, 2, 2])])
    rows = list(csv.DictReader(io.StringIO(run("properties", "pair", "one", "--format", "csv", "--sum").out)))
    assert [(row["file"], row["body"]) for row in rows] == [
        ("pair", "a, b"),
        ("pair", '"c"'),
        ("pair", ""),
        ("one", ""),
        ("all together", ""),
    ]
    assert [float(row["volume"]) for row in rows] == pytest.approx([1, 2, 3, 8, 11])
    whole = document(run, "pair")
    for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)):
        name = f"i{'xyz'[min(i, j)]}{'xyz'[max(i, j)]}" if (i, j) != (2, 0) else "izx"
        assert float(rows[2][name]) == whole["inertia"][i][j]
        assert float(rows[2][f"central_{name}"]) == whole["central_inertia"][i][j]


def tensor_of(element):
    """The tensor about the centre of mass in the file's frame, as each format defines it."""
    if element.get("fullinertia"):
        xx, yy, zz, xy, xz, yz = map(float, element.get("fullinertia").split())
        return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if element.get("diaginertia"):
        w, x, y, z = map(float, element.get("quat").split())
        turned = Rotation.from_quat([x, y, z, w]).as_matrix()
        return turned @ np.diag([float(one) for one in element.get("diaginertia").split()]) @ turned.T
    inertia = element.find("inertia")
    value = inertia.get if inertia.attrib else inertia.findtext
    xx, xy, xz, yy, yz, zz = (float(value(name)) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    angles = element.find("origin").get("rpy") if inertia.attrib else " ".join(element.findtext("pose").split()[3:])
    turned = Rotation.from_euler("xyz", [float(one) for one in angles.split()]).as_matrix()
    return turned @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turned.T


@pytest.mark.parametrize(
    ("format_", "axes"),
    [
        *((format_, axes) for format_ in ("urdf", "sdf", "mjcf") for axes in ("file", "principal")),
        *((format_, "0.5,0.5,-0.5,0.5") for format_ in ("urdf", "sdf")),  # MJCF has no such axes
    ],
)
def test_inertial_elements_are_in_si_units_and_give_the_tensor_back(run, file, format_, axes):
    outcome = run(
        "properties", "turned", *"--density 1000 --length-unit cm".split(), "--format", format_, "--axes", axes
    )
    assert outcome.code == 0, outcome.err
    element = parsed(outcome.out)
    # 6 cm³ of water weigh 6 g; a box in m
    wanted = TURN @ central(SIZE / 100) @ TURN.T * 1000
    np.testing.assert_allclose(tensor_of(element), wanted, rtol=1e-12, atol=1e-12 * wanted.max())
    mass = element.get("mass") or element.findtext("mass") or element.find("mass").get("value")
    assert float(mass) == pytest.approx(0.006, rel=1e-14)
    origin = element.find("origin")
    place = element.get("pos") or element.findtext("pose") or origin.get("xyz")
    centre = [float(one) for one in place.split()[:3]]
    np.testing.assert_allclose(centre, TURN @ (AT + SIZE / 2) / 100, atol=1e-15)


def test_each_body_has_an_element_of_its_own(run, monkeypatch):
    put(monkeypatch, pair=[box("a", [1, 1, 1]), box("b", [1, 1, 2], [3, 0, 0])])
    text = run("properties", "pair", "--format", "urdf", "--material", "steel").out
    assert [line for line in text.splitlines() if line.startswith("<!--")] == ["<!-- pair: a -->", "<!-- pair: b -->"]
    first, second = parsed(f"<all>{text}</all>")
    assert float(second.find("mass").get("value")) == pytest.approx(2 * float(first.find("mass").get("value")))


def test_materials_are_listed(run):
    table = run("materials")
    assert table.code == 0
    assert "stainless steel" in table.out
    assert "aluminum" in table.out
    listed = {one["name"]: one for one in json.loads(run("materials", "--json").out)["materials"]}
    assert listed["steel"]["density"] == 7850
    assert listed["steel"]["unit"] == "kg/m^3"

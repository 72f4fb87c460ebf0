"""Inertial elements: read back as their formats define them, they give the tensor they were written from."""

from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gearwright.files.inertial import Inertial, mjcf, sdf, urdf
from gearwright.rotations import rotation_of

AXES = rotation_of([0.3, -0.5, 0.7, 0.2])
OWN = np.array([[3.0, 0.4, -0.2], [0.4, 4.0, 0.1], [-0.2, 0.1, 5.0]])
CENTROID = np.array([0.1, -0.2, 1 / 3])


def parsed(text):
    return ET.fromstring(text)  # noqa: S314  our own text


def body(axes=AXES, inertia=OWN, name="a part"):
    return Inertial(name=name, mass=2.5, centroid=CENTROID, axes=axes, inertia=inertia)


def numbers(text):
    return np.array([float(word) for word in text.split()])


def tensor(xx, xy, xz, yy, yz, zz):
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def in_the_body_s_frame(local, angles):
    """Turns about the fixed axes x, y and z, as both formats define them."""
    turned = Rotation.from_euler("xyz", angles).as_matrix()
    return turned @ local @ turned.T


def test_urdf_reads_back():
    element = parsed(urdf(body()))
    assert element.tag == "inertial"
    origin, mass, inertia = element
    assert (origin.tag, mass.tag, inertia.tag) == ("origin", "mass", "inertia")
    assert float(mass.get("value")) == 2.5
    np.testing.assert_array_equal(numbers(origin.get("xyz")), CENTROID)
    local = tensor(*(float(inertia.get(name)) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")))
    found = in_the_body_s_frame(local, numbers(origin.get("rpy")))
    np.testing.assert_allclose(found, AXES @ OWN @ AXES.T, atol=1e-14)


def test_sdf_reads_back():
    element = parsed(sdf(body()))
    assert [child.tag for child in element] == ["pose", "mass", "inertia"]
    assert float(element.findtext("mass")) == 2.5
    pose = numbers(element.findtext("pose"))
    np.testing.assert_array_equal(pose[:3], CENTROID)
    names = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    assert [child.tag for child in element.find("inertia")] == list(names)
    local = tensor(*(float(element.findtext(f"inertia/{name}")) for name in names))
    np.testing.assert_allclose(in_the_body_s_frame(local, pose[3:]), AXES @ OWN @ AXES.T, atol=1e-14)


def test_mjcf_along_the_body_s_axes_reads_back():
    element = parsed(mjcf(body(axes=np.eye(3))))
    assert list(element.attrib) == ["pos", "mass", "fullinertia"]
    np.testing.assert_array_equal(numbers(element.get("pos")), CENTROID)
    xx, yy, zz, xy, xz, yz = numbers(element.get("fullinertia"))
    np.testing.assert_array_equal(tensor(xx, xy, xz, yy, yz, zz), OWN)


def test_mjcf_along_principal_axes_reads_back():
    element = parsed(mjcf(body(inertia=np.diag([3.0, 4.0, 5.0]))))
    assert list(element.attrib) == ["pos", "mass", "quat", "diaginertia"]
    w, x, y, z = numbers(element.get("quat"))
    turned = Rotation.from_quat([x, y, z, w]).as_matrix()
    found = turned @ np.diag(numbers(element.get("diaginertia"))) @ turned.T
    np.testing.assert_allclose(found, AXES @ np.diag([3.0, 4.0, 5.0]) @ AXES.T, atol=1e-14)


def test_mjcf_has_no_words_for_products_along_turned_axes():
    with pytest.raises(ValueError, match="no words"):
        mjcf(body())


@pytest.mark.parametrize("write", [urdf, sdf, mjcf])
@pytest.mark.parametrize("name", ["", "a--b", "a-", "---", "a -->\n<b>", "ä & <c>", "\x00"])
def test_any_name_makes_a_comment_that_xml_takes(write, name):
    text = write(body(axes=np.eye(3), name=name))
    assert parsed(text).tag == "inertial"
    assert text.startswith("<!-- ")


def test_every_digit_is_kept():
    third = parsed(urdf(body())).find("origin").get("xyz").split()[2]
    assert float(third) == 1 / 3
    assert "-0.0 " not in urdf(body(axes=np.eye(3), inertia=-0.0 * OWN))

"""Elements of XML as these formats have them: attributes, or text, of numbers with all their digits."""

from __future__ import annotations

from collections.abc import Mapping
from xml.etree import ElementTree as ET

from ...arrays import Array
from ...rotations import quaternion_of, roll_pitch_yaw
from ..inertial import Inertial, Writer, numbers

Element = ET.Element


def add(parent: Element, name: str, attributes: Mapping[str, str] | None = None, text: str | None = None) -> Element:
    """A new last child."""
    child = ET.SubElement(parent, name, dict(attributes or {}))
    child.text = text
    return child


def add_inertial(parent: Element, writer: Writer, inertial: Inertial) -> None:
    """The inertial element as its writer has it."""
    parent.append(ET.fromstring(writer(inertial)))  # noqa: S314  our own text


def document(root: Element) -> bytes:
    """The file."""
    ET.indent(root)
    return bytes(ET.tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"


def position(placement: Array) -> str:
    """Where a placement (4, 4) puts the origin."""
    return numbers(placement[:3, 3])


def fixed_angles(placement: Array) -> str:
    """Its turns about the fixed axes x, y and z, in this order, radians."""
    return numbers(roll_pitch_yaw(placement[:3, :3]))


def quaternion(placement: Array) -> str:
    """Its turn as w, x, y, z."""
    return numbers(quaternion_of(placement[:3, :3]))

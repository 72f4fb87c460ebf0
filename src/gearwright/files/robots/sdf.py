"""SDFormat 1.11: a model of links and joints; the axis of the second joint mimics that of the first.

Source: the specification of SDFormat 1.11, the first with <mimic>.
"""

from __future__ import annotations

from pathlib import Path

from .. import inertial
from ..inertial import number, numbers
from .mechanism import Joint, Link, Mechanism
from .saving import save, uri
from .xml import Element, add, add_inertial, document, fixed_angles, position

VERSION = "1.11"


def write(path: str | Path, mechanism: Mechanism) -> list[Path]:
    """Writes the file and the meshes beside it, all or none, and gives their paths. Raises FileError, MachineError."""
    root = Element("sdf", version=VERSION)
    model = add(root, "model", {"name": mechanism.name})
    for link in mechanism.links:
        _add_link(model, mechanism, link)
    for joint in mechanism.joints:
        _add_joint(model, mechanism, joint)
    return save(path, mechanism, document(root))


def _add_link(model: Element, mechanism: Mechanism, link: Link) -> None:
    body = add(model, "link", {"name": link.name})
    add(body, "pose", text=f"{position(link.placement)} {fixed_angles(link.placement)}")
    add_inertial(body, inertial.sdf, link.inertial)
    for name in ("visual", "collision"):
        shown = add(body, name, {"name": f"{link.name}_{name}"})
        add(add(add(shown, "geometry"), "mesh"), "uri", text=uri(mechanism, link))
        if name == "visual" and link.colour is not None:
            material = add(shown, "material")
            for light in ("ambient", "diffuse"):
                add(material, light, text=numbers((*link.colour, 1.0)))


def _add_joint(model: Element, mechanism: Mechanism, joint: Joint) -> None:
    """Its frame is the link's, where nothing is said."""
    element = add(model, "joint", {"name": joint.name, "type": joint.kind})
    add(element, "parent", text="world")
    add(element, "child", text=joint.link)
    axis = add(element, "axis")
    add(axis, "xyz", text=numbers(joint.axis))
    if joint.range is not None:
        limit = add(axis, "limit")
        for name, value in zip(("lower", "upper"), joint.range, strict=True):
            add(limit, name, text=number(value))
    if joint.ratio is not None:
        mimic = add(axis, "mimic", {"joint": mechanism.joints[0].name})
        for name, value in (("multiplier", joint.ratio), ("offset", 0.0), ("reference", 0.0)):
            add(mimic, name, text=number(value))

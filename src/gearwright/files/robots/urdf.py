"""URDF: links and joints in a tree whose root is the world; the second joint mimics the first.

Source: the XML specification of URDF for ROS; the element <mujoco>, which others pass over, is MuJoCo's extension.
"""

from __future__ import annotations

from pathlib import Path

from .. import inertial
from ..inertial import number, numbers
from .mechanism import Joint, Link, Mechanism
from .saving import save, uri
from .xml import Element, add, add_inertial, document, fixed_angles, position

WORLD = "world"
"""The root link: simulators hold one of this name fixed."""

_UNLIMITED = 1e9
"""Force (N) and speed (m/s) of a sliding joint, which must be stated and are not known here."""

_FOR_MUJOCO = {
    "strippath": "false",  # meshes lie in a folder, whose name must stay
    "fusestatic": "false",  # else a part without a joint becomes a part of the world, and loses its mass
    "inertiafromgeom": "auto",  # what is stated is taken
    "balanceinertia": "false",
}


def write(path: str | Path, mechanism: Mechanism) -> list[Path]:
    """Writes the file and the meshes beside it, all or none, and gives their paths. Raises FileError, MachineError."""
    return save(path, mechanism, document(_robot(mechanism)))


def _robot(mechanism: Mechanism) -> Element:
    robot = Element("robot", name=mechanism.name)
    extension = add(robot, "mujoco")
    add(extension, "compiler", _FOR_MUJOCO)
    if mechanism.joints:
        # teeth mesh, their convex hulls overlap, and this format cannot exempt two links from contact
        add(add(extension, "option"), "flag", {"contact": "disable"})
        add(robot, "link", {"name": WORLD})
    for link in mechanism.links:
        _add_link(robot, mechanism, link)
    for joint in mechanism.joints:
        _add_joint(robot, mechanism, joint)
    return robot


def _add_link(robot: Element, mechanism: Mechanism, link: Link) -> None:
    body = add(robot, "link", {"name": link.name})
    add_inertial(body, inertial.urdf, link.inertial)
    for name in ("visual", "collision"):
        shown = add(body, name)
        add(add(shown, "geometry"), "mesh", {"filename": uri(mechanism, link)})
        if name == "visual" and link.colour is not None:
            add(add(shown, "material", {"name": link.name}), "color", {"rgba": numbers((*link.colour, 1.0))})


def _add_joint(robot: Element, mechanism: Mechanism, joint: Joint) -> None:
    (link,) = (one for one in mechanism.links if one.name == joint.link)
    element = add(robot, "joint", {"name": joint.name, "type": joint.kind})
    add(element, "parent", {"link": WORLD})
    add(element, "child", {"link": link.name})
    add(element, "origin", {"xyz": position(link.placement), "rpy": fixed_angles(link.placement)})
    add(element, "axis", {"xyz": numbers(joint.axis)})
    if joint.range is not None:
        lower, upper = map(number, joint.range)
        limits = {"lower": lower, "upper": upper, "effort": number(_UNLIMITED), "velocity": number(_UNLIMITED)}
        add(element, "limit", limits)
    if joint.ratio is not None:
        add(element, "mimic", {"joint": mechanism.joints[0].name, "multiplier": number(joint.ratio), "offset": "0.0"})

"""MJCF, MuJoCo's own format: bodies on joints, the ratio as an equality constraint.

Source: the XML reference of MuJoCo; its limits are those of version 4.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ...errors import FileError
from .. import inertial
from ..inertial import numbers
from .mechanism import Joint, Link, Mechanism
from .saving import folder_of, mesh_file, save
from .xml import Element, add, add_inertial, document, position, quaternion

MOST_TRIANGLES = 200_000
"""Of a mesh in an STL file."""

LEAST_MASS, LEAST_MOMENT = 1e-15, 1e-14
"""Mass (kg) and principal moments (kg m²) of a body must be larger."""

VISUAL, COLLISION = "2", "3"
"""Groups of geoms that programs show, and hide until they are asked for."""

_COMPILER = {
    "angle": "radian",
    "inertiafromgeom": "auto",  # what is stated is taken; bodies that a user adds may state nothing
    "balanceinertia": "false",
    "discardvisual": "false",
}
_KINDS = {"continuous": "hinge", "prismatic": "slide"}

_STIFF = {"solref": "0.004 1", "solimp": "0.9999 0.9999 0.001 0.5 2"}
"""As stiff as a constraint stays sound at the default step of 0.002 s: no time constant below two steps, and the
largest share of the unconstrained acceleration taken away that MuJoCo allows."""

_STIFF_END = {f"{name}limit": value for name, value in _STIFF.items()}


def write(path: str | Path, mechanism: Mechanism) -> list[Path]:
    """Writes the file and the meshes beside it, all or none, and gives their paths.

    Raises FileError, also where MuJoCo's limits would not let it load the file; MachineError.
    """
    problems = [problem for link in mechanism.links for problem in _beyond(link)]
    if problems:
        raise FileError("\n".join([f"{path}: MuJoCo could not load it:", *(f"  {one}" for one in problems)]))
    return save(path, mechanism, document(_model(mechanism)))


def _beyond(link: Link) -> list[str]:
    """What of a link is beyond the limits."""
    found = []
    triangles = len(link.shape.simple_triangles())
    if triangles > MOST_TRIANGLES:
        found.append(f"{link.name}: {triangles} triangles, at most {MOST_TRIANGLES} are taken; use a coarser tolerance")
    mass, least = link.inertial.mass, float(np.linalg.eigvalsh(link.inertial.inertia)[0])
    if not (mass > LEAST_MASS and least > LEAST_MOMENT):
        found.append(
            f"{link.name}: mass {mass:.3g} kg, principal moments down to {least:.3g} kg m²; more than"
            f" {LEAST_MASS:g} kg and {LEAST_MOMENT:g} kg m² are taken: check density and length unit"
        )
    return found


def _model(mechanism: Mechanism) -> Element:
    root = Element("mujoco", model=mechanism.name)
    add(root, "compiler", {**_COMPILER, "meshdir": folder_of(mechanism)})
    asset, world = add(root, "asset"), add(root, "worldbody")
    for link in mechanism.links:
        add(asset, "mesh", {"name": link.name, "file": mesh_file(link)})
        _add_body(world, link, mechanism.joint_of(link))
    if mechanism.followers:
        _add_ratios(root, mechanism)
    return root


def _add_body(world: Element, link: Link, joint: Joint | None) -> None:
    place = {"pos": position(link.placement), "quat": quaternion(link.placement)}
    body = add(world, "body", {"name": link.name, **place})
    add_inertial(body, inertial.mjcf, link.inertial)
    if joint is None:
        add(body, "freejoint")
    else:
        limits = {} if joint.range is None else {"range": numbers(joint.range), **_STIFF_END}
        attributes = {"name": joint.name, "type": _KINDS[joint.kind], "axis": numbers(joint.axis), **limits}
        add(body, "joint", attributes)
    mesh = {"type": "mesh", "mesh": link.name}
    if link.colour is not None:
        mesh["rgba"] = numbers((*link.colour, 1.0))
    add(body, "geom", {**mesh, "group": VISUAL, "contype": "0", "conaffinity": "0"})
    add(body, "geom", {**mesh, "group": COLLISION})


def _add_ratios(root: Element, mechanism: Mechanism) -> None:
    """Ratios by constraints, which carry the load; so the convex hulls, which overlap, are exempt from contact.

    MuJoCo softens a constraint by the inverse inertias of both joints, without their ratio; it stays stiff where the
    joint that goes farther is given by the other.
    """
    contact, equality = add(root, "contact"), add(root, "equality")
    (first, *_) = mechanism.joints
    for joint in mechanism.followers:
        add(contact, "exclude", {"body1": first.link, "body2": joint.link})
        ratio, given, by = joint.ratio or 1.0, joint, first
        if abs(ratio) < 1.0:
            ratio, given, by = 1.0 / ratio, first, joint
        coefficients = numbers((0.0, ratio, 0.0, 0.0, 0.0))
        add(equality, "joint", {"joint1": given.name, "joint2": by.name, "polycoef": coefficients, **_STIFF})

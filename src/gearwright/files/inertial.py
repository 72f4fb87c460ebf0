"""Inertial elements of robot descriptions: URDF, SDFormat and MuJoCo's MJCF.

All are in kg, m and kg m²; the tensor is about the centre of mass, its off-diagonals are its true components, minus
the products: ixy = −∫xy dm. URDF and SDFormat place the axes of the tensor by turns about the fixed axes x, y and z,
in this order; MJCF gives either the tensor along the body's own axes or principal moments with a quaternion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..rotations import quaternion_of, roll_pitch_yaw

Writer = Callable[["Inertial"], str]

_DIAGONAL = 1e-15
"""Products up to this share of the largest moment are rounding where a tensor is along its principal axes."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Inertial:
    """What such an element says of one body.

    name      for a comment
    mass      kg
    centroid  (3,) m, in the body's frame
    axes      (3, 3) axes of the tensor as columns, in the body's frame; the identity for this frame's own
    inertia   (3, 3) kg m² about the centroid, along those axes
    """

    name: str
    mass: float
    centroid: Array
    axes: Array
    inertia: Array


def urdf(body: Inertial) -> str:
    """An <inertial> element of URDF, after a comment with the body's name."""
    moments = " ".join(f'{name}="{value}"' for name, value in _components(body).items())
    lines = (
        "<inertial>",
        f'  <origin xyz="{numbers(body.centroid)}" rpy="{numbers(roll_pitch_yaw(body.axes))}"/>',
        f'  <mass value="{number(body.mass)}"/>',
        f"  <inertia {moments}/>",
        "</inertial>",
    )
    return _element(body, lines)


def sdf(body: Inertial) -> str:
    """An <inertial> element of SDFormat, after a comment with the body's name."""
    lines = (
        "<inertial>",
        f"  <pose>{numbers([*body.centroid, *roll_pitch_yaw(body.axes)])}</pose>",
        f"  <mass>{number(body.mass)}</mass>",
        "  <inertia>",
        *(f"    <{name}>{value}</{name}>" for name, value in _components(body).items()),
        "  </inertia>",
        "</inertial>",
    )
    return _element(body, lines)


def mjcf(body: Inertial) -> str:
    """An <inertial> element of MJCF, after a comment with the body's name.

    Along the body's own axes with fullinertia (Ixx Iyy Izz Ixy Ixz Iyz), along others, which must be principal, with
    diaginertia and quat. Raises ValueError where they are neither: the format has no words for it.
    """
    place = f'pos="{numbers(body.centroid)}" mass="{number(body.mass)}"'
    if np.array_equal(body.axes, np.eye(3)):
        full = " ".join(_components(body)[name] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
        return _element(body, (f'<inertial {place} fullinertia="{full}"/>',))
    if not is_diagonal(body.inertia):
        raise ValueError("MJCF has no words for a full tensor along turned axes")
    turned = f'quat="{numbers(quaternion_of(body.axes))}" diaginertia="{numbers(np.diag(body.inertia))}"'
    return _element(body, (f"<inertial {place} {turned}/>",))


WRITERS: dict[str, Writer] = {"urdf": urdf, "sdf": sdf, "mjcf": mjcf}
"""What writes each kind of element."""


def is_diagonal(inertia: Array) -> bool:
    """Whether a tensor (3, 3) holds products no larger than rounding."""
    return float(np.abs(inertia - np.diag(np.diag(inertia))).max()) <= _DIAGONAL * float(np.abs(inertia).max())


def _components(body: Inertial) -> dict[str, str]:
    return {f"i{'xyz'[i]}{'xyz'[j]}": number(body.inertia[i, j]) for i in range(3) for j in range(i, 3)}


def _element(body: Inertial, lines: Iterable[str]) -> str:
    """The lines after a comment that XML takes: without two hyphens in a row and characters it does not know."""
    name = "".join(one if one.isprintable() else " " for one in body.name)
    while "--" in name:
        name = name.replace("--", "- -")
    return "\n".join((f"<!-- {name} -->", *lines)) + "\n"


def numbers(values: Iterable[float] | Array) -> str:
    """Numbers with all their digits, a space between two."""
    return " ".join(number(value) for value in values)


def number(value: float) -> str:
    """All digits of a number, as few as give it again."""
    return repr(float(value) + 0.0)

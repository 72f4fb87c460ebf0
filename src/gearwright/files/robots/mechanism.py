"""Bodies on joints: what files for simulators hold. Everything is in SI: m, kg, kg m², radians."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ...arrays import Array
from ...colours import Colour
from ..assembly import Faceted
from ..inertial import Inertial

JointKind = Literal["continuous", "prismatic"]
"""Turning without end, or sliding."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Link:
    """A rigid body in its own frame.

    shape       its faces, coordinates in m
    placement   (4, 4) rigid motion that puts it in its place where its joint is at 0
    """

    name: str
    inertial: Inertial
    shape: Faceted
    placement: Array
    colour: Colour | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Joint:
    """What a link can do against the world.

    link    the name of the link; the axis goes through the origin of its frame
    axis    (3,) unit vector in the link's frame
    ratio   the joint's value (radians, m) by that of the first joint of its mechanism; None of a free one
    range   of its value; None without end
    """

    name: str
    link: str
    kind: JointKind
    axis: Array
    ratio: float | None = None
    range: tuple[float, float] | None = None

    def motion(self, value: float) -> Array:
        """What (4, 4) the joint's value does to the link, in the link's frame (Rodrigues' formula where it turns)."""
        moved = np.eye(4)
        if self.kind == "prismatic":
            moved[:3, 3] = value * self.axis
            return moved
        x, y, z = self.axis
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        moved[:3, :3] += np.sin(value) * cross + (1.0 - np.cos(value)) * cross @ cross
        return moved


@dataclass(frozen=True, kw_only=True, eq=False)
class Mechanism:
    """Links by names of their own, at least one; a link without a joint is free. Joints follow the first one."""

    name: str
    links: tuple[Link, ...]
    joints: tuple[Joint, ...] = ()

    def joint_of(self, link: Link) -> Joint | None:
        """The joint that a link hangs on."""
        return next((joint for joint in self.joints if joint.link == link.name), None)

    @property
    def followers(self) -> tuple[Joint, ...]:
        """The joints whose values follow from the first one's."""
        return tuple(joint for joint in self.joints if joint.ratio is not None)

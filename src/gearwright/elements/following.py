"""How the gear of a pair follows its pinion, and parts as bodies on joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError, Problem
from ..files.robots.mechanism import Joint, JointKind, Mechanism
from ..parameters import LENGTH_UNITS
from ..solids.robots import mechanism_of
from .assembly import PlacedPart, in_colours


@dataclass(frozen=True, kw_only=True)
class Following:
    """How a gear moves when the pinion turns about its own +z.

    kind    whether it turns or slides
    axis    about or along which unit vector, in its own frame, through its origin
    ratio   by how many radians, or lengths, for each radian of the pinion
    range   lengths between which it can slide; None without end
    """

    kind: JointKind = "continuous"
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    ratio: float
    range: tuple[float, float] | None = None


def part_mechanism(
    name: str,
    parts: Sequence[PlacedPart],
    density: str | float,
    length_unit: str,
    following: Following | None = None,
    turn: float = 0.0,
) -> Mechanism:
    """Parts as bodies: a single one free, two on joints. Arguments and errors as those of `Pair.mechanism`."""
    joints = () if following is None else _joints(parts, following, length_unit, float(np.radians(turn)))
    return mechanism_of(name, in_colours(parts), density, length_unit, joints)


def _joints(parts: Sequence[PlacedPart], following: Following, length_unit: str, turn: float) -> tuple[Joint, Joint]:
    """The pinion's and the gear's, at 0 where the pinion is turned so far (radians)."""
    pinion, gear = (part.name for part in parts)
    metres = LENGTH_UNITS[length_unit] / 1e3 if following.kind == "prismatic" else 1.0
    leader = Joint(name=f"{pinion}_joint", link=pinion, kind="continuous", axis=np.array([0.0, 0.0, 1.0]))
    least, most = ((end - following.ratio * turn) * metres for end in following.range or (-np.inf, np.inf))
    if not least <= 0.0 <= most:
        reach = [np.degrees(end / following.ratio) for end in following.range or ()]
        wanted = (
            f"the {gear} meshes from {min(reach):.6g} to {max(reach):.6g} degrees; the joints must start in between"
        )
        raise ParameterError("This mechanism", [Problem(f"turn = {np.degrees(turn):.6g}", wanted)])
    follower = Joint(
        name=f"{gear}_joint",
        link=gear,
        kind=following.kind,
        axis=np.array(following.axis),
        ratio=following.ratio * metres,
        range=None if following.range is None else (least, most),
    )
    return leader, follower

"""What a sizing system settles of one bevel gear: heights, their angles, and the thickness of its teeth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

DepthTaper = Literal["standard", "uniform", "duplex", "tilted"]
"""How the depth of teeth changes along the face (ISO 23509, depthwise taper).

standard   in proportion to the cone distance: the apexes of the root cones are the pitch apex
uniform    not at all: tip and root cones are parallel to the pitch cone, as face hobbing cuts them
duplex     so that the root lines leave slots of one width, which one cutter of two sides cuts at once
tilted     as duplex, but not beyond 1.3 times the standard taper ("modified slot width")
"""


@dataclass(frozen=True, kw_only=True)
class Proportions:
    """One member's teeth at their outer end. Lengths in the length unit; angles in radians.

    addendum, dedendum   h_ae, h_fe, along the back cone from the pitch cone
    addendum_angle       θ_a, by which the tip cone is steeper than the pitch cone
    dedendum_angle       θ_f, by which the root cone is flatter
    thickness            s_e, transverse circular thickness on the outer pitch circle, without backlash
    """

    addendum: float
    dedendum: float
    addendum_angle: float
    dedendum_angle: float
    thickness: float

    @property
    def depth(self) -> float:
        """h_e, whole depth at the outer end."""
        return self.addendum + self.dedendum


Pair = tuple[Proportions, Proportions]
"""Proportions of the first and the second member."""

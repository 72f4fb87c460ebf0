"""Basic racks: the proportions of teeth, in modules of the normal section."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class BasicRack:
    """Heights above and below the datum line, and the radius at the root, in modules.

    addendum     h_aP*
    dedendum     h_fP*
    tip_radius   ρ_fP* at the root of the rack, which is at the tip of the tool that generates with it
    """

    addendum: float
    dedendum: float
    tip_radius: float


BASIC_RACKS = {
    "iso-53-a": BasicRack(1.0, 1.25, 0.38),
    "iso-53-b": BasicRack(1.0, 1.25, 0.30),
    "iso-53-c": BasicRack(1.0, 1.25, 0.25),
    "iso-53-d": BasicRack(1.0, 1.40, 0.39),
    "agma-full-radius": BasicRack(1.0, 1.35, 1.0),
}
"""ISO 53:1998, table 1, for 20°: A for high torque, B and C for usual service, D for gears that are ground after
hobbing. The full-radius rack of American practice for finished teeth (1.35/P_d deep) has tips round all over: its
radius is more than fits, and what fits is taken.
"""

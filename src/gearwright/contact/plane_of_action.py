"""Lines along which the flanks of a pair on parallel axes touch: straight, in the plane that touches both base circles.

At ρ₁ from where the line of action touches the pinion's base circle, the pinion's leading flank touches when

    ρ₁ = r_b1 (θ + ψ_b + α_wt),

θ being the polar angle of its tooth's centre, from the line between the axes, and ψ_b half of its thickness on the base
circle; along the face θ turns with the helix. Source: the involute as a string unwound, ISO 21771:2007, 4.3 and 7.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..elements.cylindrical.gear_pair import GearPair


def lines_of_action(pair: GearPair, turn: float = 0.0) -> list[Array]:
    """The lines (2, 3), from end to end, along which flanks touch with the pinion turned by so many degrees.

    Of the flanks that drive when it turns on so, as involutes: crowning and relief are left out. In the frame of the
    pair: pinion axis +z, gear axis on +x, of an internal pair on −x.
    """
    mesh, base_radius = pair.mesh, pair.mesh.pinion.toothing.base_radius
    angle = mesh.working_pressure_angle
    pitch = 2.0 * np.pi / mesh.pinion.toothing.teeth
    first, last = (string / base_radius for string in mesh.path)
    heights = np.linspace(0.0, pair.pinion.face_width, 3)  # a herringbone turns back in the middle
    rolls = mesh.pinion.toothing.thickness_at(base_radius) / 2.0 + angle + np.radians(turn) + _turned(pair, heights)
    teeth = np.arange(np.ceil((first - rolls.max()) / pitch), np.floor((last - rolls.min()) / pitch) + 1.0)
    foot = base_radius * np.array([np.cos(angle), -np.sin(angle), 0.0])
    along = base_radius * np.array([np.sin(angle), np.cos(angle), 0.0])
    return [
        foot + roll[:, None] * along + height[:, None] * np.array([0.0, 0.0, 1.0])
        for tooth in teeth
        for k in (0, 1)
        for height, roll in _between(heights[k : k + 2], rolls[k : k + 2] + tooth * pitch, first, last)
    ]


def lines_over_a_pitch(pair: GearPair, steps: int = 96) -> tuple[list[list[Array]], float]:
    """The lines at so many turns over one pitch of the pinion, and that pitch in degrees."""
    pitch = 360.0 / pair.mesh.pinion.toothing.teeth
    return [lines_of_action(pair, pitch * k / steps) for k in range(steps)], pitch


def _turned(pair: GearPair, heights: Array) -> Array:
    """By how much (n,) the pinion's section is turned at heights (n,) above its first end."""
    points = pair.pinion.motion.place(np.broadcast_to([1.0, 0.0], (len(heights), 2)), heights)
    return np.unwrap(np.arctan2(points[:, 1], points[:, 0]))


def _between(height: Array, roll: Array, least: float, most: float) -> list[tuple[Array, Array]]:
    """The part of a straight line, by its ends' heights (2,) and rolls (2,), whose rolls are between two limits."""
    if roll[0] == roll[1]:
        return [(height, roll)] if least <= roll[0] <= most else []
    ends = np.sort((np.array([least, most]) - roll[0]) / (roll[1] - roll[0]))
    start, end = max(0.0, ends[0]), min(1.0, ends[1])
    share = np.array([start, end])
    return [(height[0] + share * np.ptp(height), roll[0] + share * (roll[1] - roll[0]))] if start < end else []

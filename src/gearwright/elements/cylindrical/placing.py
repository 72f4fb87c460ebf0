"""Where the members of a pair on parallel axes stand."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ..following import Following


def gears_in_mesh(teeth: tuple[int, int], distance: float, turn: float, *, internal: bool) -> tuple[Array, Array]:
    """Rigid motions (4, 4) of pinion and gear into mesh, the pinion turned by an angle (radians).

    At turn 0 the pinion's first tooth points at +x, where the gear has the middle of a space. The gear's axis is at
    +x, an internal gear's at −x.
    """
    ratio = teeth[0] / teeth[1]
    if internal:
        return _placed(turn, 0.0), _placed(np.pi / teeth[1] + turn * ratio, -distance)
    return _placed(turn, 0.0), _placed(np.pi + np.pi / teeth[1] - turn * ratio, distance)


def pinion_on_rack(
    pitch_radius: float, distance: float, rack_teeth: int, circular_pitch: float, turn: float
) -> tuple[Array, Array]:
    """Rigid motions (4, 4) of pinion and rack into mesh, the pinion turned by an angle (radians).

    The rack's pitch plane is at x = distance, its teeth towards the axis; at turn 0 the pinion's first tooth stands
    in a space in the middle of the rack, which moves along +y when the pinion turns.
    """
    middle = (rack_teeth // 2 - 0.5) * circular_pitch
    return _placed(turn, 0.0), _placed(np.pi, distance, middle + pitch_radius * turn)


def rack_following(pitch_radius: float, rack_teeth: int, circular_pitch: float) -> Following:
    """How the rack of `pinion_on_rack` follows: along its own −y, while the pitch point is on its teeth."""
    behind = rack_teeth // 2
    ends = (-behind * circular_pitch, (rack_teeth - behind) * circular_pitch)
    return Following(kind="prismatic", axis=(0.0, -1.0, 0.0), ratio=pitch_radius, range=ends)


def _placed(angle: float, x: float, y: float = 0.0) -> Array:
    """The turn (4, 4) about +z by an angle, then a shift."""
    c, s = np.cos(angle), np.sin(angle)
    matrix = np.eye(4)
    matrix[:2, :2] = [[c, -s], [s, c]]
    matrix[:2, 3] = x, y
    return matrix

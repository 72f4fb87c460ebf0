"""Two bevel gears in engagement on the sphere: line of action, contact ratio, limits of interference, placement.

The line of action is the common tangent great circle of the base cones; along it each member unwinds the
angle α = acos(cos δ/cos γ_b) of its own involute. Source: theory of the spherical involute, Al-Daccak 1989,
ch. 3; contact ratio and limits as for parallel axes, ISO 21771, with great circles for lines.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...curves.spherical_involute import roll_at_polar_angle
from .tooth import BevelTooth


def unwound(tooth: BevelTooth, polar: float) -> float:
    """α, the angle unwound along the great circle where the tooth's involute has a polar angle."""
    return float(roll_at_polar_angle(polar, tooth.base_cone_angle) * np.sin(tooth.base_cone_angle))


def contact_ratio(pinion: BevelTooth, gear: BevelTooth) -> float:
    """Transverse contact ratio ε = Σ (α_a − α_p)/(2π sin γ_b/z), while the involutes last."""
    path = sum(unwound(tooth, tooth.face_angle) - unwound(tooth, tooth.pitch_angle) for tooth in (pinion, gear))
    return float(path / (2.0 * np.pi * np.sin(pinion.base_cone_angle) / pinion.teeth))


def interference_limit(tooth: BevelTooth, mate: BevelTooth) -> float:
    """Largest face angle of a tooth whose tip still meets its mate's involute above the base cone, radians.

    cos δ_a ≥ cos γ_b cos(α_p + α_p′), both unwound angles taken at the pitch cones.
    """
    whole = unwound(tooth, tooth.pitch_angle) + unwound(mate, mate.pitch_angle)
    return float(np.arccos(np.cos(tooth.base_cone_angle) * np.cos(whole)))


def meshing_placements(shaft_angle: float, pinion_teeth: int, gear_teeth: int, turn: float) -> tuple[Array, Array]:
    """Rigid motions (4, 4) of pinion and gear into mesh, the pinion turned by an angle from tooth on pitch line.

    Common apex at the origin, pinion axis +z, gear axis at the shaft angle towards +x. At turn 0 the
    pinion's first tooth and the middle of a space of the gear face each other on the pitch line.
    """
    c, s = np.cos(shaft_angle), np.sin(shaft_angle)
    seat = np.array([[-c, 0.0, s], [0.0, -1.0, 0.0], [s, 0.0, c]])  # columns: gear x, y, z
    gear_turn = np.pi / gear_teeth - turn * pinion_teeth / gear_teeth
    return _placement(np.eye(3), turn), _placement(seat, gear_turn)


def _placement(seat: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    matrix = np.eye(4)
    matrix[:3, :3] = seat @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return matrix

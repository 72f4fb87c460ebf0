"""Two bevel gears in engagement on the sphere: path of contact, contact ratio, limits of interference, placement.

Both flanks are those that one crown gear leaves, on its two sides; its turn u from contact at the pitch point tells
the contact: the flank's own parameter on one member, its negative on the other, whatever the form. For involutes
the path is the common tangent great circle of the base cones and u = (α − α_p)/cos a, α being unwound along it.
Source: theory of the spherical involute, Al-Daccak 1989, ch. 3; contact ratio and limits as for parallel axes,
ISO 21771, with great circles for lines.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...curves.traces.trace import Trace
from .tooth import BevelTooth


def contact_ratio(pinion: BevelTooth, gear: BevelTooth) -> float:
    """Transverse contact ratio ε = Σ u/(2π sin γ/z) to where contact ends; the same z/sin γ for both.

    On either side of the pitch point it ends at the one's tip, or where the other's flank proper begins: above its
    fillet, which undercut may have raised.
    """
    ways = ((pinion, gear), (gear, pinion))
    path = sum(
        min(float(one.flank.parameter_at(one.face_angle)), -float(other.flank.parameter_at(other.form_angle)))
        for one, other in ways
    )
    return float(max(path, 0.0) / (2.0 * np.pi * np.sin(pinion.pitch_angle) / pinion.teeth))


def overlap_ratio(trace: Trace, inner: float, outer: float, teeth: int) -> float:
    """ε_β = z |w(R_e) − w(R_i)|/2π: by how many pitches the two ends of a tooth are turned against each other."""
    return float(teeth * abs(trace.turn(outer) - trace.turn(inner)) / (2.0 * np.pi))


def interference_limit(tooth: BevelTooth, mate: BevelTooth) -> float:
    """Largest face angle of a tooth whose tip still meets its mate's form above its inner end, radians.

    For involutes cos δ_a ≥ cos γ_b cos(α_p + α_p′), both unwound angles taken at the pitch cones.
    """
    return tooth.flank.polar_at(min(-mate.flank.least_turn, tooth.flank.greatest_turn))


def fillet_limit(tooth: BevelTooth, mate: BevelTooth) -> float:
    """Largest face angle of a tooth whose tip still meets its mate's flank proper, above its fillet, radians."""
    first = float(mate.flank.parameter_at(mate.form_angle))
    return tooth.flank.polar_at(min(-first, tooth.flank.greatest_turn))


def meshing_placements(shaft_angle: float, pinion_teeth: int, gear_teeth: int, turn: float) -> tuple[Array, Array]:
    """Rigid motions (4, 4) of pinion and gear into mesh, the pinion turned by an angle from tooth on pitch line.

    Common apex at the origin, pinion axis +z, gear axis at the shaft angle towards +x. At turn 0 the
    pinion's first tooth and the middle of a space of the gear face each other on the pitch line.
    """
    gear_turn = np.pi / gear_teeth - turn * pinion_teeth / gear_teeth
    return _placement(np.eye(3), turn), _placement(seat(shaft_angle), gear_turn)


def seat(shaft_angle: float) -> Array:
    """Axes (3, 3) of the gear as columns x, y, z: its axis at the shaft angle towards +x, its x towards the pinion."""
    c, s = np.cos(shaft_angle), np.sin(shaft_angle)
    return np.array([[-c, 0.0, s], [0.0, -1.0, 0.0], [s, 0.0, c]])


def _placement(axes: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    matrix = np.eye(4)
    matrix[:3, :3] = axes @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return matrix

"""The octoid, the flank of a bevel gear whose crown gear has plane flanks.

The crown gear's flank is a great circle inclined by the pressure angle a. It touches the gear's where the plane
through the pitch point and the flank's normal cuts it; as the crown gear turns by u, the contact draws an eight, hence
the name. With sin η = cos a sin u, the contact is at the distance −η from the pitch point, in the bearing
t = atan2(sin a, cos a cos u). The curve's polar angle follows from

    cos δ = cos γ cos η − sin a sin γ tan η

and falls with u down to a cusp, sin η (1 − sin²η) = −sin a tan γ, or, where that has no root, to u = −π/2,
where the crown gear's great circle is furthest from its pitch plane.
Source: Litvin & Fuentes 2004, Gear Geometry and Applied Theory, ch. 21; the contact by the theory of gearing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .rolled import RolledCurve

_MOST_STEPS = 100
_DIGITS = 4.0 * np.finfo(float).eps


@dataclass(frozen=True, kw_only=True)
class Octoid(RolledCurve):
    """The octoid of a pitch cone γ and a pressure angle a; u is the turn of the crown gear, 0 at the pitch cone.

    pressure_angle   a, between the crown gear's flank and its axis, radians, 0 < a < π/2

    It grows in polar angle from `least_turn` to π/2. Raises ValueError if the angles are none of a gear.
    """

    pressure_angle: float

    def __post_init__(self) -> None:
        _require_angles(self.pitch_angle, self.pressure_angle)

    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn = np.asarray(u, float)
        s, c = np.sin(self.pressure_angle), np.cos(self.pressure_angle)
        return turn, np.arctan2(s, c * np.cos(turn)), -np.arcsin(c * np.sin(turn))

    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        turn = np.asarray(u, float)
        s, c = np.sin(self.pressure_angle), np.cos(self.pressure_angle)
        squared = s * s + (c * np.cos(turn)) ** 2  # cos²η
        return np.ones_like(turn), s * c * np.sin(turn) / squared, -c * np.cos(turn) / np.sqrt(squared)


def least_turn(pitch_angle: float, pressure_angle: float) -> float:
    """Turn u < 0 of the crown gear at the inner end of the octoid: its cusp, or −π/2, radians.

    With x = −sin η the cusp is at x (1 − x²) = sin a tan γ, solved by the sine of the threefold angle.
    """
    _require_angles(pitch_angle, pressure_angle)
    s, c = np.sin(pressure_angle), np.cos(pressure_angle)
    sine = 1.5 * np.sqrt(3.0) * s * np.tan(pitch_angle)
    if pitch_angle >= np.pi / 2.0 or sine > 1.0:
        return -np.pi / 2.0
    root = 2.0 / np.sqrt(3.0) * np.sin(np.arcsin(sine) / 3.0)
    return float(-np.arcsin(root / c)) if root < c else -np.pi / 2.0


def turn_at_polar_angle(polar_angle: ArrayLike, pitch_angle: float, pressure_angle: float) -> Array:
    """Turn u (...) of the crown gear at which the octoid reaches polar angle δ (...), radians.

    Newton's method kept in a bracket, on 2 cos γ sin²(η/2) + sin a sin γ tan η = cos γ − cos δ, of which
    nothing cancels on slender cones. Raises ValueError where the curve does not reach.
    """
    first = least_turn(pitch_angle, pressure_angle)
    s, c = np.sin(pressure_angle), np.cos(pressure_angle)
    delta = np.asarray(polar_angle, float)
    ends = Octoid(pitch_angle=pitch_angle, pressure_angle=pressure_angle, interval=(first, np.pi / 2.0))
    least, greatest = ends.polar_angle(np.array(ends.interval))
    if not np.all((delta >= least * (1.0 - _DIGITS)) & (delta <= greatest * (1.0 + _DIGITS))):
        raise ValueError(
            f"this octoid lies between polar angles {np.degrees(least):.6g}° and {np.degrees(greatest):.6g}°"
        )
    target = 2.0 * np.sin((delta + pitch_angle) / 2.0) * np.sin((delta - pitch_angle) / 2.0)
    flat, steep = 2.0 * np.cos(pitch_angle), s * np.sin(pitch_angle)
    low = np.full(delta.shape, float(np.arcsin(c * np.sin(first))))
    high = np.full(delta.shape, float(np.arcsin(c)))
    eta = np.clip(target / steep, low, high)
    for _ in range(_MOST_STEPS):
        excess = flat * np.sin(eta / 2.0) ** 2 + steep * np.tan(eta) - target
        low, high = np.where(excess <= 0.0, eta, low), np.where(excess >= 0.0, eta, high)
        slope = flat / 2.0 * np.sin(eta) + steep / np.cos(eta) ** 2
        newton = eta - excess / np.where(slope > 0.0, slope, 1.0)
        following = np.where((newton > low) & (newton < high), newton, (low + high) / 2.0)
        following = np.where(excess == 0.0, eta, following)
        settled = np.abs(following - eta) <= np.finfo(float).eps * np.abs(eta)
        eta = following
        if np.all(settled):
            break
    turn = np.arcsin(np.clip(np.sin(eta) / c, -1.0, 1.0))
    return np.where(delta <= least, first, turn)


def _require_angles(pitch_angle: float, pressure_angle: float) -> None:
    if not (0.0 < pitch_angle <= np.pi / 2.0 * (1.0 + _DIGITS) and 0.0 < pressure_angle < np.pi / 2.0):
        raise ValueError(
            "an octoid has a pitch cone of up to 90° and a pressure angle between 0 and 90°, not "
            f"{np.degrees(pitch_angle):.6g}° and {np.degrees(pressure_angle):.6g}°"
        )

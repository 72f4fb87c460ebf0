"""Measurement over two pins or balls, or between them in an internal gear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...curves.involute import inverse_involute_function, involute_function
from ..cylindrical.toothing import Toothing

USUAL = {False: 1.728, True: 1.68}
"""Pin diameters in modules, for external and for internal gears (ANSI practice)."""


@dataclass(frozen=True, kw_only=True)
class OverPins:
    """Two pins in the spaces farthest apart. Lengths; angles in radians.

    pressure_angle   φ at the pins' centres, transverse
    centre_radius    of the pins' centres from the axis
    contact_radius   where a pin touches the flanks
    measurement      M, over the pins of an external gear, between those of an internal one
    """

    pressure_angle: float
    centre_radius: float
    contact_radius: float
    measurement: float


def over_pins(toothing: Toothing, pin_diameter: float) -> OverPins | None:
    """The measurement with pins or, on helical teeth, balls of a diameter D; None where they touch no involute.

    inv φ = inv α_t ± (D/(d_b cos β_b) − η), η half the angle of a space on the pitch circle, + for external gears;
    M = d_b/cos φ · {1, even z | cos(π/2z), odd z} ± D.
    Source: ISO 21771, dimension over (between) two balls.
    """
    sign = toothing.outward
    diameter = 2.0 * toothing.base_radius
    space = np.pi / toothing.teeth - toothing.thickness / (2.0 * toothing.pitch_radius)
    share = pin_diameter / (diameter * np.cos(toothing.base_helix_angle))
    involute = float(involute_function(toothing.transverse_pressure_angle)) + sign * (share - space)
    if involute <= 0.0:
        return None
    angle = float(inverse_involute_function(involute))
    string = toothing.base_radius * np.tan(angle) - sign * pin_diameter / 2.0 * np.cos(toothing.base_helix_angle)
    if string <= 0.0:
        return None
    odd = np.cos(np.pi / (2.0 * toothing.teeth)) if toothing.teeth % 2 else 1.0
    return OverPins(
        pressure_angle=angle,
        centre_radius=float(toothing.base_radius / np.cos(angle)),
        contact_radius=float(np.hypot(toothing.base_radius, string)),
        measurement=float(diameter / np.cos(angle) * odd + sign * pin_diameter),
    )

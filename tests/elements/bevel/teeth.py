"""Teeth to test with, by numbers in modules, and questions of their outlines."""

from __future__ import annotations

import numpy as np

from gearwright.elements.bevel.pitch_cone import pitch_cone_angle
from gearwright.elements.bevel.tooth import BevelTooth

PRESSURE = np.radians(20.0)


def tooth(teeth, pitch, form, rho=0.3, backlash=0.0, **changes):
    """A tooth of one and 1.25 modules above and below the pitch cone, degrees; tip radius and backlash in modules."""
    gamma = np.radians(pitch)
    module = 2.0 * np.sin(gamma) / teeth
    values = {
        "teeth": teeth,
        "pitch_angle": gamma,
        "pressure_angle": PRESSURE,
        "face_angle": gamma + np.arctan(module),
        "root_angle": gamma - np.arctan(1.25 * module),
        "thickness": (np.pi - backlash) / teeth,
        "form": form,
        "tip_radius": None if rho is None else rho * module,
    }
    return BevelTooth(**{**values, **changes})


def pair(teeth, shaft_angle, form, **changes):
    """Both teeth of a pair, the shaft angle in degrees."""
    cones = [pitch_cone_angle(z, mate, np.radians(shaft_angle)) for z, mate in (teeth, teeth[::-1])]
    return [tooth(z, np.degrees(cone), form, **changes) for z, cone in zip(teeth, cones, strict=True)]


def polar_and_azimuth(points):
    x, y, z = np.moveaxis(points, -1, 0)
    return np.arctan2(np.hypot(x, y), z), np.arctan2(y, x)

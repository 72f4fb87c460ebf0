"""Other recipes for the flanks of bevel gears, to be compared with the exact forms; no gear is built by them."""

from __future__ import annotations

import numpy as np

from ...arrays import Array, ArrayLike
from ...curves.involute import involute_function, involute_of_roll, involute_roll
from ...curves.spherical_involute import azimuth, roll_at_polar_angle
from .spherical_flank import InvoluteFlank, SphericalFlank


def tredgold_azimuth(polar: ArrayLike, pitch_angle: float, pressure_angle: float) -> Array:
    """Azimuth (...) of Tredgold's flank at polar angles (...), 0 at the pitch cone; radians.

    The plane involute of the virtual gear of z/cos γ teeth, wrapped around the back cone: seen from the apex, the polar
    angle δ is at the virtual radius tan γ + tan(δ − γ), for the cone distance 1, and angles grow by 1/cos γ.
    Raises ValueError inside the virtual base circle. Source: Tredgold's approximation; KHK, Gear Technical Reference.
    """
    radius = np.tan(pitch_angle) + np.tan(np.asarray(polar, float) - pitch_angle)
    roll = involute_roll(radius, float(np.tan(pitch_angle) * np.cos(pressure_angle)))
    return np.asarray((involute_of_roll(roll) - involute_function(pressure_angle)) / np.cos(pitch_angle))


def thesis_azimuth(polar: ArrayLike, pitch_angle: float, pressure_angle: float) -> Array:
    """Azimuth (...) of the involute at polar angles (...) with the thickness as the thesis has it; radians.

    There ψ_p = spinv(a), the pressure angle taken for the angle at the pole, so that the flank stands spinv(φ_p) −
    spinv(a) inside the tooth of the stated thickness. The base cone is that of (G2) all the same.
    Source: Al-Daccak 1989, eqs. (3.9) and (3.15), as printed.
    """
    base = InvoluteFlank(pitch_angle=pitch_angle, pressure_angle=pressure_angle).base_cone_angle
    at_pressure_angle = np.arctan2(np.sin(base) * np.sin(pressure_angle), np.cos(pressure_angle)) / np.sin(base)
    return np.asarray(azimuth(roll_at_polar_angle(polar, base), base) - (at_pressure_angle - pressure_angle))


def normal_deviations(exact: SphericalFlank, polar: ArrayLike, azimuths: ArrayLike) -> tuple[Array, Array]:
    """How far another flank stands outside an involute or octoid: amounts (...) and unit directions (..., 3).

    polar, azimuths   of the other flank (...), radians, both flanks on the clockwise side of a tooth on azimuth 0

    Radians on the unit sphere, positive where the other has more metal, along the exact flank's normal, which a turn
    by an angle Δ about the axis crosses at Δ sin δ times the cosine between normal and parallel: to first order, and
    for an involute, whose normals all touch its base cone, Δ sin γ_b exactly. Directions are seen with the flank's own
    pitch point on azimuth 0.
    """
    delta = np.asarray(polar, float)
    u = exact.parameter_at(delta)
    curve = exact.rolled(float(np.min(u)), float(np.max(u)))
    point, along = curve.point(u), curve.derivative(u)
    outward = np.cross(along, point)
    outward /= np.linalg.norm(outward, axis=-1, keepdims=True)
    turning = np.stack([-point[..., 1], point[..., 0], np.zeros_like(u)], axis=-1)
    apart = np.asarray(azimuths, float) - exact.azimuth_at(delta)
    return np.asarray(apart * np.sum(turning * outward, axis=-1)), outward

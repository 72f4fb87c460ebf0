"""The derived sizes of a cam."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...moments.polygon import polygon_moments
from ...parameters import Size, Unit
from ...sections.plane import Section
from .kinds import KINDS

if TYPE_CHECKING:
    from .cam import Cam

_FOUND: dict[str, tuple[Unit, str, str]] = {
    "pivot_distance": ("length", "d", "distance of the pivot from the cam's axis"),
    "face_offset": ("length", "e", "distance of the face from the pivot"),
    "initial_angle": ("angle", "φ₀", "angle of face or arm at the start"),
    "arm_length": ("length", "a", "length of the arm"),
    "roller_radius": ("length", "r_r", "radius of the roller"),
    "offset": ("length", "ε", "offset of the stem"),
}
"""Unit, symbol and meaning of the dimensions that are given or found; the base radius is a size of every cam."""


def sizes_of(cam: Cam) -> dict[str, Size]:
    """Dimensions of the follower, radii, contact, area and motion, by name."""
    profile = cam.traced
    follower = profile.follower
    top = profile.largest(lambda contact: np.hypot(contact.support, contact.along))
    found = {
        name: Size(cam.dimensions[name], unit, symbol, meaning)
        for name, (unit, symbol, meaning) in _FOUND.items()
        if name in cam.dimensions
    }
    found |= {
        "base_radius": Size(follower.base_radius, "length", "r_b", "radius of the base circle"),
        "largest_radius": Size(top.value, "length", "r_max", "largest radius of the disk"),
        "least_curvature_radius": Size(profile.sharpest.value, "length", "ρ_min", "where the profile is convex"),
    }
    if profile.hollow is not None:
        meaning = "where the profile is concave: a grinding wheel must have less"
        found["hollow_curvature_radius"] = Size(profile.hollow.value, "length", "ρ_c", meaning)
    found["largest_eccentricity"] = Size(
        profile.eccentricity.value, "length", "q_max", "largest distance of the contact's normal from the axis"
    )
    pressure = float(np.degrees(profile.pressure_angle.value))
    found["largest_pressure_angle"] = Size(pressure, "angle", "α_max", "between the normal and the follower's way")
    found |= _face(cam) | _motion(cam)
    area = Section(loops=(profile.loop,)).properties().area
    found["disk_area"] = Size(area, "area", "A", "area inside the profile, the bore not taken off")
    found["polygon_area"] = Size(_polygon_area(cam), "area", "A_n", f"area of the polygon of {cam.vertices} vertices")
    return found


def _face(cam: Cam) -> dict[str, Size]:
    if cam.traced.face is None:
        return {}
    least, most = cam.traced.face
    of = "the pivot's foot" if KINDS[cam.follower].swings else "the stem's line"
    return {
        "face_start": Size(least, "length", "l_1", f"nearest place of contact on the face, from {of}"),
        "face_end": Size(most, "length", "l_2", f"farthest place of contact on the face, from {of}"),
        "face_length": Size(most - least, "length", "l_f", "length of the face that is touched"),
    }


def _motion(cam: Cam) -> dict[str, Size]:
    """Greatest velocity and acceleration of the follower by the cam angle."""
    unit: Unit = "" if KINDS[cam.follower].swings else "length"
    s = np.abs(
        np.concatenate([m.derivatives(np.linspace(m.start, m.end, 2001)) for m in cam.displacement.moves], axis=1)
    )
    return {
        "largest_velocity": Size(float(s[1].max()), unit, "s′", "of the follower, by the cam angle in radians"),
        "largest_acceleration": Size(float(s[2].max()), unit, "s″", "likewise"),
    }


def _polygon_area(cam: Cam) -> float:
    return float(polygon_moments([cam.polygon()])[0, 0])

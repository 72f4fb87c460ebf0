"""The trochoid that the rounded tip of a crown gear leaves at the root of a bevel gear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .rolled import RolledCurve


@dataclass(frozen=True, kw_only=True)
class SphericalTrochoid(RolledCurve):
    """The envelope, in a gear about +z, of a small circle on the crown gear on which its pitch cone rolls.

    depth    h, angle of the small circle's centre above the pitch plane, towards the gear's axis; negative below it
    offset   e, turn of the crown gear between that centre and the middle of its tooth, which stands on azimuth 0
    radius   ρ, angular, of the small circle

    The parameter is the bearing t of the contact at the pitch point. At t = π/2 the land of the crown gear's tip
    touches: the root cone. Downwards from there the curve lies counter-clockwise of azimuth 0, up to the flank. The
    centre is at the distance D from the pitch point, sin D = sin h/sin t, and the longitude λ, sin λ = tan h/tan t;
    the contact is ρ beyond it while the crown gear has turned by e − λ.
    Source: theory of gearing, contact where the common normal passes the pitch point; as `Trochoid` in the plane.
    """

    depth: float
    offset: float
    radius: float

    def contact(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        t = np.asarray(u, float)
        centre = np.arcsin(np.sin(self.depth) / np.sin(t))
        longitude = np.arcsin(np.tan(self.depth) * np.cos(t) / np.sin(t))
        return self.offset - longitude, t, centre + self.radius

    def contact_rates(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        t = np.asarray(u, float)
        c, s = np.cos(t), np.sin(t)
        sine, tangent = np.sin(self.depth) / s, np.tan(self.depth) * c / s
        turning = np.tan(self.depth) / (s * s * np.sqrt(1.0 - tangent * tangent))
        return turning, np.ones_like(t), -sine * c / (s * np.sqrt(1.0 - sine * sine))

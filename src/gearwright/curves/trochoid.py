"""The trochoid that the rounded tip of a rack leaves at the root of a gear rolling on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Trochoid(Curve):
    """The envelope of an elliptic rack tip in a gear about the origin that rolls on the rack's pitch line.

    pitch_radius   r of the gear
    depth          h of the ellipse's centre below the pitch line; negative above it
    offset         e of that centre from the middle of the rack's tooth, which stands on +x
    half_axes      (along the pitch line, across it) of the ellipse: (ρ/cos β, ρ) for a round tip in the normal
                   section of helix angle β, a circle where β = 0

    The parameter is the angle t between the rack's normal at the point of contact and the pitch line. At t = π/2
    the tip's land touches: the root circle. Downwards from there the curve lies counter-clockwise of +x; it meets
    the flank where t is the transverse pressure angle. With the point (x, y) of the ellipse from its centre whose
    normal has the angle t, and Y = h + y, the contact is at (r − Y, Y cot t) while the gear has turned by
    (e + x − Y cot t)/r. Source: theory of gearing, contact where the common normal passes the pitch point; for a
    circle ISO 21771 gives the same root fillet.
    """

    pitch_radius: float
    depth: float
    offset: float
    half_axes: tuple[float, float]

    def _ellipse(self, t: Array) -> tuple[Array, Array]:
        """The point (x, y) of the ellipse whose normal has an angle t from its first axis."""
        a, b = self.half_axes
        c, s = np.cos(t), np.sin(t)
        root = np.hypot(a * c, b * s)
        return a * a * c / root, b * b * s / root

    def point(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        x, y = self._ellipse(t)
        below = self.depth + y
        beside = below / np.tan(t)
        angle = (self.offset + x - beside) / self.pitch_radius
        return _turned(angle, self.pitch_radius - below, beside)

    def derivative(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        a, b = self.half_axes
        c, s = np.cos(t), np.sin(t)
        x, y = self._ellipse(t)
        curvature_radius = (a * b) ** 2 / np.hypot(a * c, b * s) ** 3
        below, below_rate = self.depth + y, curvature_radius * c
        beside, beside_rate = below * c / s, curvature_radius * c * c / s - below / s**2
        angle = (self.offset + x - beside) / self.pitch_radius
        turning = (-curvature_radius * s - beside_rate) / self.pitch_radius
        return _turned(angle, -below_rate - turning * beside, beside_rate + turning * (self.pitch_radius - below))


def _turned(angle: Array, x: Array, y: Array) -> Array:
    """Vectors (..., 2) of coordinates x, y (...) turned by an angle (...)."""
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)

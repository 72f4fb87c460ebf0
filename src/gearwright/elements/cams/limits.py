"""What a cam of least area must hold: eccentricity, curvature, pressure angle, room for the bore."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arrays import Array
from .followers import Contact, FlatFace, Follower

LEAST_CURVATURE = 1e-3
"""Radius of curvature that a profile keeps if none is asked for, × the base radius: "greater than 0" with a margin."""
_LEAST_TURNING = 1e-3  # of a flat face against the cam, by the cam's own: the same of 0
_LEAST_BASE = 1e-3  # base radius, × the size of the mechanism: the same


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Limits of a synthesis.

    eccentricity      greatest |q|, × base radius
    curvature_radius  least radius of curvature of the convex profile; None for LEAST_CURVATURE × base radius
    pressure_angle    greatest, radians; None for none
    base_radius       least
    """

    eccentricity: float
    curvature_radius: float | None
    pressure_angle: float | None
    base_radius: float

    def margins(self, follower: Follower, contact: Contact, size: float) -> dict[str, Array]:
        """By how much each limit is kept at contacts (n,), once for the base radius: ≥ 0 where it is.

        In radians or in units of the size.
        """
        base = follower.base_radius
        least = LEAST_CURVATURE * base if self.curvature_radius is None else self.curvature_radius
        found = {
            "eccentricity": (self.eccentricity * base - np.abs(contact.along)) / size,
            "radius of curvature": (contact.speed - least * contact.turning) / size,
            "base radius": np.array([(base - max(self.base_radius, _LEAST_BASE * size)) / size]),
        }
        if self.pressure_angle is not None:
            found["pressure angle"] = self.pressure_angle - np.abs(np.arctan(contact.pressure))
        if isinstance(follower, FlatFace):
            found["turning of the face"] = contact.turning - _LEAST_TURNING
        return found

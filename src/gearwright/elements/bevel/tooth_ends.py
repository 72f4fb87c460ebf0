"""Where the teeth of a bevel gear end: on spheres about the apex, on cones, or on planes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ...curves.traces.trace import Trace
from ...motions.ends import Ends, between
from ...motions.radial import Radial

EndKind = Literal["spherical", "conical", "flat"]


@dataclass(frozen=True, kw_only=True)
class ToothEnds:
    """The inner and outer ends of teeth, through the pitch line at two distances from the apex.

    kind            "conical": back and front cone, perpendicular to the pitch cone; "spherical": about the apex;
                    "flat": planes across the axis
    pitch_angle     γ, radians
    inner, outer    R_i and R_e, along the pitch line

    A level is the surface through the pitch line at a distance s from the apex that is of the ends' kind.
    """

    kind: EndKind
    pitch_angle: float
    inner: float
    outer: float

    @property
    def levels(self) -> float | None:
        """λ of the levels r cos(θ − λ) = v (see `Radial`)."""
        return {"spherical": None, "conical": self.pitch_angle, "flat": 0.0}[self.kind]

    def parameter(self, pitch_distance: float) -> float:
        """v of the level through the pitch line at a distance from the apex."""
        return float(pitch_distance * np.cos(self.pitch_angle)) if self.kind == "flat" else pitch_distance

    def pitch_distance(self, v: float) -> float:
        """Distance from the apex along the pitch line of the level of a parameter: inverse of `parameter`."""
        return float(v / np.cos(self.pitch_angle)) if self.kind == "flat" else v

    @property
    def ends(self) -> Ends:
        return between(self.parameter(self.inner), self.parameter(self.outer))

    def motion(self, trace: Trace) -> Radial:
        return Radial(trace=trace, levels=self.levels)

    def distance(self, polar: float, pitch_distance: float) -> float:
        """r from the apex at a polar angle, on the level through the pitch line at a distance."""
        v = self.parameter(pitch_distance)
        return v if self.levels is None else float(v / np.cos(polar - self.levels))

    def point(self, polar: float, pitch_distance: float) -> tuple[float, float]:
        """(ρ, z) at a polar angle, on the level through the pitch line at a distance."""
        if self.kind == "flat":
            height = self.parameter(pitch_distance)
            return float(height * np.tan(polar)), height
        r = self.distance(polar, pitch_distance)
        return float(r * np.sin(polar)), float(r * np.cos(polar))

    def polar_at_radius(self, radius: float, pitch_distance: float) -> float:
        """Polar angle of the level's point at a distance ρ from the axis, nearer to it than the pitch line."""
        v = self.parameter(pitch_distance)
        if self.levels is None:
            return float(np.arcsin(radius / v))
        c, s = np.cos(self.levels), np.sin(self.levels)
        return float(np.arctan2(radius * c, v - radius * s))

    def polar_at_height(self, height: float, pitch_distance: float) -> float:
        """Polar angle of the point at z of the cone perpendicular to the pitch cone; negative beyond its apex."""
        c, s = np.cos(self.pitch_angle), np.sin(self.pitch_angle)
        return float(np.arctan2(pitch_distance - height * c, height * s))

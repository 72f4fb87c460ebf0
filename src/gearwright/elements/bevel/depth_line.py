"""Lines of the axial plane along which the tips and the roots of a bevel gear's teeth lie."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .tooth_ends import ToothEnds

_ROUNDING = 1e-12  # of the cone distance


@dataclass(frozen=True, kw_only=True)
class DepthLine:
    """The straight line of tips or roots beside the pitch line: h(s) = h_e − (R_e − s) tan θ.

    outer    R_e, cone distance of the outer end
    height   h_e, outer height above the pitch line; negative: below it
    angle    θ between line and pitch line, radians; positive where the height grows outward

    Source: ISO 23509, for face and root angles of any depth taper.
    """

    outer: float
    height: float
    angle: float

    @property
    def offset(self) -> float:
        """Height of the line above the pitch line at the apex: 0 where it goes through the apex."""
        found = self.height - self.outer * float(np.tan(self.angle))
        return 0.0 if abs(found) <= _ROUNDING * self.outer else found

    def height_at(self, distance: float) -> float:
        """h at a distance s along the pitch line from the apex."""
        return self.height - (self.outer - distance) * float(np.tan(self.angle))

    def polar_angle(self, ends: ToothEnds, v: float) -> float:
        """Polar angle, radians, of the line's point on the level of a parameter (see `Radial`).

        Raises ValueError where the line does not meet the level, or runs along it.
        """
        gamma, a, t = ends.pitch_angle, self.offset, float(np.tan(self.angle))
        if a == 0.0:
            return gamma + self.angle
        if ends.kind == "conical":
            s = v
        elif ends.kind == "flat":
            if not np.cos(gamma) > t * np.sin(gamma):
                raise ValueError("the line of tips or roots runs along the planes that should end it")
            s = (v + a * np.sin(gamma)) / (np.cos(gamma) - t * np.sin(gamma))
        else:
            if not v * v * (1.0 + t * t) > a * a:
                raise ValueError("the line of tips or roots does not meet the sphere that should end it")
            s = (np.sqrt(v * v * (1.0 + t * t) - a * a) - a * t) / (1.0 + t * t)
        return float(gamma + np.arctan2(a + s * t, s))

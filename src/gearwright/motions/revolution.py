"""Revolution about z."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.arc import Arc
from ..curves.curve import Curve
from ..curves.line import Line
from ..moments.body import BodyMoments, about_centroid
from ..moments.sweep import revolution_sweep
from ..sections.plane import Section
from ..sections.section import LoopedSection
from ..surfaces.cone import Cone
from ..surfaces.plane import Plane
from ..surfaces.sphere import Sphere
from ..surfaces.surface import Surface
from .ends import Ends
from .motion import Motion

FULL_TURN = 2.0 * np.pi
_ROUNDED = 1e-11  # radians: a cylinder's line may lean so far by the rounding of its ends
_CLOSED = 1e-12  # how far from a full turn still closes: some roundings of 2π


@dataclass(frozen=True, kw_only=True)
class Revolution(Motion):
    """r = (x cos v, −x sin v, y): section x is the radius, section y the axis, which becomes z.

    The azimuth is −v, so that a counter-clockwise section has a positive jacobian, x.
    """

    def place(self, point: Array, v: ArrayLike) -> Array:
        x, y = point[..., 0], point[..., 1]
        return np.stack([x * np.cos(v), -x * np.sin(v), y + np.zeros_like(x * np.asarray(v))], axis=-1)

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        return self.place(tangent, v)

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        x = point[..., 0]
        return np.stack([-x * np.sin(v), -x * np.cos(v), np.zeros_like(x * np.asarray(v))], axis=-1)

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        return point[..., 0] + np.zeros(np.shape(v))

    def end_surface(self, v: float) -> Surface:
        c, s = float(np.cos(v)), float(np.sin(v))
        return Plane(origin=(0.0, 0.0, 0.0), x_axis=(c, -s, 0.0), y_axis=(0.0, 0.0, 1.0))

    def swept_surface(self, curve: Curve) -> Surface | None:
        if isinstance(curve, Arc) and curve.centre == (0.0, 0.0):
            return Sphere(radius=curve.radius)
        if isinstance(curve, Line) and curve.first[1] == curve.last[1]:
            return Plane(origin=(0.0, 0.0, float(curve.first[1])))
        return _cone(curve) if isinstance(curve, Line) else None

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        if not isinstance(section, Section) or section.varies:
            return None
        local = section.local_moments
        level = float(local.origin[1])
        matrix = revolution_sweep(local.about((0.0, level)), -ends.finish, -ends.start)
        return about_centroid(matrix, "exact", section.moments_error, np.array([0.0, 0.0, level]))

    def refusal(self, ends: Ends) -> str | None:
        if ends.span > FULL_TURN + _CLOSED:
            return f"a revolution of {np.degrees(ends.span):.6g}° would run into itself; 360° is all"
        return super().refusal(ends)

    def station(self, v: float) -> str:
        return f"azimuth {np.degrees(0.0 - v):.6g}°"

    def remedy(self, point: Array, v: float) -> str:
        del v
        return f"it lies {abs(float(point[0])):.6g} beyond the axis x = 0; keep the section on the side of positive x"

    @property
    def has_still_points(self) -> bool:
        return True

    @property
    def rotation_order(self) -> int:
        return 1

    def closed(self, ends: Ends) -> bool:
        return abs(ends.span - FULL_TURN) < _CLOSED


def _cone(line: Line) -> Cone | None:
    """The cone or cylinder a line of the half-plane sweeps, where it faces away from the origin and upward."""
    (first_rho, first_z), (last_rho, last_z) = line.first, line.last
    across, up = last_z - first_z, first_rho - last_rho  # of a normal
    sense = 1.0 if across > 0.0 else -1.0
    angle = float(np.arctan2(sense * across, sense * up))
    distance = float(first_rho * np.sin(angle) + first_z * np.cos(angle))
    if angle > np.pi / 2.0 + _ROUNDED or distance <= 0.0:
        return None
    return Cone(angle=min(angle, np.pi / 2.0), distance=distance)

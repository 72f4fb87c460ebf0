"""The path of contact of conjugate teeth on the sphere, from the pinion's flank alone.

A flank of a body that turns relatively to its mate about the pitch line touches it where its tangent along the
sphere is at right angles to that line (the law of gearing): the relative velocity ω × p has then no part along the
normal. For a point of the pinion's flank that is one equation, of closed form, in the pinion's turn; no mate is asked.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array, ArrayLike
from .graded import Graded
from .mesh import Mesh, Side
from .search import crossing


@dataclass(frozen=True, kw_only=True)
class ContactPath:
    """Where one side of conjugate teeth touches on the unit sphere: pinion axis +z, pitch line in the plane +x, z.

    Flanks are taken to be smooth between form and tip, and conjugate: relief moves contact off this path.
    """

    mesh: Mesh
    side: Side = "drive"

    @cached_property
    def sense(self) -> float:
        return 1.0 if self.side == "drive" else -1.0

    @cached_property
    def _fit(self) -> Graded:
        flank = self.mesh.pinion.flank
        return Graded.of(flank.half_angle, flank.form_angle, flank.face_angle)

    def turn(self, polar: ArrayLike) -> Array:
        """The pinion's turn (...) from tooth on pitch line at which it touches at polar angles (...), radians."""
        return self._azimuth(polar) - self.sense * self._fit.value(polar)

    def point(self, polar: ArrayLike) -> Array:
        """Unit vectors (..., 3) of the points of contact where the pinion touches at polar angles (...)."""
        delta, azimuth = np.asarray(polar, float), self._azimuth(polar)
        across = np.sin(delta)
        return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), np.cos(delta)], axis=-1)

    def polar(self, turn: ArrayLike) -> Array:
        """Polar angle (...) on the pinion's flank that touches at turns (...) between `ends`: inverse of `turn`."""
        wanted = np.atleast_1d(np.asarray(turn, float))
        low, high = (np.full(wanted.shape, one) for one in self.active)
        return crossing(lambda x: self.turn(x) - wanted, low, high).reshape(np.shape(turn))

    @cached_property
    def active(self) -> tuple[float, float]:
        """Polar angles on the pinion between which it touches: from the gear's tip, or its own foot, to its tip."""
        gear, flank = self.mesh.gear.flank, self.mesh.pinion.flank
        low, high = np.array([self._foot]), np.array([flank.face_angle])
        on_gear = self._gear_polar(low), self._gear_polar(high)
        if on_gear[0] > gear.face_angle:
            low = crossing(lambda x: self._gear_polar(x) - gear.face_angle, low, high)
        if on_gear[1] < gear.form_angle:
            high = crossing(lambda x: self._gear_polar(x) - gear.form_angle, low, high)
        return float(low[0]), float(high[0])

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Turns of the pinion between which a tooth touches on one sphere, the lesser first, radians."""
        first, last = sorted(float(self.turn(one)) for one in self.active)
        return first, last

    @property
    def transverse_ratio(self) -> float:
        """Contact ratio on a sphere: turn while a tooth touches over the pitch."""
        return (self.ends[1] - self.ends[0]) / self.mesh.pitch

    def _gear_polar(self, polar: Array) -> Array:
        axis = np.array([np.sin(self.mesh.shaft_angle), 0.0, np.cos(self.mesh.shaft_angle)])
        point = self.point(polar)
        return np.arctan2(np.linalg.norm(np.cross(axis, point), axis=-1), point @ axis)

    @cached_property
    def _foot(self) -> float:
        """The least polar angle at which the pinion's flank can touch at all."""
        flank = self.mesh.pinion.flank
        low = np.array([flank.form_angle])
        if self._room(low)[0] >= 0.0:
            return flank.form_angle
        return float(crossing(self._room, low, np.array([self.mesh.pinion.pitch_angle]))[0]) + 1e-12

    def _room(self, polar: Array) -> Array:
        """≥ 0 where some turn makes the flank's tangent square to the pitch line."""
        slope = np.sin(polar) * self._fit.slope(polar)
        return np.hypot(np.cos(polar), slope) - np.sin(polar) / np.tan(self.mesh.pinion.pitch_angle)

    def _azimuth(self, polar: ArrayLike) -> Array:
        """Of the point of contact: cos δ cos a − sin δ h′ sin a = sin δ/tan γ, the root through the pitch line."""
        delta = np.asarray(polar, float)
        across = np.sin(delta) * self._fit.slope(delta)  # h′ sin δ, < 0
        along = np.cos(delta)
        wanted = np.sin(delta) / np.tan(self.mesh.pinion.pitch_angle) / np.hypot(along, across)
        return -self.sense * (np.arctan2(across, along) + np.arccos(np.clip(wanted, -1.0, 1.0)))

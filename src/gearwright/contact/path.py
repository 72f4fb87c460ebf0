"""The path of contact of conjugate teeth on the sphere, from the form of the pinion's flank alone.

A flank of a body that turns relatively to its mate about the pitch line touches it where its tangent along the
sphere is at right angles to that line (the law of gearing): the relative velocity ω × p has then no part along the
normal. For a point of the pinion's flank that is one equation, of closed form, in the pinion's turn; no mate is asked.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import Chebyshev

from ..arrays import Array, ArrayLike, Indices
from ..curves.crossing import crossing
from ..errors import GeometryError, Problem
from .graded import Graded
from .mesh import Mesh, Side
from .search import stretches

_DEGREE = 40  # of the height touched over the turn, in which it is analytic
_LOOKED_AT = 129  # cone distances among which the ends of teeth are seen
_ROUNDING = 1e-12  # radians: how far off the foot a turn is still well found


@dataclass(frozen=True, kw_only=True)
class ContactPath:
    """Where one side of conjugate teeth touches on the unit sphere: pinion axis +z, pitch line in the plane +x, z.

    Flanks are taken as their forms: relief and crowning move contact off this path. The path is the same on all
    spheres; how much of it is used is not, where tips, feet or ends do not lie on spheres or cones about the apex.
    """

    mesh: Mesh
    side: Side = "drive"

    @cached_property
    def sense(self) -> float:
        return 1.0 if self.side == "drive" else -1.0

    def turn(self, polar: ArrayLike) -> Array:
        """The pinion's turn (...) from tooth on pitch line at which it touches at polar angles (...), radians."""
        return self._azimuth(polar) - self.sense * self._fit.value(polar)

    def point(self, polar: ArrayLike) -> Array:
        """Unit vectors (..., 3) of the points of contact where the pinion touches at polar angles (...)."""
        delta, azimuth = np.asarray(polar, float), self._azimuth(polar)
        across = np.sin(delta)
        return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), np.cos(delta)], axis=-1)

    def polar(self, turn: ArrayLike) -> Array:
        """Polar angle (...) on the pinion's flank that touches at turns (...) between `turns`: inverse of `turn`."""
        return np.asarray(self._inverse(np.clip(turn, *self.turns)))

    def gear_polar(self, polar: ArrayLike) -> Array:
        """Polar angles (...) on the gear where the pinion touches at polar angles (...)."""
        axis = np.array([np.sin(self.mesh.shaft_angle), 0.0, np.cos(self.mesh.shaft_angle)])
        point = self.point(polar)
        return np.arctan2(np.linalg.norm(np.cross(axis, point), axis=-1), point @ axis)

    @cached_property
    def heights(self) -> tuple[float, float]:
        """Polar angles on the pinion between which it could touch, were the gear's teeth long enough."""
        lowest, highest = self.mesh.pinion.heights
        return max(lowest, self._foot), highest

    @cached_property
    def turns(self) -> tuple[float, float]:
        """Turns of the pinion at these, the lesser first, radians."""
        first, last = sorted(self.turn(self.heights).tolist())
        return first, last

    def room(self, turn: Array, distance: ArrayLike) -> Array:
        """≥ 0 (...) where both flanks are there at turns (...) on spheres (...); see `Member.room`."""
        polar = self.polar(turn)
        on_both = np.minimum(
            self.mesh.pinion.room(polar, distance), self.mesh.gear.room(self.gear_polar(polar), distance)
        )
        return np.minimum(on_both, np.minimum(turn - self.turns[0], self.turns[1] - turn))

    def active(self, distance: ArrayLike) -> tuple[Array, Array]:
        """Polar angles (n,) on the pinion between which it touches on spheres (n,): tips and feet, but not ends."""
        r = np.atleast_1d(np.asarray(distance, float))
        pitch = np.full(r.shape, self.mesh.pinion.pitch_angle)
        first, last = (self._limit(r, np.full(r.shape, end), pitch) for end in self.heights)
        return first, last

    def _limit(self, distance: Array, end: Array, pitch: Array) -> Array:
        """Between the end of a flank and the pitch cone, where it begins or ends to touch."""

        def room(polar: Array) -> Array:
            other = self.gear_polar(polar)
            pinion, gear = self.mesh.pinion, self.mesh.gear
            return np.minimum(
                pinion.height_room(polar, pinion.level(polar, distance)),
                gear.height_room(other, gear.level(other, distance)),
            )

        return np.where(room(end) >= -_ROUNDING, end, crossing(room, end, pitch))

    @cached_property
    def spheres(self) -> Array:
        """Cone distances from the least to the greatest that both members have, with those where a trace turns back."""
        reaches = np.array([self.mesh.pinion.reach, self.mesh.gear.reach])
        between = np.linspace(reaches[:, 0].max(), reaches[:, 1].min(), _LOOKED_AT)
        return np.union1d(between, self.mesh.pinion.bends)

    @cached_property
    def first_and_last(self) -> tuple[float, float]:
        """Turns of the pinion between which a tooth touches on whatever sphere, radians.

        It begins and ends at a tip or a foot, on the sphere on which the tooth is furthest ahead or behind. Raises
        GeometryError where no sphere shows that, as of teeth a hundredth of a module wide.
        """
        turns = np.concatenate([self._turns_at_limit(0), self._turns_at_limit(1)])
        if not len(turns):
            problem = Problem(
                "the face", "it is too narrow to tell where teeth begin and cease to touch; make it wider"
            )
            raise GeometryError("Lines of contact cannot be found", [problem])
        return float(turns.min()), float(turns.max())

    def _turns_at_limit(self, which: int) -> Array:
        """Turns (n,) at which a tooth begins (0) or ceases (1) to touch on the spheres where neither has ended."""

        def room(_: Indices, r: Array) -> Array:
            polar = self.active(r)[which]
            return np.minimum(self.mesh.pinion.end_room(polar, r), self.mesh.gear.end_room(self.gear_polar(polar), r))

        _, inner, outer = stretches(room, self.spheres[:, None])
        between = [self.spheres[(self.spheres > a) & (self.spheres < b)] for a, b in zip(inner, outer, strict=True)]
        r = np.concatenate([inner, outer, *between])
        return np.asarray(self.turn(self.active(r)[which]) - self.mesh.pinion.trace.turn(r))

    @property
    def transverse_ratio(self) -> float:
        """Contact ratio on the sphere at mid-face: turn while a tooth touches over the pitch."""
        ends = self.active(self.mesh.pinion.pitch_ends.mean())
        first, last = (float(self.turn(one)[0]) for one in ends)
        return abs(last - first) / self.mesh.pitch

    @cached_property
    def _fit(self) -> Graded:
        return Graded.of(self.mesh.pinion.flank.form_half, *self.mesh.pinion.heights)

    @cached_property
    def _inverse(self) -> Chebyshev:
        low, high = self.heights

        def polar(turn: Array) -> Array:
            return crossing(lambda x: self.turn(x) - turn, np.full(turn.shape, low), np.full(turn.shape, high))

        return Chebyshev.interpolate(polar, _DEGREE, domain=self.turns)

    @cached_property
    def _foot(self) -> float:
        """The least polar angle at which the pinion's flank can touch at all."""
        low = np.array(self.mesh.pinion.heights[:1])
        if self._turning_room(low)[0] >= 0.0:
            return float(low[0])
        pitch = np.array([self.mesh.pinion.pitch_angle])
        return float(crossing(self._turning_room, low, pitch)[0]) + _ROUNDING

    def _turning_room(self, polar: Array) -> Array:
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

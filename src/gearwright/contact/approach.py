"""How far the flank of one pinion tooth lets the gear's tooth before it come back.

Every point of the pinion's flank, seen from the gear, lies at a cone distance, a polar angle and an azimuth at which
the gear's flank has an azimuth of its own; their difference is the angle by which the gear may still turn until the
two meet there. All of it is closed form; what the tooth as a whole allows is the greatest lead over its points.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from .mesh import Mesh, Side
from .misalignment import ALIGNED, Misalignment
from .search import crossing, largest

_NODES = 7  # of a flank's height and of its length: contact has one best point on each, rarely two
_STEPS = 26  # of golden section: 4e-6 of a third of the flank, so the value is good to 1e-13 of its drop


@dataclass(frozen=True, kw_only=True)
class Touch:
    """The greatest lead (n,) of the gear, −∞ where the teeth are apart, and the pinion's point where it arises.

    lead       angle of the gear ahead of its ideal position, in the sense in which it is driven, radians
    distance   cone distance (n,) on the pinion
    polar      polar angle (n,) on the pinion, radians
    """

    lead: Array
    distance: Array
    polar: Array


@dataclass(frozen=True, kw_only=True)
class Approach:
    """One side of a pair's teeth, with the axes where they stand."""

    mesh: Mesh
    side: Side = "drive"
    misalignment: Misalignment = ALIGNED

    @cached_property
    def _sense(self) -> float:
        return 1.0 if self.side == "drive" else -1.0

    @cached_property
    def _seat(self) -> tuple[Array, Array]:
        return self.misalignment.gear_seat(self.mesh.shaft_angle)

    @cached_property
    def _is_uniform(self) -> bool:
        """Whether all spheres about the apex see the same: straight teeth, and one apex."""
        member = self.mesh.pinion
        distances = np.linspace(member.inner, member.outer, _NODES)
        slopes = [one.trace.slope(distances) for one in (member, self.mesh.gear)]
        return self.misalignment.keeps_apex and not np.any(slopes)

    def touch(self, turn: Array) -> Touch:
        """Of the pinion's first tooth when it stands turned by angles (n,), radians, from the pitch line."""
        pinion = self.mesh.pinion
        distance = np.full(turn.shape, pinion.outer)
        if not self._is_uniform:
            meets = self._meets(turn)
            ends = np.full(meets.sum(), pinion.inner), np.full(meets.sum(), pinion.outer)
            distance[meets], _ = largest(
                lambda r: self._on_sphere(turn[meets], r)[0], *ends, nodes=2 * _NODES, steps=_STEPS
            )
        lead, polar = self._on_sphere(turn, distance)
        return Touch(lead=lead, distance=distance, polar=polar)

    def _meets(self, turn: Array) -> NDArray[np.bool_]:
        """Whether a tooth (n,) is within its mate's flank anywhere, or so nearly that it may be between the nodes."""
        pinion = self.mesh.pinion
        found = np.zeros(turn.shape, bool)
        heights = np.linspace(pinion.flank.form_angle, pinion.flank.face_angle, _NODES)
        step = heights[1] - heights[0]
        for distance in np.linspace(pinion.inner, pinion.outer, 2 * _NODES):
            for polar in heights:
                at = self._seen(turn, np.full(turn.shape, distance), np.full(turn.shape, polar))
                near = [margin(at) > -2.0 * step for margin in self._margins[:2]]
                found |= np.all(near, axis=0)
        return found

    def lead(self, turn: Array, distance: Array, polar: Array) -> Array:
        """Of the gear (...), if it touched the pinion at points (...) of its flank."""
        at = self._seen(turn, distance, polar)
        gear, ratio = self.mesh.gear, self.mesh.pinion.teeth / self.mesh.gear.teeth
        reach = np.linalg.norm(at, axis=-1)
        height = np.clip(_polar(at), gear.flank.form_angle, gear.flank.face_angle)
        behind = np.arctan2(at[..., 1], at[..., 0]) - gear.trace.turn(reach) + turn * ratio
        return gear.flank.half_angle(height) - np.pi / gear.teeth - self._sense * behind

    def is_on_gear(self, turn: Array, distance: Array, polar: Array) -> Array:
        """How far inside the gear's flank points (...) of the pinion's lie: the least margin, < 0 outside."""
        at = self._seen(turn, distance, polar)
        return np.min([margin(at) for margin in self._margins], axis=0)

    def _seen(self, turn: Array, distance: Array, polar: Array) -> Array:
        """Points (..., 3) of the pinion's flank in the frame of the gear's seat."""
        point = self.mesh.pinion.flank_points(distance, polar, self._sense, turn)
        axes, apex = self._seat
        return (point - apex) @ axes

    @cached_property
    def _margins(self) -> tuple[Callable[[Array], Array], ...]:
        """Functions of points in the gear's frame, ≥ 0 within its tips, the foot of its flanks, and its ends."""
        gear = self.mesh.gear
        on_flank = (lambda at: gear.flank.face_angle - _polar(at), lambda at: _polar(at) - gear.flank.form_angle)
        if self.misalignment.keeps_apex:
            return on_flank
        return (
            *on_flank,
            lambda at: gear.outer - np.linalg.norm(at, axis=-1),
            lambda at: np.linalg.norm(at, axis=-1) - gear.inner,
        )

    def _on_sphere(self, turn: Array, distance: Array) -> tuple[Array, Array]:
        """(lead, polar angle) of the best point at given cone distances (n,) of the pinion."""
        flank = self.mesh.pinion.flank
        low, high = np.full(turn.shape, flank.form_angle), np.full(turn.shape, flank.face_angle)
        lead, polar, left = np.full(turn.shape, -np.inf), high.copy(), np.arange(len(turn), dtype=np.int64)
        for margin in self._margins:
            left, low, high = self._cut(margin, turn, distance, left, low, high)
        if len(left):
            polar[left], lead[left] = largest(
                lambda x: self.lead(turn[left], distance[left], x), low, high, nodes=_NODES, steps=_STEPS
            )
        return lead, polar

    def _cut(
        self, margin: Callable[[Array], Array], turn: Array, distance: Array, left: Indices, low: Array, high: Array
    ) -> tuple[Indices, Array, Array]:
        """Which columns are left, and their intervals of polar angle, where a margin ≥ 0 holds."""

        def inside(columns: Indices, polar: Array) -> Array:
            return margin(self._seen(turn[columns], distance[columns], polar))

        at_low, at_high = inside(left, low), inside(left, high)
        alive = (at_low >= 0.0) | (at_high >= 0.0)
        left = left[alive]
        low, high, at_low, at_high = (one[alive] for one in (low, high, at_low, at_high))
        cut = np.flatnonzero((at_low < 0.0) | (at_high < 0.0))
        if len(cut):
            root = crossing(lambda x: inside(left[cut], x), low[cut], high[cut])
            below = at_low[cut] < 0.0
            low[cut], high[cut] = np.where(below, root, low[cut]), np.where(below, high[cut], root)
        return left, low, high


def _polar(at: Array) -> Array:
    return np.arctan2(np.hypot(at[..., 0], at[..., 1]), at[..., 2])

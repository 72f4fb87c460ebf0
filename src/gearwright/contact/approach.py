"""How far the flank of one pinion tooth lets the gear's tooth before it come back.

Every point of the pinion's flank, seen from the gear, lies at a cone distance, a polar angle and an azimuth at which
the gear's flank has an azimuth of its own; their difference is the angle by which the gear may still turn until the
two meet there. All of it is closed form; what the tooth as a whole allows is the greatest lead over its points.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from .mesh import Mesh, Side
from .misalignment import ALIGNED, Misalignment
from .search import largest, stretches

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
        """Whether all spheres about the apex see the same, so that any will do and the ends do not matter."""
        return self.misalignment.keeps_apex and self.mesh.is_uniform

    def touch(self, turn: Array) -> Touch:
        """Of the pinion's first tooth when it stands turned by angles (n,), radians, from the pitch line.

        Where it touches alike on all spheres, that at mid-face is named.
        """
        pinion = self.mesh.pinion
        level = np.full(turn.shape, (pinion.inner + pinion.outer) / 2.0)
        if not self._is_uniform:
            meets = self._meets(turn)
            ends = np.full(meets.sum(), pinion.inner), np.full(meets.sum(), pinion.outer)
            level[meets], _ = largest(
                lambda v: self._on_level(turn[meets], v)[0], *ends, nodes=2 * _NODES + 1, steps=_STEPS
            )
        lead, polar = self._on_level(turn, level)
        return Touch(lead=lead, distance=pinion.distance(polar, level), polar=polar)

    def _meets(self, turn: Array) -> NDArray[np.bool_]:
        """Whether a tooth (n,) is within its mate's flank anywhere, or so nearly that it may be between the nodes."""
        pinion, gear = self.mesh.pinion, self.mesh.gear
        found = np.zeros(turn.shape, bool)
        for level in np.linspace(pinion.inner, pinion.outer, 2 * _NODES):
            form, face = float(pinion.flank.form_angle(level)), float(pinion.flank.face_angle(level))
            step = (face - form) / (_NODES - 1)
            for polar in np.linspace(form, face, _NODES):
                at = self._seen(turn, np.full(turn.shape, level), np.full(turn.shape, polar))
                height = _polar(at)
                found |= gear.height_room(height, gear.level(height, _reach(at))) > -2.0 * step
        return found

    def lead(self, turn: Array, level: Array, polar: Array) -> Array:
        """Of the gear (...), if it touched the pinion at points (...) of its flank."""
        at = self._seen(turn, level, polar)
        gear, ratio = self.mesh.gear, self.mesh.pinion.teeth / self.mesh.gear.teeth
        reach, seen = _reach(at), _polar(at)
        there = gear.level(seen, reach)
        height = np.clip(seen, gear.flank.form_angle(there), gear.flank.face_angle(there))
        behind = np.arctan2(at[..., 1], at[..., 0]) - gear.trace.turn(reach) + turn * ratio
        return gear.flank.half_angle(height, there) - np.pi / gear.teeth - self._sense * behind

    def room(self, turn: Array, level: Array, polar: Array) -> Array:
        """How far inside the gear's flank points (...) of the pinion's lie: < 0 outside (see `Member.room`)."""
        at = self._seen(turn, level, polar)
        gear, height = self.mesh.gear, _polar(at)
        if self._is_uniform:
            return gear.height_room(height, (gear.inner + gear.outer) / 2.0)
        return gear.room(height, _reach(at))

    def _seen(self, turn: Array, level: Array, polar: Array) -> Array:
        """Points (..., 3) of the pinion's flank in the frame of the gear's seat."""
        point = self.mesh.pinion.flank_points(level, polar, self._sense, turn)
        axes, apex = self._seat
        return (point - apex) @ axes

    def _on_level(self, turn: Array, level: Array) -> tuple[Array, Array]:
        """(lead, polar angle) of the best point on given levels (n,) of the pinion."""
        flank = self.mesh.pinion.flank
        form, face = flank.form_angle(level), flank.face_angle(level)
        grid = form + np.linspace(0.0, 1.0, _NODES)[:, None] * (face - form)
        grid[-1] = face
        columns, low, high = stretches(lambda at, x: self.room(turn[at], level[at], x), grid)
        lead, polar = np.full(turn.shape, -np.inf), face.copy()
        if len(columns):
            where, found = largest(
                lambda x: self.lead(turn[columns], level[columns], x), low, high, nodes=_NODES, steps=_STEPS
            )
            best = _best(columns, found)
            lead[columns[best]], polar[columns[best]] = found[best], where[best]
        return lead, polar


def _best(columns: Indices, values: Array) -> Indices:
    """Which of the values (m,) are the greatest of their columns (m,)."""
    order = np.lexsort((-values, columns))
    _, first = np.unique(columns[order], return_index=True)
    return np.asarray(order[first])


def _reach(at: Array) -> Array:
    return np.asarray(np.linalg.norm(at, axis=-1))


def _polar(at: Array) -> Array:
    return np.arctan2(np.hypot(at[..., 0], at[..., 1]), at[..., 2])

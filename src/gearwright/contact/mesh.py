"""Two toothed members on the sphere about their apex, as running needs to know them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, Protocol

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.traces.trace import Trace
from ..elements.bevel.bevel_gear import BevelGear
from ..elements.bevel.bevel_pair import BevelPair
from .search import crossing

Side = Literal["drive", "coast"]
"""Which flanks touch: those that push as the pinion turns positively about +z of its frame, or the other ones."""


_LOOKED_AT = 66  # cone distances among which a trace is seen to turn back; no usual one does so twice


class Flank(Protocol):
    """The flank of a tooth centred on azimuth 0, the same on both sides. Angles in radians.

    form_angle, face_angle   polar angles between which it can touch: from where it begins to the tip
    """

    @property
    def form_angle(self) -> float: ...
    @property
    def face_angle(self) -> float: ...
    def half_angle(self, polar: ArrayLike) -> Array:
        """Half the tooth's angular thickness about its axis (...) at polar angles (...)."""
        ...


@dataclass(frozen=True, kw_only=True)
class Member:
    """One toothed member. pitch_angle γ in radians; inner, outer   the cone distances its teeth lie between"""

    teeth: int
    pitch_angle: float
    flank: Flank
    trace: Trace
    inner: float
    outer: float

    def flank_points(self, distance: Array, polar: Array, sense: float, turn: ArrayLike = 0.0) -> Array:
        """Points (..., 3) of the first tooth's flank at cone distances and polar angles (...), the tooth turned.

        sense   1 for the flank on its counter-clockwise side, −1 for the other
        """
        azimuth = np.asarray(turn) + self.trace.turn(distance) + sense * self.flank.half_angle(polar)
        across = distance * np.sin(polar)
        return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), distance * np.cos(polar)], axis=-1)

    @cached_property
    def bends(self) -> Array:
        """Cone distances from the inner to the outer end between which the trace turns one way only."""
        distance = np.linspace(self.inner, self.outer, _LOOKED_AT)
        slope = self.trace.slope(distance)
        turning = np.flatnonzero(slope[:-1] * slope[1:] < 0.0)
        between = crossing(self.trace.slope, distance[turning], distance[turning + 1])
        return np.concatenate([[self.inner], between, [self.outer]])

    @property
    def turned(self) -> tuple[float, float]:
        """The least and the greatest turn of its teeth along the face, radians."""
        turns = self.trace.turn(self.bends)
        return float(turns.min()), float(turns.max())


@dataclass(frozen=True, kw_only=True)
class Mesh:
    """A pinion and the gear it drives, on axes at the shaft angle Σ, radians, with a common apex."""

    pinion: Member
    gear: Member
    shaft_angle: float

    @property
    def pitch(self) -> float:
        """The pinion's angular pitch, radians."""
        return 2.0 * np.pi / self.pinion.teeth


def mesh_of(pair: BevelPair) -> Mesh:
    """What runs of a bevel pair."""
    return Mesh(
        pinion=_member(pair.pinion), gear=_member(pair.gear), shaft_angle=float(np.radians(pair.shaft_angle))
    )  # fmt: skip


def _member(gear: BevelGear) -> Member:
    return Member(
        teeth=gear.teeth,
        pitch_angle=gear.pitch_cone_angle,
        flank=gear.bevel_teeth.on_spheres().tooth(gear.mean_distance),
        trace=gear.tooth_trace,
        inner=gear.inner_distance,
        outer=gear.cone_distance,
    )

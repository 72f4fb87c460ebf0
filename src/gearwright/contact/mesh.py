"""Two toothed members on the spheres about their apex, as running needs to know them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.crossing import crossing
from ..curves.traces.trace import Trace
from ..elements.bevel.bevel_gear import BevelGear
from ..elements.bevel.bevel_pair import BevelPair
from .flank import BevelFlank, Flank

Side = Literal["drive", "coast"]
"""Which flanks touch: those that push as the pinion turns positively about +z of its frame, or the other ones."""


_LOOKED_AT = 66  # cone distances among which a trace is seen to turn back; no usual one does so twice


@dataclass(frozen=True, kw_only=True)
class Member:
    """One toothed member. pitch_angle γ in radians.

    inner, outer   parameters v of the levels between which its teeth lie
    levels         λ of the levels r cos(θ − λ) = v; None: spheres r = v (see `Radial`)
    """

    teeth: int
    pitch_angle: float
    flank: Flank
    trace: Trace
    inner: float
    outer: float
    levels: float | None = None

    def level(self, polar: ArrayLike, distance: ArrayLike) -> Array:
        """v (...) of points at polar angles (...) and cone distances (...)."""
        return np.asarray(np.asarray(distance, float) * self._cosine(polar))

    def distance(self, polar: ArrayLike, level: ArrayLike) -> Array:
        """Cone distances (...) of points at polar angles (...) on levels (...)."""
        return np.asarray(np.asarray(level, float) / self._cosine(polar))

    def _cosine(self, polar: ArrayLike) -> Array:
        delta = np.asarray(polar, float)
        return np.ones_like(delta) if self.levels is None else np.cos(delta - self.levels)

    def flank_points(self, level: Array, polar: Array, sense: float, turn: ArrayLike = 0.0) -> Array:
        """Points (..., 3) of the first tooth's flank on levels and at polar angles (...), the tooth turned.

        sense   1 for the flank on its counter-clockwise side, −1 for the other
        """
        distance = self.distance(polar, level)
        azimuth = np.asarray(turn) + self.trace.turn(distance) + sense * self.flank.half_angle(polar, level)
        across = distance * np.sin(polar)
        return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), distance * np.cos(polar)], axis=-1)

    def height_room(self, polar: Array, level: ArrayLike) -> Array:
        """≥ 0 (...) between the foot of the flank and the tip: the lesser angle to them."""
        return np.minimum(self.flank.face_angle(level) - polar, polar - self.flank.form_angle(level))

    def room(self, polar: Array, distance: ArrayLike) -> Array:
        """≥ 0 (...) where the flank is: the least of the angles to its foot and tip and of the ways to its ends."""
        heights = self.height_room(polar, self.level(polar, distance))
        return np.minimum(heights, self.end_room(polar, distance))

    def end_room(self, polar: Array, distance: ArrayLike) -> Array:
        """≥ 0 (...) between its ends: the lesser way to them, over the outer cone distance."""
        level = self.level(polar, distance)
        return np.minimum(level - self.inner, self.outer - level) / self.outer

    @cached_property
    def heights(self) -> tuple[float, float]:
        """The least and the greatest polar angle of the flank."""
        levels = np.linspace(self.inner, self.outer, _LOOKED_AT)
        return float(self.flank.form_angle(levels).min()), float(self.flank.face_angle(levels).max())

    @cached_property
    def reach(self) -> tuple[float, float]:
        """The least and the greatest cone distance of the flank."""
        polar = np.clip([*self.heights, self.pitch_angle], *self.heights)
        return float(self.distance(polar, self.inner).min()), float(self.distance(polar, self.outer).max())

    @cached_property
    def pitch_ends(self) -> Array:
        """Cone distances (2,) of the ends on the pitch cone."""
        return self.distance(self.pitch_angle, np.array([self.inner, self.outer]))

    @cached_property
    def bends(self) -> Array:
        """Cone distances from end to end of the pitch line between which the trace turns one way only."""
        distance = np.linspace(self.pitch_ends[0], self.pitch_ends[1], _LOOKED_AT)
        slope = self.trace.slope(distance)
        turning = np.flatnonzero(slope[:-1] * slope[1:] < 0.0)
        between = crossing(self.trace.slope, distance[turning], distance[turning + 1])
        return np.concatenate([distance[:1], between, distance[-1:]])

    @property
    def turned(self) -> tuple[float, float]:
        """The least and the greatest turn of its teeth along the pitch line, radians."""
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

    @property
    def is_uniform(self) -> bool:
        """Whether all spheres about the apex see the same: straight teeth that do not vary."""
        return not any(
            one.flank.varies or np.any(one.trace.slope(np.linspace(one.pitch_ends[0], one.pitch_ends[1], _LOOKED_AT)))
            for one in (self.pinion, self.gear)
        )


def mesh_of(pair: BevelPair) -> Mesh:
    """What runs of a bevel pair."""
    return Mesh(
        pinion=_member(pair.pinion), gear=_member(pair.gear), shaft_angle=float(np.radians(pair.shaft_angle))
    )  # fmt: skip


def _member(gear: BevelGear) -> Member:
    teeth = gear.bevel_teeth
    return Member(
        teeth=gear.teeth,
        pitch_angle=gear.pitch_cone_angle,
        flank=BevelFlank(teeth=teeth),
        trace=gear.tooth_trace,
        inner=teeth.level("inner"),
        outer=teeth.level("outer"),
        levels=teeth.ends.levels,
    )

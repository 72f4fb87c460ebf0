"""Contact of two flanks on a sphere about the apex, solved for: a common point with a common tangent."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from gearwright.boundary.faces import Patch
from gearwright.curves.curve import Curve, Mapped, turn
from gearwright.curves.octoid import Octoid
from gearwright.curves.spherical_involute import SphericalInvolute
from gearwright.elements.bevel.bevel_gear import BevelGear
from gearwright.elements.bevel.bevel_pair import BevelPair

_STEP = 1e-6
_STEPS = _STEP * np.eye(3)
_ENOUGH = 12
_NEAR = 0.02  # radians: flanks further apart do not touch
_OFF_CUSP = 1e-3  # the involute has no tangent at its cusp


def involute_patches(gear: BevelGear) -> list[Patch]:
    """The two flanks of the first tooth, above the base cone or, of octoids, above their cusp."""
    return [patch for patch in gear.boundary.patches if isinstance(unmapped(patch.curve), SphericalInvolute | Octoid)]


def unmapped(curve: Curve) -> Curve:
    while isinstance(curve, Mapped):
        curve = curve.curve
    return curve


class Touchable(Protocol):
    """A placed flank on the unit sphere, its parameter from 0 to 1."""

    def point(self, u: float, extra_turn: float = 0.0) -> np.ndarray: ...
    def points(self, u: np.ndarray) -> np.ndarray: ...
    def tangent(self, u: float, extra_turn: float = 0.0) -> np.ndarray: ...


@dataclass(frozen=True)
class Flank:
    """One flank of a placed gear where it meets the sphere at a fraction of the face width."""

    patch: Patch
    seat: np.ndarray
    level: float
    image: float

    def point(self, u: float, extra_turn: float = 0.0) -> np.ndarray:
        at = self.patch.point(np.array(u), np.array(self.level))
        return self.seat @ turn(self.image + extra_turn, 3) @ (at / np.linalg.norm(at))

    def points(self, u: np.ndarray) -> np.ndarray:
        at = self.patch.point(u, np.full(u.shape, self.level))
        return at / np.linalg.norm(at, axis=-1, keepdims=True) @ (self.seat @ turn(self.image, 3)).T

    def tangent(self, u: float, extra_turn: float = 0.0) -> np.ndarray:
        along = self.patch.partials(np.array(u), np.array(self.level))[0]
        return self.seat @ turn(self.image + extra_turn, 3) @ (along / np.linalg.norm(along))

    def outward(self, u: float) -> np.ndarray:
        """Outward normal within the sphere."""
        point, tangent = self.point(u), self.tangent(u)
        normal = self.seat @ turn(self.image, 3) @ self.patch.area_vector(np.array(u), np.array(self.level))
        across = np.cross(point, tangent)
        return across * np.sign(across @ normal)


@dataclass(frozen=True)
class Contact:
    """Where two flanks touch: fractions on each, and the turn of the gear beyond its placement that it takes."""

    side: int
    u_pinion: float
    u_gear: float
    extra_turn: float


def contacts(pair: BevelPair, placements: tuple[np.ndarray, np.ndarray], level: float = 1.0) -> Iterator[Contact]:
    """All contacts of involutes with each other where pinion and gear are placed so.

    Side 0 or 1 is the pinion's flank; points where the bodies would lie on one side are none.
    """
    angle = pair.pinion.pitch_cone_angle
    pitch_line = np.array([np.sin(angle), 0.0, np.cos(angle)])
    reach = 2.0 * 2.0 * np.pi * np.sin(angle) / pair.pinion.teeth
    near = [
        [(side, flank) for side, flank in _flanks(gear, seat[:3, :3], level) if _distance(flank, pitch_line) < reach]
        for gear, seat in zip((pair.pinion, pair.gear), placements, strict=True)
    ]
    for side, pinion in near[0]:
        for _, gear in near[1]:
            found = touching(pinion, gear)
            if found is not None and pinion.outward(found[0]) @ gear.outward(found[1]) < 0.0:
                yield Contact(side, *found)


def _flanks(gear: BevelGear, seat: np.ndarray, level: float) -> Iterator[tuple[int, Flank]]:
    for side, patch in enumerate(involute_patches(gear)):
        for k in range(gear.teeth):
            yield side, Flank(patch, seat, level, 2.0 * np.pi * k / gear.teeth)


def _distance(flank: Flank, direction: np.ndarray) -> float:
    return float(np.linalg.norm(flank.point(0.5) - direction))


def touching(pinion: Touchable, gear: Touchable) -> tuple[float, float, float] | None:
    """(u, u, extra turn) of a contact on both flanks, by Newton's method; None where they have none."""
    u = np.linspace(0.0, 1.0, 41)
    distance = np.linalg.norm(pinion.points(u)[:, None] - gear.points(u)[None], axis=-1)
    if distance.min() > _NEAR:
        return None
    i, j = np.unravel_index(np.argmin(distance), distance.shape)
    x = np.array([*np.clip([u[i], u[j]], _OFF_CUSP, 1.0 - _OFF_CUSP), 0.0])
    for _ in range(_ENOUGH):
        value = _mismatch(pinion, gear, x)
        slope = [(_mismatch(pinion, gear, x + h) - _mismatch(pinion, gear, x - h)) / (2.0 * _STEP) for h in _STEPS]
        step = np.linalg.lstsq(np.transpose(slope), value, rcond=None)[0]
        x = x - np.clip(step, -0.2, 0.2)
        if np.abs(step).max() < 1e-15:
            break
        if np.any(np.abs(x[:2] - 0.5) > 0.5 - _OFF_CUSP):
            return None
    touches = np.abs(_mismatch(pinion, gear, x)).max() < 1e-13
    return tuple(x) if touches else None


def _mismatch(pinion: Touchable, gear: Touchable, x: np.ndarray) -> np.ndarray:
    """Difference of the points (3) and triple product of point and both tangents (1)."""
    point = pinion.point(x[0])
    volume = point @ np.cross(pinion.tangent(x[0]), gear.tangent(x[1], x[2]))
    return np.append(point - gear.point(x[1], x[2]), volume)

"""Placed flanks of a pair on parallel axes, turned until they touch: points and polygons, no formula of meshing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from shapely import Polygon, affinity

from gearwright.boundary.faces import Patch
from gearwright.curves.curve import Curve, Mapped
from gearwright.curves.involute import Involute
from gearwright.curves.line import Line
from gearwright.curves.relieved_involute import RelievedInvolute
from gearwright.elements.cylindrical.gear_pair import GearPair
from gearwright.elements.cylindrical.rack import Rack

_SAMPLES = np.linspace(0.0, 1.0, 33)


def _unmapped(curve: Curve) -> Curve:
    while isinstance(curve, Mapped):
        curve = curve.curve
    return curve


def flank_patches(member) -> list[Patch]:
    """Flanks of one tooth of a gear, of every tooth of a rack, fillets and radial feet left out."""
    if isinstance(member, Rack):
        lines = [patch for patch in member.boundary.patches if isinstance(_unmapped(patch.curve), Line)]
        ends = [(patch, patch.curve.start, patch.curve.end) for patch in lines]
        return [patch for patch, a, b in ends if min(abs(a - b)) > 1e-6 * member.normal_module]
    kinds = (Involute, RelievedInvolute)
    return [patch for patch in member.boundary.patches if isinstance(_unmapped(patch.curve), kinds)]


@dataclass(frozen=True)
class PlacedFlank:
    """One flank in the transverse plane at a fraction `level` of its patch's width, in place.

    centre   the gear's axis (2,), or None for a rack, which moves along y
    """

    patch: Patch
    level: float
    placement: np.ndarray
    image: float

    def points(self, u) -> np.ndarray:
        """(..., 2) at fractions u."""
        at = self.patch.point(np.asarray(u, float), np.full(np.shape(u), self.level))[..., :2]
        c, s = np.cos(self.image), np.sin(self.image)
        turned = at @ np.array([[c, s], [-s, c]])
        return turned @ self.placement[:2, :2].T + self.placement[:2, 3]

    @cached_property
    def middle(self) -> np.ndarray:
        return self.points(0.5)

    @cached_property
    def samples(self) -> np.ndarray:
        return self.points(_SAMPLES)

    @cached_property
    def outward(self) -> np.ndarray:
        """Of the solid, in the middle of the flank, in the plane."""
        normal = self.patch.area_vector(np.array(0.5), np.array(self.level))[:2]
        c, s = np.cos(self.image), np.sin(self.image)
        return self.placement[:2, :2] @ (np.array([[c, -s], [s, c]]) @ normal)


@dataclass(frozen=True)
class Contact:
    """Two flanks that touch when the mate is moved by `play`, at fractions of their curves; `inside` both or at an end.

    side   +1 where the mate moves counter-clockwise, or along +y, towards the pinion's flank
    """

    side: int
    play: float
    u_pinion: float
    u_gear: float
    inside: bool
    point: np.ndarray
    flanks: tuple[PlacedFlank, PlacedFlank]


class Running:
    """A pair whose mate is free to move, in the transverse plane at a fraction of the face width (its lower half)."""

    def __init__(self, pair: GearPair, level: float = 0.0):
        self.pair, self.level = pair, level
        self.rack = isinstance(pair.gear, Rack)
        self.pitch = (
            np.pi * pair.gear.normal_module / np.cos(np.radians(pair.helix_angle or 0.0)) if self.rack else None
        )

    def contacts(self, turn: float) -> list[Contact]:
        """The first touch of every two flanks near each other, with the pinion turned by so many of its pitches."""
        seats = self.pair.placements(turn * 360.0 / self.pair.teeth[0])
        own, other = (list(self._flanks(m, s)) for m, s in zip((self.pair.pinion, self.pair.gear), seats, strict=True))
        found = [self._touch(a, b, seats[1]) for a in own for b in other if self._may_touch(a, b)]
        return [contact for contact in found if contact is not None]

    def plays(self, turn: float) -> tuple[float, float]:
        """How far the mate may move clockwise (or along −y), and counter-clockwise, until it touches; radians."""
        found = self.contacts(turn)
        return (
            max(one.play for one in found if one.side < 0),
            min(one.play for one in found if one.side > 0),
        )

    def contact_of(self, found: Contact, turn: float) -> Contact | None:
        """The same two flanks' touch at another turn."""
        seats = self.pair.placements(turn * 360.0 / self.pair.teeth[0])
        own, other = (replace(one, placement=seat) for one, seat in zip(found.flanks, seats, strict=True))
        return self._touch(own, other, seats[1])

    def _flanks(self, member, seat) -> Iterator[PlacedFlank]:
        for patch in flank_patches(member):
            if isinstance(member, Rack):
                yield PlacedFlank(patch, self.level, seat, 0.0)
                continue
            if patch.point(np.array(0.5), np.array(0.0))[2] > 1e-9 * member.face_width:
                continue  # the upper half of herringbone teeth
            for k in range(member.teeth):
                yield PlacedFlank(patch, self.level, seat, 2.0 * np.pi * k / member.teeth)

    def _may_touch(self, own, other) -> bool:
        reach = 3.5 * self.pair.pinion.normal_module / np.cos(np.radians(self.pair.helix_angle or 0.0))
        pitch_point = np.array([self.pair.mesh.working_radius, 0.0])
        close = all(np.linalg.norm(one.middle - pitch_point) < reach for one in (own, other))
        return close and own.outward @ other.outward < 0.0

    def _coordinates(self, points, seat) -> tuple[np.ndarray, np.ndarray]:
        """(what a motion of the mate keeps, what it adds to) of points (..., 2)."""
        if self.rack:
            return points[..., 0], points[..., 1]
        off = points - seat[:2, 3]
        away = -off if self.pair.kind != "internal" else off
        azimuth = np.arctan2(away[..., 1], away[..., 0])
        return np.hypot(off[..., 0], off[..., 1]), azimuth

    def _touch(self, own, other, seat) -> Contact | None:
        kept, _ = self._coordinates(other.points(np.array([0.0, 1.0])), seat)
        first, last = self._common(own, kept, seat)
        if first is None:
            return None
        across = (
            np.array([0.0, 1.0])
            if self.rack
            else np.array([[0.0, -1.0], [1.0, 0.0]]) @ (other.points(0.5) - seat[:2, 3])
        )
        side = 1 if other.outward @ across > 0.0 else -1

        def play(u):
            at, value = self._coordinates(own.points(u), seat)
            v = self._fraction(other, at, seat)
            return value - self._coordinates(other.points(v), seat)[1]

        u, inside = _least(lambda x: side * play(x), first, last)
        value = float(play(np.array(u)))
        quarter = (self.pitch if self.rack else 2.0 * np.pi / self.pair.teeth[1]) / 4.0
        if abs(value) > quarter:
            return None
        at, _ = self._coordinates(own.points(np.array(u)), seat)
        v = float(self._fraction(other, at, seat))
        return Contact(side, value, u, v, inside, own.points(np.array(u)), (own, other))

    def _common(self, own, kept, seat):
        """Fractions of a flank between which it is as far from the mate's axis as the mate's flank reaches."""
        at, _ = self._coordinates(own.samples, seat)
        reached = (at >= min(kept)) & (at <= max(kept))
        if not reached.any():
            return None, None
        ends = [0.0, 1.0]
        for one in kept:
            crossed = np.flatnonzero(np.diff(at > one))
            if crossed.size:
                ends.append(self._fraction(own, np.array(one), seat, start=_SAMPLES[crossed[0]]))
        ends = sorted(float(one) for one in ends)
        pieces = [(a, b) for a, b in pairwise(ends) if b > a]
        middles = [float(self._coordinates(own.points((a + b) / 2.0), seat)[0]) for a, b in pieces]
        good = [piece for piece, middle in zip(pieces, middles, strict=True) if min(kept) <= middle <= max(kept)]
        return (good[0][0], good[-1][1]) if good else (None, None)

    def _fraction(self, flank, kept, seat, start=None):
        """Fractions of a flank at which it is so far from the mate's axis, by secants."""
        at, _ = self._coordinates(flank.samples, seat)
        if start is None:
            start = np.interp(kept, at, _SAMPLES) if at[-1] > at[0] else np.interp(kept, at[::-1], _SAMPLES[::-1])
        old, new = start, start + 1e-3
        value = self._coordinates(flank.points(old), seat)[0] - kept
        for _ in range(7):
            again = self._coordinates(flank.points(new), seat)[0] - kept
            rise = np.where(again == value, 1.0, again - value)
            old, new, value = new, new - np.where(again == value, 0.0, again * (new - old) / rise), again
        return np.clip(new, 0.0, 1.0)


def _least(function, first: float, last: float) -> tuple[float, bool]:
    """Where a function of one variable is least, and whether inside the interval."""
    u = np.linspace(first, last, 41)
    for _ in range(13):
        i = int(np.argmin(function(u)))
        u = np.linspace(u[max(0, i - 1)], u[min(len(u) - 1, i + 1)], 9)
    edge, found = 1e-6 * (last - first), float(u[4])
    return found, bool(first + edge < found < last - edge)


def region(member, chords: int = 24) -> Polygon:
    """The transverse section of a member at z = 0 as a polygon with so many chords a curve."""
    loops = []
    for loop in member.profile.loops:
        period = np.concatenate([_chords(curve, chords) for curve in loop.curves])
        turns = loop.sense * 2.0 * np.pi * np.arange(loop.copies) / loop.copies
        c, s = np.cos(turns)[:, None], np.sin(turns)[:, None]
        x, y = period[:, 0], period[:, 1]
        loops.append(np.stack([(c * x - s * y).ravel(), (s * x + c * y).ravel()], axis=-1))
    return Polygon(loops[0], loops[1:])


def _chords(curve: Curve, chords: int) -> np.ndarray:
    """Points (n, 2) of a curve, its end left out."""
    n = 1 if isinstance(_unmapped(curve), Line) else chords
    return curve.point(np.linspace(*curve.interval, n, endpoint=False))


def placed(polygon: Polygon, matrix: np.ndarray) -> Polygon:
    """A polygon moved by a rigid motion (4, 4) of its plane."""
    return affinity.affine_transform(polygon, [*matrix[0, :2], *matrix[1, :2], *matrix[:2, 3]])


def shared(pair: GearPair, turn: float, chords: int = 24) -> float:
    """Area that the sections of both members at z = 0 share, the pinion turned by so many pitches."""
    seats = pair.placements(turn * 360.0 / pair.teeth[0])
    own, other = (
        placed(region(member, chords), seat) for member, seat in zip((pair.pinion, pair.gear), seats, strict=True)
    )
    return float(own.intersection(other).area)

"""Faces on cylinders, cones and spheres whose edges run anyhow: their curves in azimuth and height, and seams.

A face once around the axis must meet itself along a seam, from a corner of one loop straight to the other, which is cut
there; or to the apex or pole that it holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from ....arrays import Array
from ....boundary.edge import Edge
from .bases import COARSEST, Basis
from .elementary import SAME
from .faces import line_on_surface
from .splines import spline_curve_2d
from .surfaces import Round, Sphere

_SAMPLES = np.linspace(0.0, 1.0, 33)
_TURN = 2.0 * np.pi
_AT_CORNER = 1e-9
"""Of an edge: a cut nearer to its end than that is the end."""

_NEWTON = 8


class Ref(NamedTuple):
    """A part of an image of an edge, from fraction first to last, as a loop runs along it or against it."""

    edge: Edge
    image: int
    reverse: bool
    first: float = 0.0
    last: float = 1.0

    def points(self, fractions: Array) -> Array:
        """Points (n, 3) at the edge's own fractions."""
        found = self.edge.curve.point(self.edge.curve.parameter(fractions))
        return self.edge.pattern.image(self.image).points(found) if self.image % self.edge.pattern.order else found

    @property
    def way(self) -> Array:
        """Fractions from where the loop enters to where it leaves."""
        along = self.first + _SAMPLES * (self.last - self.first)
        return along[::-1] if self.reverse else along


@dataclass(frozen=True, kw_only=True)
class Track:
    """A part of an edge on the surface: azimuths and heights (33,) along its way, azimuths without jumps."""

    ref: Ref
    azimuths: Array
    heights: Array

    def parameters(self, surface: Round, fractions: Array) -> Array:
        """(U, V) (n, 2) at the edge's fractions, near the azimuths known."""
        found = surface.chart(self.ref.points(fractions))
        way, azimuths = (a[::-1] if self.ref.reverse else a for a in (self.ref.way, self.azimuths))
        near = np.interp(fractions, way, azimuths)
        found[:, 0] += _TURN * np.round((near - found[:, 0]) / _TURN)
        return found

    def shifted(self, turns: float) -> Track:
        return replace(self, azimuths=self.azimuths + _TURN * turns)


@dataclass(frozen=True, kw_only=True)
class Tracks:
    """A loop on the surface. winding   how often it goes around the axis, by azimuth"""

    tracks: tuple[Track, ...]

    @property
    def winding(self) -> int:
        return round(float(self.tracks[-1].azimuths[-1] - self.tracks[0].azimuths[0]) / _TURN)

    def shifted(self, turns: float) -> Tracks:
        return Tracks(tracks=tuple(track.shifted(turns) for track in self.tracks))


def tracked(surface: Round, loop: Sequence[Ref]) -> Tracks:
    """A loop followed around the axis, from the azimuth of its start in (−π, π]."""
    tracks: list[Track] = []
    for ref, points in zip(loop, _points(loop), strict=True):
        azimuths, heights = surface.chart(points).T
        azimuths = np.unwrap(azimuths)
        if tracks:
            azimuths += _TURN * np.round((tracks[-1].azimuths[-1] - azimuths[0]) / _TURN)
        tracks.append(Track(ref=ref, azimuths=azimuths, heights=heights))
    return Tracks(tracks=tuple(tracks))


def _points(loop: Sequence[Ref]) -> Iterator[Array]:
    """Points (33, 3) along the way of each part; images of one are turned, not found again."""
    known: dict[Ref, Array] = {}
    for ref in loop:
        first = ref._replace(image=0)
        if first not in known:
            known[first] = first.points(first.way)
        yield ref.edge.pattern.image(ref.image).points(known[first]) if ref.image else known[first]


@dataclass(frozen=True, kw_only=True)
class Seam:
    """Where a face meets itself: from the start of its first loop to that of its second, or to the pole (3,)."""

    first: Array
    last: Array
    to_pole: bool


@dataclass(frozen=True, kw_only=True)
class Layout:
    """A face on a surface turned so that no edge crosses azimuth 0 or 2π.

    loops   those around the axis first, each beginning where a seam ends
    seam    None where no loop goes around
    """

    surface: Round
    loops: tuple[Tracks, ...]
    seam: Seam | None

    @property
    def around(self) -> tuple[Tracks, ...]:
        """The loops around the axis."""
        return tuple(loop for loop in self.loops if loop.winding)


def layout(surface: Round, loops: Sequence[Sequence[Ref]]) -> Layout:
    """How a face with such loops lies on its surface."""
    found = [tracked(surface, loop) for loop in loops]
    around = sorted((loop for loop in found if loop.winding), key=lambda loop: -len(loop.tracks))
    if not around:
        ends = np.concatenate([track.azimuths for track in found[0].tracks])
        surface = replace(surface, frame=surface.frame.turned((ends.min() + ends.max()) / 2.0 - np.pi))
        return Layout(surface=surface, loops=tuple(_inside(tracked(surface, loop)) for loop in loops), seam=None)
    first = _from_nearest_corner(surface, around[0], around[1:])
    start = first.tracks[0].ref
    corner = start.points(start.way[:1])[0]
    azimuth = float(surface.chart(corner)[0])
    surface = replace(surface, frame=surface.frame.turned(azimuth))
    if len(around) == 2:
        second = _cut_open(surface, [track.ref for track in around[1].tracks])
        entry = second[0].points(second[0].way[:1])[0]
        own = [[track.ref for track in first.tracks], second]
    else:
        entry = surface.frame.world(_pole(surface))
        own = [[track.ref for track in first.tracks]]
    whole = [_begun(tracked(surface, loop)) for loop in own]
    if len(whole) == 2:
        # it starts where the first one ends
        whole[1] = whole[1].shifted(round((whole[0].tracks[-1].azimuths[-1] - whole[1].tracks[0].azimuths[0]) / _TURN))
    holes = [_inside(tracked(surface, [t.ref for t in loop.tracks])) for loop in found if not loop.winding]
    seam = Seam(first=corner, last=entry, to_pole=len(around) == 1)
    return Layout(surface=surface, loops=(*whole, *holes), seam=seam)


def _pole(surface: Round) -> Array:
    _, z = surface.meridian(np.array(surface.pole))
    return np.array([0.0, 0.0, float(z)])


def _inside(loop: Tracks) -> Tracks:
    """The loop with its middle between 0 and 2π."""
    azimuths = np.concatenate([track.azimuths for track in loop.tracks])
    return loop.shifted(-float(np.floor((azimuths.min() + azimuths.max()) / 2.0 / _TURN)))


def _begun(loop: Tracks) -> Tracks:
    """The loop from 0 to 2π, or back."""
    return loop.shifted((0.0 if loop.winding > 0 else 1.0) - round(loop.tracks[0].azimuths[0] / _TURN))


def _from_nearest_corner(surface: Round, loop: Tracks, others: Sequence[Tracks]) -> Tracks:
    """The loop begun at the corner nearest to the other loop, or to the pole: the seam is free from there."""
    target = surface.chart(others[0].tracks[0].ref.points(np.array([0.5])))[0, 1] if others else surface.pole
    corners = [surface.chart(track.ref.points(track.ref.way[:1]))[0, 1] for track in loop.tracks]
    begin = int(np.argmin(np.abs(np.array(corners) - target)))
    return Tracks(tracks=(*loop.tracks[begin:], *loop.tracks[:begin]))


def _cut_open(surface: Round, loop: Sequence[Ref]) -> list[Ref]:
    """The loop begun where it passes azimuth 0, an edge cut there unless it is a corner."""
    for number, track in enumerate(tracked(surface, loop).tracks):
        turns = track.azimuths / _TURN
        level = np.floor(max(turns[0], turns[-1]) + SAME) * _TURN
        low, high = sorted((track.azimuths[0], track.azimuths[-1]))
        if not low - SAME <= level <= high + SAME:
            continue
        ref = track.ref
        at = _passing(surface, track, level)
        rest = [*loop[number + 1 :], *loop[:number]]
        if abs(at - ref.way[0]) < _AT_CORNER:
            return [ref, *rest]
        if abs(at - ref.way[-1]) < _AT_CORNER:
            return [*rest, ref]
        before, after = ref._replace(first=ref.first, last=at), ref._replace(first=at, last=ref.last)
        if ref.reverse:
            before, after = after, before
        return [after, *rest, before]
    raise ValueError("a loop around the axis passes every azimuth")


def _passing(surface: Round, track: Track, level: float) -> float:
    """The edge's fraction at which it has an azimuth: from the samples, by secants."""
    order = np.argsort(track.azimuths)
    at = float(np.interp(level, track.azimuths[order], track.ref.way[order]))
    step = 1e-3
    for _ in range(_NEWTON):
        azimuths = track.parameters(surface, np.clip(np.array([at - step, at, at + step]), 0.0, 1.0))[:, 0]
        rate = (azimuths[2] - azimuths[0]) / (np.clip(at + step, 0.0, 1.0) - np.clip(at - step, 0.0, 1.0))
        at = float(np.clip(at + (level - azimuths[1]) / rate, 0.0, 1.0))
        step = max(step / 8.0, 1e-6)
    return at


@dataclass(frozen=True, kw_only=True, eq=False)
class SurfaceCurve:
    """A part of an edge in a surface's parameters: a spline of poles (n, 2), off by so much (length) in space."""

    basis: Basis
    poles: Array
    error: float

    def made(self, first: float, last: float) -> Any:
        """It in Open CASCADE, its parameter from first to last."""
        if self.basis is COARSEST:
            return line_on_surface(first, last, *self.poles)
        return spline_curve_2d(self.basis, self.poles, first, last)

    def moved(self, along: float) -> SurfaceCurve:
        """The same curve, moved along U."""
        return replace(self, poles=self.poles + np.array([along, 0.0]))


_SAME_CURVE = 1e-11
"""Radians, and of the height: tracks that differ by less are one."""


def move_between(one: Track, other: Track) -> float | None:
    """How far along U another track is the same as one; None where it is not."""
    move = float(other.azimuths[0] - one.azimuths[0])
    turned = np.max(np.abs(other.azimuths - one.azimuths - move)) > _SAME_CURVE
    if turned or np.max(np.abs(other.heights - one.heights)) > _SAME_CURVE * np.abs(one.heights).max():
        return None
    return move


def on_surface(surface: Round, track: Track, tolerance: float) -> SurfaceCurve:
    """A part of an edge in the surface's parameters, within a tolerance (length) in space."""
    ref, basis = track.ref, COARSEST

    def exact(fractions: Array) -> Array:
        return track.parameters(surface, ref.first + fractions * (ref.last - ref.first))

    while True:
        poles, wanted = basis.poles(exact(basis.nodes)), exact(basis.checks)
        found = basis.values(poles, basis.checks)
        errors = np.linalg.norm(surface.point(found) - surface.point(wanted), axis=-1)
        if errors.max() <= tolerance:
            return SurfaceCurve(basis=basis, poles=poles, error=float(errors.max()))
        basis = basis.finer(errors > tolerance)


def sphere_for(surface: Sphere, loops: Sequence[Sequence[Ref]]) -> Sphere:
    """The sphere with its poles across its frame's z where one loop is the border of a face in the upper half.

    Poles and the half circle of azimuth 0 are outside the face then, which holds +z, and it needs no seam. A face with
    a hole about z keeps its axis: circles about it are lines in its parameters.
    """
    heights = [surface.frame.local(points)[:, 2].min() for loop in loops for points in _points(loop)]
    if len(loops) > 1 or min(heights) <= _HALF * surface.radius:
        return surface
    axes = surface.frame.axes
    turned = np.stack([-axes[:, 2], axes[:, 1], axes[:, 0]], axis=1)
    return replace(surface, frame=replace(surface.frame, axes=turned))


_HALF = 1e-3
"""Sine of the least angle between a face and the circle across the axis on which the turned poles are."""

"""Coaxial pieces that make up a gear: its toothed ring, revolved steps, a web with holes, a hub with a keyway."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from ...boundary.gluing import Joint
from ...curves.arc import Arc
from ...curves.line import lines_through
from ...motions.ends import between
from ...motions.revolution import FULL_TURN, Revolution
from ...motions.straight import Straight
from ...sections.loop import Loop
from ...sections.plane import Section
from ...solids.composite import Composite
from ...solids.solid import Solid
from ...solids.swept import Swept
from .keyway import KeyedBore

_SAME = 1e-9  # of the body's height: levels so near to each other were meant to be one


@dataclass(frozen=True, kw_only=True)
class Zone:
    """A ring of the body: from one radius in to another, everywhere from one z to another."""

    outer: float
    inner: float
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class HoleCircle:
    """Round holes of a radius, evenly spaced on a circle of another radius about the origin, the first one on +x."""

    count: int
    radius: float
    circle: float

    @property
    def innermost(self) -> float:
        return self.circle - self.radius

    @property
    def outermost(self) -> float:
        return self.circle + self.radius

    def loops(self) -> tuple[Loop, ...]:
        """The holes' outlines, clockwise."""
        angles = 2.0 * np.pi * np.arange(self.count) / self.count
        centres = (self.circle * np.stack([np.cos(angles), np.sin(angles)], axis=1)).tolist()
        return tuple(circle(self.radius, -1, (x, y)) for x, y in centres)


@dataclass(frozen=True)
class Piece:
    """A piece and the names of the faces by which it is glued to what is around it and to what is inside it."""

    solid: Solid
    outer_wall: str = "loop 1.1"
    inner_wall: str = "loop 2"


@dataclass(frozen=True)
class _Feature:
    """What a piece has that is no surface of revolution, within two radii of one of the zones.

    build   the pieces between an outer (None: the teeth) and an inner radius (0: none), from the outside in
    """

    outer: float
    inner: float
    zone: int
    build: Callable[[float | None, float], Sequence[Piece]]


def zones(bounds: Sequence[tuple[float, tuple[float, float]]], inner: float) -> tuple[Zone, ...]:
    """Zones from outer radii with heights (low, high), from the outside in, down to the bore's radius.

    Those of the same height are one; levels that differ by rounding alone are the same.
    """
    levels: list[float] = []
    found: list[Zone] = []
    for k, (outer, heights) in enumerate(bounds):
        low, high = (_snapped(level, levels) for level in heights)
        levels += [low, high]
        within = bounds[k + 1][0] if k + 1 < len(bounds) else inner
        if found and (low, high) == (found[-1].low, found[-1].high):
            found[-1] = replace(found[-1], inner=within)
        else:
            found.append(Zone(outer=outer, inner=within, low=low, high=high))
    return tuple(found)


def _snapped(level: float, known: Sequence[float]) -> float:
    size = max(map(abs, known), default=0.0)
    return next((other for other in known if abs(level - other) <= _SAME * size), level)


def assembled(
    ring: Callable[[float | None], Sequence[Piece]],
    body: Sequence[Zone],
    holes: HoleCircle | None,
    keyed: KeyedBore | None,
) -> Solid:
    """The gear of a toothed ring, zones inside it, holes in the zone they lie in, and a keyway of the innermost one.

    ring   the pieces that reach from the teeth to a round hole of a radius (None: full), from the outside in
    """
    features = [_Feature(body[0].outer, body[0].outer, 0, lambda _, inner: ring(inner or None))]
    if holes is not None:
        features.append(_web(holes, body))
    if keyed is not None:
        features.append(_hub(keyed, body))
    pieces: list[Piece] = []
    outer: float | None = None
    for feature, following in zip(features, [*features[1:], None], strict=True):
        inner, next_outer = _cuts(feature, following, body)
        pieces += feature.build(outer, inner)
        if next_outer != inner:
            pieces.append(_step(inner, body[-1].inner if next_outer is None else next_outer, body))
        outer = next_outer
    if len(pieces) == 1:
        return pieces[0].solid
    joints = (
        Joint(first=k, first_faces=(a.inner_wall,), second=k + 1, second_faces=(b.outer_wall,))
        for k, (a, b) in enumerate(pairwise(pieces))
    )
    return Composite(pieces=tuple(piece.solid for piece in pieces), joints=tuple(joints))


def _cuts(feature: _Feature, following: _Feature | None, body: Sequence[Zone]) -> tuple[float, float | None]:
    """The radii down to which a feature's piece reaches, and from which on the next feature's does.

    They differ where a revolved step lies between; None for the latter where it reaches down to the bore.
    """
    zone = body[feature.zone]
    if following is not None and following.zone == feature.zone:
        cut = (feature.inner + following.outer) / 2.0
        return cut, cut
    if following is None and feature.zone + 1 == len(body):
        return zone.inner, zone.inner
    above = (min(feature.inner, zone.outer) + zone.inner) / 2.0
    return above, None if following is None else (body[following.zone].outer + following.outer) / 2.0


def _web(holes: HoleCircle, body: Sequence[Zone]) -> _Feature:
    where = next(k for k, zone in enumerate(body) if zone.inner <= holes.innermost)

    def build(outer: float | None, inner: float) -> Sequence[Piece]:
        within = (circle(inner, -1),) if inner else ()
        return [Piece(_prism(outer, body[where], (*within, *holes.loops())))]

    return _Feature(holes.outermost, holes.innermost, where, build)


def _hub(keyed: KeyedBore, body: Sequence[Zone]) -> _Feature:
    def build(outer: float | None, _: float) -> Sequence[Piece]:
        return [Piece(_prism(outer, body[-1], (keyed.loop(),)))]

    return _Feature(keyed.corner_radius, keyed.radius, len(body) - 1, build)


def _prism(outer: float | None, zone: Zone, holes: Sequence[Loop]) -> Swept:
    section = Section(loops=(circle(outer or zone.outer, 1), *holes))
    return Swept(section=section, motion=Straight(), ends=between(zone.low, zone.high))


def _step(outer: float, inner: float, body: Sequence[Zone]) -> Piece:
    """The zones between two radii, revolved; the first curve of the section is its outer wall."""
    within = [zone for zone in body if zone.inner < outer and zone.outer > inner]
    first, last = within[0], within[-1]
    risers = list(pairwise(within))
    tops = [(a.inner, z) for a, b in risers if a.high != b.high for z in (a.high, b.high)]
    bottoms = [(a.inner, z) for a, b in reversed(risers) if a.low != b.low for z in (b.low, a.low)]
    start = (outer, first.low)
    corners = [start, (outer, first.high), *tops, (inner, last.high), (inner, last.low), *bottoms, start]
    section = Section(loops=(Loop(curves=tuple(lines_through(corners))),))
    swept = Swept(section=section, motion=Revolution(), ends=between(-FULL_TURN, 0.0))
    return Piece(swept, inner_wall=f"loop 1.{len(tops) + 3}")


def circle(radius: float, sense: int, centre: tuple[float, float] = (0.0, 0.0)) -> Loop:
    """A whole circle, counter-clockwise for sense +1."""
    return Loop(curves=(Arc(radius=radius, centre=centre, interval=(0.0, sense * FULL_TURN)),))

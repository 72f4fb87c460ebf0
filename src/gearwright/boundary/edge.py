"""Vertices and edges: what faces share, so that no two faces can disagree about their border."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.curve import Curve, along
from ..motions.ends import End, Ends
from ..motions.motion import Motion
from .pattern import ALONE, Pattern

_POINT = 1e-13  # of the distance from the origin, within which a curve is a point


@dataclass(frozen=True, kw_only=True, eq=False)
class Vertex:
    """A named corner; with a pattern it stands for all its images. On the axis it has only itself."""

    name: str
    position: Array
    pattern: Pattern = ALONE


@dataclass(frozen=True, kw_only=True, eq=False)
class Edge:
    """A named boundary curve in space with its end vertices, for all images of a pattern.

    curve      from the start vertex to the end vertex
    end_turn   the end vertex belongs to the image this many turns further on
    """

    name: str
    curve: Curve
    start: Vertex
    end: Vertex
    end_turn: int = 0
    pattern: Pattern = ALONE

    @cached_property
    def degenerate(self) -> bool:
        """Whether the edge is a point: a pole or an apex."""
        middle = self.curve.point(self.curve.parameter([0.3, 0.6]))
        away = np.max(np.abs(middle - self.start.position))
        return self.start is self.end and bool(away <= _POINT * np.max(np.abs(self.start.position)))

    @property
    def closed(self) -> bool:
        """Whether the edge is a closed curve through its one vertex."""
        return self.start is self.end and self.end_turn == 0 and not self.degenerate


@dataclass(frozen=True, kw_only=True)
class EdgeUse:
    """An edge as a face uses it: in its own sense or against it, in the image `turn` turns further on."""

    edge: Edge
    reverse: bool = False
    turn: int = 0


def motion_panels(motion: Motion, ends: Ends) -> tuple[float, ...]:
    """Fractions of the way between the ends at which a motion is smooth but not analytic."""
    if ends.constants is None:
        return ()
    start, finish = ends.constants
    return tuple((v - start) / (finish - start) for v in motion.panels(start, finish))


@dataclass(frozen=True, kw_only=True)
class Rail(Curve):
    """The way of one section point through a motion, by the fraction t between the ends."""

    motion: Motion
    section_point: tuple[float, ...]
    ends: Ends
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        p = self._points(u)
        return self.motion.place(p, self.ends.value(p, u))

    def derivative(self, u: ArrayLike) -> Array:
        p = self._points(u)
        return self.motion.velocity(p, self.ends.value(p, u)) * self.ends.span(p)[..., None]

    @property
    def panels(self) -> tuple[float, ...]:
        return motion_panels(self.motion, self.ends)

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All at once, where they are whole rails of one motion between the same ends."""
        first = curves[0]
        if any((c.motion, c.ends) != (first.motion, first.ends) or c.interval != (0.0, 1.0) for c in curves):
            return super().together(curves, fractions)
        p = np.broadcast_to(
            np.array([c.section_point for c in curves])[:, None, :],
            (len(curves), len(fractions), len(first.section_point)),
        )
        v = first.ends.value(p, fractions)
        return first.motion.place(p, v), first.motion.velocity(p, v) * first.ends.span(p)[..., None]

    def _points(self, u: ArrayLike) -> Array:
        point = np.asarray(self.section_point)
        return np.broadcast_to(point, (*np.shape(u), point.size))


@dataclass(frozen=True, kw_only=True)
class VaryingRail(Curve):
    """The way of the start of a family's members through a motion, by the fraction t between constant ends."""

    motion: Motion
    curve: Curve
    ends: Ends
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        first, v = self._first(u)
        return self.motion.place(self.curve.at(v).point(first), v)

    def derivative(self, u: ArrayLike) -> Array:
        first, v = self._first(u)
        p = self.curve.at(v).point(first)
        rate = self.motion.velocity(p, v) + self.motion.carry(p, self.curve.variation(first, v), v)
        return rate * self.ends.span(p)[..., None]

    @property
    def panels(self) -> tuple[float, ...]:
        return motion_panels(self.motion, self.ends)

    def _first(self, u: ArrayLike) -> tuple[Array, Array]:
        """The parameter of the curve's start, and the motion's (...) at fractions u (...)."""
        first = np.full(np.shape(u), self.curve.interval[0])
        return first, self.ends.value(self.curve.point(first), u)


@dataclass(frozen=True, kw_only=True)
class Profile(Curve):
    """A curve of the section carried to one end of a motion."""

    motion: Motion
    curve: Curve
    station: End

    def point(self, u: ArrayLike) -> Array:
        p = self.curve.point(u)
        return self.motion.place(p, self.station.value(p))

    def derivative(self, u: ArrayLike) -> Array:
        p, tangent = self.curve.point(u), self.curve.derivative(u)
        v = self.station.value(p)
        along = np.sum(self.station.gradient(p) * tangent, axis=-1)
        return self.motion.carry(p, tangent, v) + self.motion.velocity(p, v) * along[..., None]

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All at once, where they are whole curves at one station of one motion."""
        first = curves[0]
        if any(
            (c.motion, c.station) != (first.motion, first.station) or c.interval != c.curve.interval for c in curves
        ):
            return super().together(curves, fractions)
        p, tangent = along([c.curve for c in curves], fractions)
        v = first.station.value(p)
        turned = np.sum(first.station.gradient(p) * tangent, axis=-1)[..., None]
        rates = first.motion.carry(p, tangent, v) + first.motion.velocity(p, v) * turned
        return first.motion.place(p, v), rates

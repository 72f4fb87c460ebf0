"""Vertices and edges: what faces share, so that no two faces can disagree about their border."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.curve import Curve, along
from ..motions.ends import Ends
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
    return tuple((v - ends.start) / ends.span for v in motion.panels(ends.start, ends.finish))


@dataclass(frozen=True, kw_only=True)
class Rail(Curve):
    """The way of one section point through a motion, by the fraction t between the ends."""

    motion: Motion
    section_point: tuple[float, ...]
    ends: Ends
    interval: tuple[float, float] = (0.0, 1.0)

    def point(self, u: ArrayLike) -> Array:
        return self.motion.place(self._points(u), self.ends.at(u))

    def derivative(self, u: ArrayLike) -> Array:
        return self.motion.velocity(self._points(u), self.ends.at(u)) * self.ends.span

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
        v = np.broadcast_to(first.ends.at(fractions), p.shape[:-1])
        return first.motion.place(p, v), first.motion.velocity(p, v) * first.ends.span

    def _points(self, u: ArrayLike) -> Array:
        point = np.asarray(self.section_point)
        return np.broadcast_to(point, (*np.shape(u), point.size))


@dataclass(frozen=True, kw_only=True)
class VaryingRail(Curve):
    """The way of the start of a family's members through a motion, by the fraction t between the ends."""

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
        return rate * self.ends.span

    @property
    def panels(self) -> tuple[float, ...]:
        return motion_panels(self.motion, self.ends)

    def _first(self, u: ArrayLike) -> tuple[Array, Array]:
        """The parameter of the curve's start, and the motion's (...) at fractions u (...)."""
        return np.full(np.shape(u), self.curve.interval[0]), self.ends.at(u)


@dataclass(frozen=True, kw_only=True)
class Profile(Curve):
    """A curve of the section carried to one parameter v of a motion."""

    motion: Motion
    curve: Curve
    v: float

    def point(self, u: ArrayLike) -> Array:
        p = self.curve.point(u)
        return self.motion.place(p, np.full(p.shape[:-1], self.v))

    def derivative(self, u: ArrayLike) -> Array:
        p = self.curve.point(u)
        return self.motion.carry(p, self.curve.derivative(u), np.full(p.shape[:-1], self.v))

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """All at once, where they are whole curves at one parameter of one motion."""
        first = curves[0]
        if any((c.motion, c.v) != (first.motion, first.v) or c.interval != c.curve.interval for c in curves):
            return super().together(curves, fractions)
        p, tangent = along([c.curve for c in curves], fractions)
        v = np.full(p.shape[:-1], first.v)
        return first.motion.place(p, v), first.motion.carry(p, tangent, v)

"""The concept of a curve: a point for every parameter, analytic over an interval."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Self

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.quadrature import gauss_legendre


@dataclass(frozen=True, kw_only=True)
class Curve(ABC):
    """A curve in the plane (d = 2), on the unit sphere or in space (d = 3).

    interval   parameter at the start and at the end; it may run downwards, which reverses the curve

    The parameter is one in which the curve is analytic (an involute's roll, not its radius), so that
    Gauss–Legendre quadrature converges exponentially and equal steps are good chords.
    A curve that varies along a motion (relief, crowning, taper) is a `Family`.
    """

    interval: tuple[float, float]

    @abstractmethod
    def point(self, u: ArrayLike) -> Array:
        """Points (..., d) at parameters u (...)."""

    @abstractmethod
    def derivative(self, u: ArrayLike) -> Array:
        """d point / du, (..., d)."""

    def at(self, v: ArrayLike) -> Curve:
        """The member of the family at the motion's parameter v; a constant curve is its own."""
        del v
        return self

    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        """d point / dv of the family, (..., d); nought for a constant curve."""
        shape = np.broadcast_shapes(np.shape(u), np.shape(v))
        return np.zeros((*shape, self.start.size))

    @property
    def varies(self) -> bool:
        """Whether the curve is not its own member everywhere."""
        return self.at(0.0) is not self

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        """Parameters of a motion, between two, at which a family turns back; none of a constant curve."""
        del start, finish
        return ()

    def parameter(self, fraction: ArrayLike) -> Array:
        """Parameter u (...) at a fraction of the interval, 0 at the start and 1 at the end."""
        a, b = self.interval
        fraction = np.asarray(fraction, float)
        return a * (1.0 - fraction) + b * fraction

    def reversed(self) -> Self:
        """The same curve from its end to its start."""
        return replace(self, interval=self.interval[::-1])

    @property
    def panels(self) -> tuple[float, ...]:
        """Fractions at which the curve is smooth but not analytic: where quadratures and searches start anew."""
        return ()

    def fractions(self, steps: int) -> Array:
        """Fractions of the interval from 0 to 1, so many equal steps in each panel."""
        return in_panels(self.panels, np.arange(steps) / steps, last=True)

    @property
    def start(self) -> Array:
        return self.point(self.interval[0])

    @property
    def end(self) -> Array:
        return self.point(self.interval[1])

    @classmethod
    def together(cls, curves: Sequence[Self], fractions: Array) -> tuple[Array, Array]:
        """Points and d point / d fraction (n, m, d) of n curves of this class at fractions (m,).

        One by one; a class of which sections hold hundreds evaluates them at once.
        """
        parameters = [curve.parameter(fractions) for curve in curves]
        points = [curve.point(u) for curve, u in zip(curves, parameters, strict=True)]
        tangents = [
            curve.derivative(u) * (curve.interval[1] - curve.interval[0])
            for curve, u in zip(curves, parameters, strict=True)
        ]
        return np.array(points), np.array(tangents)

    @classmethod
    def points_together(cls, curves: Sequence[Self], fractions: Array) -> Array:
        """The points alone (n, m, d); a class that evaluates many at once does so here, too."""
        return np.array([curve.point(curve.parameter(fractions)) for curve in curves])

    def quadrature(self, nodes: int) -> tuple[Array, Array]:
        """Gauss–Legendre points and weighted tangents (n, d), `nodes` a panel, so that ∮ f·dr ≈ Σ f(point)·tangent."""
        x, w = gauss_legendre(nodes)
        a, b = self.interval
        u = self.parameter(in_panels(self.panels, (x + 1.0) / 2.0))
        weights = np.outer(np.diff([0.0, *self.panels, 1.0]), w).ravel() * ((b - a) / 2.0)
        return self.point(u), self.derivative(u) * weights[:, None]


def in_panels(panels: Sequence[float], fractions: Array, *, last: bool = False) -> Array:
    """Fractions of each of the panels that cut the interval from 0 to 1, one after another; `last` adds 1."""
    cuts = np.array([0.0, *panels, 1.0])
    found = (cuts[:-1, None] + np.diff(cuts)[:, None] * fractions).ravel()
    return np.append(found, 1.0) if last else found


def along(curves: Sequence[Curve], fractions: Array) -> tuple[Array, Array]:
    """Points and d point / d fraction (n, m, d) of curves of any classes at the same fractions (m,) of each."""
    groups = [list(group) for _, group in groupby(curves, type)]
    parts = [type(group[0]).together(group, fractions) for group in groups]
    if len(parts) == 1:
        return parts[0]
    return np.concatenate([p for p, _ in parts]), np.concatenate([t for _, t in parts])


def points_along(curves: Sequence[Curve], fractions: Array) -> Array:
    """The points (n, m, d) of `along` without their tangents."""
    groups = (list(group) for _, group in groupby(curves, type))
    return np.concatenate([type(group[0]).points_together(group, fractions) for group in groups])


def chain_quadrature(curves: Sequence[Curve], nodes: int) -> tuple[Array, Array]:
    """Gauss–Legendre points and weighted tangents (n, d) of a chain of curves without panels, `nodes` to each."""
    x, w = gauss_legendre(nodes)
    points, tangents = along(curves, (x + 1.0) / 2.0)
    d = points.shape[-1]
    return points.reshape(-1, d), (tangents * (w / 2.0)[:, None]).reshape(-1, d)


@dataclass(frozen=True, kw_only=True)
class Mapped(Curve):
    """A curve under the affine map p → A p + b: a rotation, a mirror image or a copy elsewhere of it.

    matrix   A (d, d), as nested tuples
    offset   b (d,); empty for none
    """

    curve: Curve
    matrix: tuple[tuple[float, ...], ...]
    offset: tuple[float, ...] = ()

    def point(self, u: ArrayLike) -> Array:
        turned = self.curve.point(u) @ np.array(self.matrix).T
        return turned + np.array(self.offset) if self.offset else turned

    def derivative(self, u: ArrayLike) -> Array:
        return self.curve.derivative(u) @ np.array(self.matrix).T

    def at(self, v: ArrayLike) -> Curve:
        member = self.curve.at(v)
        return self if member is self.curve else replace(self, curve=member)

    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        return self.curve.variation(u, v) @ np.array(self.matrix).T

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        return self.curve.extremes(start, finish)


def mapped(curve: Curve, matrix: ArrayLike, offset: ArrayLike = ()) -> Mapped:
    """The curve under p → A p + b, for A (d, d) and b (d,) or none."""
    rows = tuple(tuple(float(x) for x in row) for row in np.asarray(matrix))
    return Mapped(interval=curve.interval, curve=curve, matrix=rows, offset=tuple(float(x) for x in np.asarray(offset)))


def turn(angle: float, dimension: int, *, mirrored: bool = False) -> Array:
    """The rotation (d, d) by an angle about the origin or z axis, after y → −y where mirrored."""
    c, s = np.cos(angle), np.sin(angle)
    matrix = np.eye(dimension)
    matrix[:2, :2] = [[c, s], [s, -c]] if mirrored else [[c, -s], [s, c]]
    return matrix

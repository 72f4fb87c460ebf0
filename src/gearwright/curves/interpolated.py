"""Families interpolated between curves that are known at some parameters of the motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve
from .family import Family

_Value = Callable[[Curve, Array], Array]
_MOST_KEPT = 16  # sets of fractions


def chebyshev_stations(start: float, finish: float, degree: int) -> Array:
    """Extreme points (degree + 1,) of a Chebyshev polynomial between two parameters, both included, ascending."""
    nodes = -np.cos(np.pi * np.arange(degree + 1) / degree)
    return np.asarray((start + finish) / 2.0 + (finish - start) / 2.0 * nodes)


@dataclass(frozen=True, kw_only=True)
class Interpolated(Family):
    """Curves of which some are known: polynomials in v through points of the same fraction of each.

    members    the known curves
    stations   their parameters v, Chebyshev points, so that analytic families are met to rounding by few

    u is the fraction along every member. The reference is the one in the middle.
    """

    members: tuple[Curve, ...]
    stations: tuple[float, ...]
    interval: tuple[float, float] = (0.0, 1.0)

    def __post_init__(self) -> None:
        if len(self.members) != len(self.stations) or len(self.members) < 2:
            raise ValueError("an interpolated family has a station for each of its members, of which there are two")

    @property
    def _middle(self) -> Curve:
        return self.members[len(self.members) // 2]

    def point(self, u: ArrayLike) -> Array:
        return self._middle.point(self._middle.parameter(u))

    def derivative(self, u: ArrayLike) -> Array:
        return _rate(self._middle, np.asarray(u, float))

    def member_point(self, u: ArrayLike, v: ArrayLike) -> Array:
        return self._sum(self._weights(v), u, _place)

    def member_derivative(self, u: ArrayLike, v: ArrayLike) -> Array:
        return self._sum(self._weights(v), u, _rate)

    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        rates = self._weights(v) @ self._differentiation
        return self._sum(rates, u, _place)

    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        """None: tapers grow one way."""
        del start, finish
        return ()

    def _sum(self, weights: Array, u: ArrayLike, value: _Value) -> Array:
        """Σ weight value (..., d) over the members, at fractions u, broadcast against the weights' places.

        On grids, and where member after member is looked at, the same fractions come again: each is evaluated once.
        """
        fractions, places = np.unique(np.asarray(u, float), return_inverse=True)
        values, places = self._values(fractions, value), places.reshape(np.shape(u))
        if weights.ndim == 1:
            return np.asarray(np.tensordot(weights, values, 1)[places])
        return np.asarray(sum(weights[..., k, None] * known[places] for k, known in enumerate(values)))

    def _values(self, fractions: Array, value: _Value) -> Array:
        """Values (members, n, d) of all members at fractions (n,); the last ones are kept."""
        key = value, fractions.tobytes()
        if key not in self._kept:
            if len(self._kept) >= _MOST_KEPT:
                self._kept.clear()
            self._kept[key] = np.array([value(curve, fractions) for curve in self.members])
        return self._kept[key]

    @cached_property
    def _kept(self) -> dict[tuple[_Value, bytes], Array]:
        return {}

    @cached_property
    def _barycentric(self) -> Array:
        """Weights of Chebyshev's extreme points: alternating, halved at the ends."""
        weights: Array = np.where(np.arange(len(self.stations)) % 2, -1.0, 1.0)
        weights[[0, -1]] /= 2.0
        return weights

    def _weights(self, v: ArrayLike) -> Array:
        """Lagrange's polynomials (..., n) at parameters v (...), by the second barycentric formula."""
        apart = np.asarray(v, float)[..., None] - np.array(self.stations)
        met = apart == 0.0
        terms = self._barycentric / np.where(met, 1.0, apart)
        return np.where(met.any(axis=-1, keepdims=True), met, terms / np.sum(terms, axis=-1, keepdims=True))

    @cached_property
    def _differentiation(self) -> Array:
        """D[j, k]: the derivative of the k-th polynomial at the j-th station."""
        v, w = np.array(self.stations), self._barycentric
        apart = v[:, None] - v
        np.fill_diagonal(apart, 1.0)
        matrix = w / w[:, None] / apart
        np.fill_diagonal(matrix, 0.0)
        np.fill_diagonal(matrix, -matrix.sum(axis=1))
        return matrix


def _place(curve: Curve, fraction: Array) -> Array:
    """Points (..., d)."""
    return curve.point(curve.parameter(fraction))


def _rate(curve: Curve, fraction: Array) -> Array:
    """d point / d fraction (..., d)."""
    a, b = curve.interval
    return curve.derivative(curve.parameter(fraction)) * (b - a)


def interpolated(chains: Sequence[Sequence[Curve]], stations: Sequence[float]) -> tuple[Interpolated, ...]:
    """Families through chains of equally many curves, one chain to a station."""
    values = tuple(float(v) for v in stations)
    return tuple(Interpolated(members=curves, stations=values) for curves in zip(*chains, strict=True))

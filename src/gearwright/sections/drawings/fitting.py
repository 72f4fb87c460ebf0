"""Chains of cubic Bézier curves along any curve, within a tolerance and without corners."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...arrays import Array
from ...curves.curve import Curve
from ...errors import GeometryError, Problem
from ...moments.quadrature import gauss_legendre
from .listing import place

_NODES = 16  # of arc lengths, and of the places where a curve and its cubic are compared
_STEPS = 6  # of Newton's method to the foot of a perpendicular
_MOST_PIECES, _SHORTEST = 2000, 1e-12  # of one curve; and the shortest one, of its interval
_STANDSTILL = 1e-6  # of the mean speed: where a curve all but stands still, its direction is looked for just beside
_BESIDE = 2.0**-32  # of the interval
_LEVEL = 1e-3  # sine between end tangents below which they say nothing about the middle
_LEAST, _MOST = 0.01, 3.0  # of a third of the arc's length: handles outside bend the cubic more than the curve
_SHARE = 0.5  # of the tolerance, for what lies between the places compared


def cubics_along(curve: Curve, tolerance: float) -> Array:
    """Control points (n, 4, 2) of cubic Bézier curves within a distance of a plane curve from its start to its end.

    Neighbours share their ends and the directions there, which are the curve's own, to rounding. Pieces of the curve
    are halved until they are near enough to their cubics.
    Raises GeometryError where halving does not help.
    """
    left = [*pairwise((0.0, *curve.panels, 1.0))][::-1]
    found: list[Array] = []
    while left:
        a, b = left.pop()
        choices = _cubics(curve, a, b)
        deviations = [_deviation(curve, a, b, control) for control in choices]
        if min(deviations) <= _SHARE * tolerance:
            found.append(choices[int(np.argmin(deviations))])
            continue
        middle = (a + b) / 2.0
        left += [(middle, b), (a, middle)]
        if len(found) + len(left) > _MOST_PIECES or b - a <= _SHORTEST:
            raise GeometryError("The section cannot be drawn", [_refusal(curve, a, tolerance)])
    return np.array(found)


def _refusal(curve: Curve, fraction: float, tolerance: float) -> Problem:
    return Problem(
        f"{type(curve).__name__} at {place(curve.point(curve.parameter(fraction)))}",
        f"no spline of {_MOST_PIECES} pieces comes within {tolerance:.3g}; take a coarser one, or a smoother curve",
    )


def _cubics(curve: Curve, a: float, b: float) -> list[Array]:
    """Cubics (4, 2) with the ends and directions of the curve between two fractions, P₁ = P₀ + α₀ T₀, P₂ = P₃ − α₁ T₃.

    One is in the arc length: both α are a third of it. The other one passes through the middle of the curve:
    B(½) = (P₀ + 3 P₁ + 3 P₂ + P₃)/8 is linear in both α, if the tangents are not parallel. Next to a cusp, as an
    involute begins with, its α comes out at nought, and is held above that.
    """
    start, middle, end = curve.point(curve.parameter(np.array([a, (a + b) / 2.0, b])))
    first, last = _direction(curve, a, b), _direction(curve, b, a)
    third = _length(curve, a, b) / 3.0
    choices = [np.array([third, third])]
    across = _cross(first, last)
    if abs(across) > _LEVEL:
        rest = 8.0 * middle - 4.0 * (start + end)
        found = np.array([_cross(rest, last), _cross(rest, first)]) / (3.0 * across)
        choices.append(np.clip(found, _LEAST * third, _MOST * third))
    return [np.array([start, start + near * first, end - far * last, end]) for near, far in choices]


def _direction(curve: Curve, at: float, other: float) -> Array:
    """The unit tangent (2,) at one end of a piece, from within it where the curve stands still there."""
    fractions = np.array([at, at + _BESIDE * (other - at), (at + other) / 2.0])
    rates = curve.derivative(curve.parameter(fractions)) * np.sign(curve.interval[1] - curve.interval[0])
    speeds = np.linalg.norm(rates, axis=1)
    rate = rates[0] if speeds[0] > _STANDSTILL * speeds[2] else rates[1]
    return rate / np.linalg.norm(rate)


def _length(curve: Curve, a: float, b: float) -> float:
    x, weights = gauss_legendre(_NODES)
    rates = curve.derivative(curve.parameter(a + (b - a) * (x + 1.0) / 2.0))
    span = abs(curve.interval[1] - curve.interval[0]) * (b - a)
    return float(np.linalg.norm(rates, axis=1) @ weights) * span / 2.0


def _deviation(curve: Curve, a: float, b: float, control: Array) -> float:
    """Largest distance of places on the curve from the cubic, by the feet of their perpendiculars."""
    x, _ = gauss_legendre(_NODES)
    places = curve.point(curve.parameter(a + (b - a) * (x + 1.0) / 2.0))
    power = _POWERS @ control
    looks = np.linspace(0.0, 1.0, 4 * _NODES + 1)
    apart = np.linalg.norm(places[:, None] - _values(power, looks)[None], axis=2)
    t = looks[np.argmin(apart, axis=1)]
    rate = power[1:] * np.array([[1.0], [2.0], [3.0]])
    for _ in range(_STEPS):
        tangent = _values(rate, t)
        squares = np.maximum(np.sum(tangent**2, axis=1), np.finfo(float).tiny)
        t = np.clip(t + np.sum((places - _values(power, t)) * tangent, axis=1) / squares, 0.0, 1.0)
    return float(np.linalg.norm(places - _values(power, t), axis=1).max())


_POWERS = np.array([[1.0, 0.0, 0.0, 0.0], [-3.0, 3.0, 0.0, 0.0], [3.0, -6.0, 3.0, 0.0], [-1.0, 3.0, -3.0, 1.0]])
"""From Bernstein's basis to powers of t."""


def _values(power: Array, t: Array) -> Array:
    """Points (n, 2) of a polynomial of coefficients (k, 2) at t (n,)."""
    return t[:, None] ** np.arange(len(power)) @ power


def _cross(a: Array, b: Array) -> float:
    return float(a[0] * b[1] - a[1] * b[0])

"""The involute of a circle, the flank of a parallel-axis gear."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..moments.quadrature import gauss_legendre
from .curve import Curve

_MOST_STEPS = 50  # a handful is usual
_NEAR_CUSP = 1.0  # roll below which the azimuth is a quadrature
_CUSP_NODES = 20  # the integrand's poles ±i are then ≥ 1 interval away: the error is below 1e-20


def involute_of_roll(roll: ArrayLike) -> Array:
    """t − atan t (...), the azimuth of an involute's point at roll t (...) ≥ 0, to relative machine precision.

    Near the cusp as ∫ s²/(1 + s²) ds, since the difference is of the order t³/3 there.
    """
    t = np.asarray(roll, float)
    x, w = gauss_legendre(_CUSP_NODES)
    squares = (np.where(t < _NEAR_CUSP, t, 0.0)[..., None] * (x + 1.0) / 2.0) ** 2
    return np.where(t < _NEAR_CUSP, t / 2.0 * ((squares / (1.0 + squares)) @ w), t - np.arctan(t))


def involute_function(pressure_angle: ArrayLike) -> Array:
    """inv a = tan a − a (...), the azimuth of an involute's point of pressure angle a (...), radians.

    Source: ISO 21771, 5.2; used in Al-Daccak 1989, ch. 4.5.2.
    """
    return involute_of_roll(np.tan(np.asarray(pressure_angle, float)))


@dataclass(frozen=True, kw_only=True)
class Involute(Curve):
    """The involute unwound counter-clockwise from a base circle about the origin, starting on +x.

    The parameter is the roll angle t = tan a, in which the curve is analytic down to the cusp:
    x = r_b (cos t + t sin t), y = r_b (sin t − t cos t). Its radius is r_b √(1 + t²).
    Source: Al-Daccak 1989, ch. 4.5.2.
    """

    base_radius: float

    def point(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        c, s = np.cos(t), np.sin(t)
        return self.base_radius * np.stack([c + t * s, s - t * c], axis=-1)

    def derivative(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        return self.base_radius * np.stack([t * np.cos(t), t * np.sin(t)], axis=-1)


def involute_roll(radius: ArrayLike, base_radius: float) -> Array:
    """Roll angle t (...) at which the involute reaches a radius (...) ≥ r_b: t = √(r² − r_b²)/r_b."""
    r = np.asarray(radius, float)
    if not np.all(r >= base_radius):
        raise ValueError(f"an involute has no points inside its base circle of radius {base_radius:.6g}")
    return np.sqrt((r - base_radius) * (r + base_radius)) / base_radius


def inverse_involute_function(involute: ArrayLike) -> Array:
    """Pressure angle a (...) with inv a = the given values (...) ≥ 0, radians.

    Newton's method on (t − atan t)^{1/3} over the roll t = tan a: almost linear near the cusp, concave
    beyond, so that the steps settle from any start.
    """
    target = np.asarray(involute, float)
    if not np.all(target >= 0.0):
        raise ValueError("the involute function has no negative values on its own branch")
    root = np.cbrt(target)
    roll = np.maximum(np.cbrt(3.0) * root, target)
    for _ in range(_MOST_STEPS):
        value = np.cbrt(involute_of_roll(roll))
        slope = roll**2 / (1.0 + roll**2) / (3.0 * np.where(value > 0.0, value, 1.0) ** 2)
        following = np.where(target > 0.0, roll - (value - root) / np.where(slope > 0.0, slope, 1.0), 0.0)
        settled = np.all(np.abs(following - roll) <= 4.0 * np.finfo(float).eps * roll)
        roll = following
        if settled:
            break
    return np.arctan(roll)

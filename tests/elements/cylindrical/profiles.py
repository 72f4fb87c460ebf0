"""The curves of a gear's first tooth, found in its section by what they are."""

from __future__ import annotations

import numpy as np

from gearwright.curves.curve import Curve, turn

from ...laws.contact import unmapped


def curves_of(gear, kind: type[Curve]) -> list[Curve]:
    """The curves of a class in the teeth's loop, in their order."""
    loop = gear.profile.loops[1 if getattr(gear, "is_internal", False) else 0]
    return [curve for curve in loop.curves if isinstance(unmapped(curve), kind)]


def unit_tangent(curve: Curve, fraction: float) -> np.ndarray:
    a, b = curve.interval
    along = curve.derivative(curve.parameter(fraction)) * np.sign(b - a)
    return along / np.linalg.norm(along)


def angle_between(one: np.ndarray, other: np.ndarray) -> float:
    """From one plane vector to another, radians."""
    return float(np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other))


def polar(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.hypot(points[..., 0], points[..., 1]), np.arctan2(points[..., 1], points[..., 0])


def turned(points: np.ndarray, angle: float) -> np.ndarray:
    """Points (..., 2) turned about the axis."""
    return points @ turn(angle, 2).T

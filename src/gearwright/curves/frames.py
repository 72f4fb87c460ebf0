"""Frames that move along a path: how the plane of a section turns about the tangent.

Every frame here is the rotation-minimising one turned by an angle about the tangent. On a stretch of the path whose
tangents stay near the first one, t₀, the smallest rotation that takes t₀ to t(u) carries the axes along; it turns them
about t at the rate −(t₀ × t)·t′ / (1 + t₀·t), whose integral, taken off again, leaves no turn at all. The integral is a
convergent quadrature, so the frame is right to rounding; double reflection (Wang et al. 2008) is its limit of many
small steps, to their fourth order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem
from .path import Path
from .smooth import Smooth, lowest, smooth

_STRETCH = np.cos(np.radians(40.0))  # t₀·t at the end of a stretch: far from t = −t₀, where 1 + t₀·t vanishes
_TOLERANCE = 1e-14  # of angles, radians
_CLOSING = 1e-6  # radians by which the axes of a closed path may miss themselves
_DEGENERATE = 1e-6  # sine of the angle below which two directions are taken for parallel
_SHORTEST = 1e-9  # a stretch of u in which a path that moves on cannot turn round
_LOOK = 64  # places a piece at which degeneracy is looked for


@dataclass(frozen=True, kw_only=True, eq=False)
class Frame:
    """Axes e₁, e₂ across a path, with e₁ × e₂ = t.

    stretches  (k + 1,)    where the path is cut
    axes       (k, 3, 3)   columns e₁, e₂, t₀ of the rotation-minimising frame where each stretch begins
    angle      about t, right-handed, from the rotation-minimising frame; None for none
    """

    path: Path
    stretches: Array
    axes: Array
    angle: Smooth | None = None

    @property
    def panels(self) -> tuple[float, ...]:
        """Parameters at which path or angle go on as another series."""
        breaks = [self.path.series.breaks[1:-1], *([] if self.angle is None else [self.angle.breaks[1:-1]])]
        return tuple(np.unique(np.concatenate(breaks)).tolist())

    def across(self, u: ArrayLike) -> Array:
        """E = [e₁ e₂] (..., 3, 2) at u (...)."""
        return self._turned(self._carried(u), u)

    def across_rate(self, u: ArrayLike) -> Array:
        """dE/du (..., 3, 2): the axes follow the tangent, e′ = −(e·t′) t, and turn about it."""
        u = np.asarray(u, float)
        axes, tangent, bend = self.across(u), self.path.tangent(u), self.path.tangent_rate(u)
        following = -tangent[..., :, None] * np.sum(axes * bend[..., :, None], axis=-2, keepdims=True)
        if self.angle is None:
            return following
        rate = self.angle.derivative.value(u)[..., None]
        return following + rate * np.stack([axes[..., 1], -axes[..., 0]], axis=-1)

    def _carried(self, u: ArrayLike) -> Array:
        """The axes carried along each stretch by the smallest rotation (..., 3, 2)."""
        u = np.asarray(u, float)
        start = self.axes[_stretch(self.stretches, u)]
        first, tangent = start[..., 2], self.path.tangent(u)
        middle = (first + tangent) / (1.0 + np.sum(first * tangent, axis=-1))[..., None]
        along = np.sum(start[..., :2] * tangent[..., :, None], axis=-2, keepdims=True)
        return start[..., :2] - middle[..., :, None] * along

    def _turned(self, axes: Array, u: ArrayLike) -> Array:
        angle = _since(self._spin, self.stretches, u)
        if self.angle is not None:
            angle = angle + self.angle.value(u)[..., 0]
        return _rotated(axes, angle)

    @cached_property
    def _spin(self) -> Smooth:
        """What takes the turn of the carried axes about t off again, from the start of the path on."""

        def rate(u: Array) -> Array:
            first = self.axes[_stretch(self.stretches, u)][..., 2]
            tangent, bend = self.path.tangent(u), self.path.tangent_rate(u)
            turning = np.sum(np.cross(first, tangent) * bend, axis=-1)
            return (turning / (1.0 + np.sum(first * tangent, axis=-1)))[:, None]

        return smooth(rate, self.stretches, tolerance=_TOLERANCE, name="path's tangent", least=1.0).integral


def rotation_minimising(path: Path) -> Frame:
    """The frame that never turns about the tangent; on a closed path, by as little as closes it, evenly.

    At the start e₂ is as near as possible to +z, or, where the path starts along z, to +x.
    """
    stretches = _stretches(path)
    tangents = path.tangent(stretches)
    axes = np.empty((len(stretches) - 1, 3, 3))
    axes[0] = _start(tangents[0])
    frame = Frame(path=path, stretches=stretches, axes=axes)
    for k in range(1, len(axes)):
        axes[k, :, 2] = tangents[k]
        axes[k, :, :2] = _end_axes(replace(frame, stretches=stretches[k - 1 : k + 1], axes=axes[k - 1 : k]))
    if not path.closed:
        return frame
    miss = _angle_between(axes[0, :, :2], _end_axes(replace(frame, stretches=stretches[-2:], axes=axes[-1:])))
    length = path.length_to
    # the angle grows evenly with the length of the path
    even = replace(length, coefficients=-miss / path.length * length.coefficients)
    return replace(frame, angle=even)


def frenet(path: Path) -> Frame:
    """The frame of normal and binormal. Raises GeometryError where the path is straight."""
    return _guided(path, path.tangent_rate, 0, "is straight there and has no normal; choose another frame")


def fixed_up(path: Path) -> Frame:
    """The frame whose e₂ is as near as possible to +z all along. Raises GeometryError where the path runs along z."""

    def up(u: ArrayLike) -> Array:
        return np.broadcast_to([0.0, 0.0, 1.0], (*np.shape(u), 3))

    return _guided(path, up, 1, "runs along z there, and no way across it is up; choose another frame")


FRAMES: dict[str, Callable[[Path], Frame]] = {
    "rotation-minimising": rotation_minimising,
    "frenet": frenet,
    "fixed-up": fixed_up,
}


def _guided(path: Path, direction: Callable[[ArrayLike], Array], axis: int, degenerate: str) -> Frame:
    """The frame whose axis (0 or 1) is a direction (..., 3), as far as that lies across the path."""
    base = replace(rotation_minimising(path), angle=None)
    look = np.concatenate([np.linspace(a, b, _LOOK) for a, b in pairwise(base.stretches)])

    def direct(u: Array) -> Array:
        parts = np.sum(base.across(u) * direction(u)[..., :, None], axis=-2)
        return parts[..., 0] + 1j * parts[..., 1]

    scale = float(np.max(np.linalg.norm(direction(look), axis=-1)))
    worst = np.array(lowest(lambda u: float(np.abs(direct(np.array(u)))), look, np.abs(direct(look))))
    if np.abs(direct(worst)) <= _DEGENERATE * max(scale, 1.0):
        place = np.round(path.point(worst), 6).tolist()
        raise GeometryError(
            "The path cannot carry this frame", [Problem(f"u = {float(worst):.6g} at {place}", f"it {degenerate}")]
        )
    angles = np.unwrap(np.angle(direct(look)))  # coarse, to know the branch

    def angle(u: Array) -> Array:
        near = np.interp(u, look, angles)
        return (near + np.angle(direct(u) * np.exp(-1j * near)) - axis * np.pi / 2.0)[:, None]

    found = smooth(angle, base.stretches, tolerance=_TOLERANCE, name="angle of the frame", least=1.0)
    frame = replace(base, angle=found)
    miss = abs(_angle_between(frame.across(0.0), frame.across(1.0))) if path.closed else 0.0
    if miss > _CLOSING:
        problem = Problem(
            f"its axes at the ends differ by {np.degrees(miss):.3g}°", "choose the rotation-minimising frame"
        )
        raise GeometryError("The path cannot carry this frame", [problem])
    return frame


def _stretches(path: Path) -> Array:
    """The breaks of a path, with more where its tangent turns far from that at the last one."""
    found = []
    waiting = [(float(a), float(b)) for a, b in pairwise(path.series.breaks)]
    while waiting:
        start, stop = waiting.pop()
        tangents = path.tangent(np.linspace(start, stop, _LOOK))
        if np.min(tangents @ tangents[0]) < _STRETCH:
            if stop - start < _SHORTEST:
                problem = Problem(
                    f"u = {start:.6g} at {np.round(path.point(start), 6).tolist()}", "it turns back there"
                )
                raise GeometryError("The path cannot be used", [problem])
            middle = (start + stop) / 2.0
            waiting += [(start, middle), (middle, stop)]
        else:
            found.append(start)
    return np.array([*sorted(found), 1.0])


def _stretch(stretches: Array, u: Array) -> Array:
    return np.clip(np.searchsorted(stretches, u, side="right") - 1, 0, len(stretches) - 2)


def _since(integral: Smooth, stretches: Array, u: ArrayLike) -> Array:
    """An integral (...) from the start of each u's own stretch."""
    u = np.asarray(u, float)
    return (integral.value(u) - integral.value(stretches[_stretch(stretches, u)]))[..., 0]


def _start(tangent: Array) -> Array:
    """Columns e₁, e₂, t at the start of a path."""
    for up in (np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])):
        second = up - tangent * (tangent @ up)
        if np.linalg.norm(second) > _DEGENERATE:
            second /= np.linalg.norm(second)
            return np.stack([np.cross(second, tangent), second, tangent], axis=-1)
    raise AssertionError("a unit vector is not along z and x at once")


def _end_axes(stretch: Frame) -> Array:
    """The axes at the end of a frame of one stretch, orthonormal to rounding."""
    return stretch.across(stretch.stretches[-1])


def _angle_between(before: Array, after: Array) -> float:
    """Angle about the tangent from axes (3, 2) to axes (3, 2)."""
    return float(np.arctan2(after[:, 0] @ before[:, 1], after[:, 0] @ before[:, 0]))


def _rotated(axes: Array, angle: Array) -> Array:
    c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
    return np.stack([c * axes[..., 0] + s * axes[..., 1], c * axes[..., 1] - s * axes[..., 0]], axis=-1)

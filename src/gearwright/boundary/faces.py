"""Faces: patches swept by curves, and caps bounded by loops on a surface."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..curves.curve import Curve, along
from ..motions.ends import Ends
from ..motions.motion import Motion
from ..surfaces.surface import Surface
from .edge import Edge, EdgeUse, motion_panels
from .pattern import ALONE, Pattern


@dataclass(frozen=True, kw_only=True, eq=False)
class Patch:
    """One section curve swept over one smooth span of a motion; outward normal ∂u × ∂v.

    name      the face it belongs to; several patches may make one face
    sides     edge uses in turn around it, counter-clockwise from outside: first end along u, last
              point along v, second end against u, first point against v
    surface   the surface it lies on, where that is one of ours
    """

    name: str
    curve: Curve
    motion: Motion
    ends: Ends
    sides: tuple[EdgeUse, EdgeUse, EdgeUse, EdgeUse]
    pattern: Pattern = ALONE
    surface: Surface | None = None

    @property
    def panels(self) -> tuple[float, ...]:
        """Fractions v at which the motion is smooth but not analytic."""
        return motion_panels(self.motion, self.ends)

    def point(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at fractions u along the curve and v between the ends, both (...)."""
        p, t = self._section(u, v)
        return self.motion.place(p, t)

    def partials(self, u: Array, v: Array) -> tuple[Array, Array]:
        """∂r/∂u and ∂r/∂v (..., 3) at fractions u, v (...)."""
        p, t = self._section(u, v)
        a, b = self.curve.interval
        tangent = self.curve.at(t).derivative(self.curve.parameter(u)) * (b - a)
        velocity = self.motion.velocity(p, t)
        variation = self.motion.carry(p, self.curve.variation(self.curve.parameter(u), t), t)
        return self.motion.carry(p, tangent, t), (velocity + variation) * self.ends.span

    def area_vector(self, u: Array, v: Array) -> Array:
        """∂r/∂u × ∂r/∂v (..., 3), outward."""
        return np.cross(*self.partials(u, v))

    def _section(self, u: Array, v: Array) -> tuple[Array, Array]:
        parameter = self.curve.parameter(u)
        t = self.ends.at(v)
        return self.curve.at(t).point(parameter), t


def alike(patches: Sequence[Patch]) -> list[list[Patch]]:
    """Patches in runs that can be evaluated at once: one motion between the same ends, of curves that are no family."""
    runs: list[list[Patch]] = []
    for patch in patches:
        first = runs[-1][0] if runs else None
        if (
            first is not None
            and (patch.motion is first.motion and patch.ends is first.ends and patch.pattern is first.pattern)
            and not (patch.curve.varies or first.curve.varies)
        ):
            runs[-1].append(patch)
        else:
            runs.append([patch])
    return runs


def points_and_partials(patches: Sequence[Patch], u: Array, v: Array) -> tuple[Array, Array, Array]:
    """Points, ∂r/∂u and ∂r/∂v (k, n, 3) of k alike patches at fractions u, v (n,)."""
    first = patches[0]
    if len(patches) == 1:
        du, dv = first.partials(u, v)
        return first.point(u, v)[None], du[None], dv[None]
    p, tangent = along([patch.curve for patch in patches], u)
    t = np.broadcast_to(first.ends.at(v), p.shape[:-1])
    velocity = first.motion.velocity(p, t)
    return first.motion.place(p, t), first.motion.carry(p, tangent, t), velocity * first.ends.span


@dataclass(frozen=True, kw_only=True, eq=False)
class CapLoop:
    """One loop of a cap: a chain of edges once for each image of their pattern, or against them."""

    uses: tuple[EdgeUse, ...]
    reverse: bool = False

    @property
    def pattern(self) -> Pattern:
        return self.uses[0].edge.pattern

    def around(self, segments: Callable[[Edge], int]) -> Array:
        """Points (n, 3) once around the loop in its sense, so many equal steps of each edge's parameter."""
        chain = []
        for use in self.uses:
            fractions = np.arange(segments(use.edge)) / segments(use.edge)
            chain.append(use.edge.curve.point(use.edge.curve.parameter(1.0 - fractions if use.reverse else fractions)))
        images = self.pattern.images(np.concatenate(chain))
        in_order = images if self.uses[-1].edge.end_turn >= 0 else np.roll(images[::-1], 1, axis=0)
        around = in_order.reshape(-1, 3)
        return around[::-1] if self.reverse else around


@dataclass(frozen=True, kw_only=True, eq=False)
class Cap:
    """A face on a surface, bounded by loops that run counter-clockwise seen from outside the body."""

    name: str
    surface: Surface
    loops: tuple[CapLoop, ...]

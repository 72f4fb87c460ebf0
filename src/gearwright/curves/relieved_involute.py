"""The involute with relief: its string is a little shorter towards the tip."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class RelievedInvolute(Curve):
    """The curve unwound from a base circle about the origin with a string of length r_b t − c(t).

    base_radius   r_b
    amount        C, what is taken off along the normal of the flank at the roll angle `full`
    begin, full   roll angles between which the relief c = C ((t − begin)/(full − begin))^power grows
    power         1: straight from where it begins, 2: parabolic, tangent to the involute

    The parameter is the roll angle t of the string, counter-clockwise from +x, as for `Involute`.
    Source: ISO 21771, tip relief as amounts along the line of action.
    """

    base_radius: float
    amount: float
    begin: float
    full: float
    power: int

    def point(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        outward, along = self._axes(t)
        string = self.base_radius * t - self.amount * self._share(t) ** self.power
        return self.base_radius * outward - string[..., None] * along

    def derivative(self, u: ArrayLike) -> Array:
        t = np.asarray(u, float)
        outward, along = self._axes(t)
        string = self.base_radius * t - self.amount * self._share(t) ** self.power
        rate = self.amount * self.power * self._share(t) ** (self.power - 1) / (self.full - self.begin)
        return string[..., None] * outward + rate[..., None] * along

    def _share(self, t: Array) -> Array:
        return (t - self.begin) / (self.full - self.begin)

    def _axes(self, t: Array) -> tuple[Array, Array]:
        """Unit vectors (..., 2) away from the axis and along the circle, where the string leaves it."""
        c, s = np.cos(t), np.sin(t)
        return np.stack([c, s], axis=-1), np.stack([-s, c], axis=-1)

"""Curves of the unit sphere as they look in the plane, projected from −z."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Stereographic(Curve):
    """The stereographic image (x, y)/(1 + z) of a curve on the unit sphere: conformal, the pole +z in the middle."""

    curve: Curve

    def point(self, u: ArrayLike) -> Array:
        n = self.curve.point(u)
        return np.asarray(n[..., :2] / (1.0 + n[..., 2:]))

    def derivative(self, u: ArrayLike) -> Array:
        n, rate = self.curve.point(u), self.curve.derivative(u)
        below = 1.0 + n[..., 2:]
        return np.asarray((rate[..., :2] - n[..., :2] * rate[..., 2:] / below) / below)

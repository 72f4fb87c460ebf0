"""The concept of a family: a curve of a section that varies along the section's motion."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from .curve import Curve


@dataclass(frozen=True, kw_only=True)
class Family(Curve):
    """Curves of one interval, one for every parameter v of a motion: crowning, relief, taper.

    `point` and `derivative` are those of the reference, the curve without what varies; it need not be a member.
    All members are analytic in u, and points are analytic in v, so that quadratures converge in both.
    """

    @abstractmethod
    def member_point(self, u: ArrayLike, v: ArrayLike) -> Array:
        """Points (..., d) at parameters u of the members v, which are broadcast against each other."""

    @abstractmethod
    def member_derivative(self, u: ArrayLike, v: ArrayLike) -> Array:
        """∂ point / ∂u (..., d)."""

    @abstractmethod
    def variation(self, u: ArrayLike, v: ArrayLike) -> Array:
        """∂ point / ∂v (..., d)."""

    @abstractmethod
    def extremes(self, start: float, finish: float) -> tuple[float, ...]:
        """Parameters v between two at which what varies turns back."""

    def at(self, v: ArrayLike) -> Curve:
        """The member v; of an array of parameters, a curve whose points are each of the member at the same place."""
        return Member(interval=self.interval, family=self, v=v if np.ndim(v) else float(np.asarray(v)))


@dataclass(frozen=True, kw_only=True)
class Member(Curve):
    """The curve of a family at a parameter v of the motion, or at an array of them."""

    family: Family
    v: ArrayLike

    def point(self, u: ArrayLike) -> Array:
        return self.family.member_point(u, self.v)

    def derivative(self, u: ArrayLike) -> Array:
        return self.family.member_derivative(u, self.v)

    @property
    def panels(self) -> tuple[float, ...]:
        return self.family.panels

"""Parallel sweep by any smooth transform of the section's plane."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..arrays import Array, ArrayLike
from ..moments.body import BodyMoments
from ..sections.plane import Section
from ..sections.section import LoopedSection
from .ends import Ends
from .parallel import ParallelMotion
from .plane_quadrature import TOLERANCE, quadrature_moments
from .transform import Transform


@dataclass(frozen=True, kw_only=True)
class Transforming(ParallelMotion):
    """A point p of the section goes to A(v) p + h(v) at height v, as the transform says.

    tolerance   of the quadrature of (S1)

    Source: Al-Daccak 1989, eqs. (5.3)–(5.13).
    """

    transform: Transform
    tolerance: float = TOLERANCE

    def linear(self, v: ArrayLike) -> Array:
        return self.transform.linear(v)

    def linear_rate(self, v: ArrayLike) -> Array:
        return self.transform.linear_rate(v)

    def offset(self, v: ArrayLike) -> Array:
        return self.transform.offset(v)

    def offset_rate(self, v: ArrayLike) -> Array:
        return self.transform.offset_rate(v)

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        if not isinstance(section, Section):
            return None
        body = quadrature_moments(self, section, ends.start, ends.finish, self.tolerance)
        return replace(body, error_bound=body.error_bound + self.transform.series.error)

    def breaks(self, ends: Ends) -> tuple[float, ...]:
        return tuple(kink for kink in self.transform.series.kinks if ends.start < kink < ends.finish)

    def panels(self, start: float, finish: float) -> tuple[float, ...]:
        return tuple(float(x) for x in self.transform.series.breaks if start < x < finish)

    @property
    def rotation_order(self) -> int:
        return self.transform.rotation_order

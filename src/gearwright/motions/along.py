"""Sweep along a path in space: the plane of the section stays across it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array, ArrayLike
from ..curves.frames import Frame
from ..curves.path import Path
from ..moments.body import BodyMoments
from ..sections.plane import Section
from ..sections.section import LoopedSection
from ..surfaces.plane import Plane
from ..surfaces.surface import Surface
from .ends import Ends
from .motion import Motion
from .parallel import applied
from .plane_quadrature import quadrature_moments
from .transform import Transform

_CLOSING = 1e-9  # of the transform's largest entry, of the way: what differs by less is one


@dataclass(frozen=True, kw_only=True, eq=False)
class Along(Motion):
    """r = c(v) + E(v) q with q = A p + h: the section's plane, mapped by a transform, is carried by a frame.

    frame       the path c and the axes E = [e₁ e₂] across it
    transform   A and h as functions of the fraction of arc length; None for the section as it is

    The volume element is det A (|c′| − q·χ) with χ = Eᵀ t′, t the tangent: linear in p, nought where the section
    reaches the path's axis of curvature. Source: Al-Daccak 1989, ch. 6, names it as the extension of chapter 5.
    """

    frame: Frame
    transform: Transform | None = None

    def place(self, point: Array, v: ArrayLike) -> Array:
        return self.frame.path.point(v) + applied(self.frame.across(v), self._in_plane(point, v))

    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        del point
        turned = tangent if self.transform is None else applied(self.transform.linear(self._fraction(v)), tangent)
        return applied(self.frame.across(v), turned)

    def velocity(self, point: Array, v: ArrayLike) -> Array:
        path = self.frame.path
        rate = path.derivative(v) + applied(self.frame.across_rate(v), self._in_plane(point, v))
        if self.transform is None:
            return rate
        fraction = self._fraction(v)
        change = applied(self.transform.linear_rate(fraction), point) + self.transform.offset_rate(fraction)
        speed = np.linalg.norm(path.derivative(v), axis=-1, keepdims=True) / path.length
        return rate + applied(self.frame.across(v), change * speed)

    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        speed = np.linalg.norm(self.frame.path.derivative(v), axis=-1)
        element = speed - np.sum(self._in_plane(point, v) * self._bend(v), axis=-1)
        return element if self.transform is None else np.linalg.det(self.transform.linear(self._fraction(v))) * element

    def end_surface(self, v: float) -> Surface:
        axes = self.frame.across(v)
        origin = self.frame.path.point(v)
        return Plane(origin=_triple(origin), x_axis=_triple(axes[:, 0]), y_axis=_triple(axes[:, 1]))

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        if not isinstance(section, Section):
            return None
        return quadrature_moments(self, section, ends.start, ends.finish)

    def panels(self, start: float, finish: float) -> tuple[float, ...]:
        found = [*self.frame.panels]
        if self.transform is not None:
            path = self.frame.path
            found += [_parameter_at(path, f * path.length) for f in self.transform.series.breaks[1:-1]]
        inner = np.sort([u for u in found if start < u < finish])
        apart = np.diff(inner, prepend=start) > _CLOSING * (finish - start)
        return tuple(inner[apart].tolist())

    def breaks(self, ends: Ends) -> tuple[float, ...]:
        if self.transform is None:
            return ()
        path = self.frame.path
        found = [_parameter_at(path, kink * path.length) for kink in self.transform.series.kinks]
        return tuple(u for u in found if ends.start < u < ends.finish)

    def station(self, v: float) -> str:
        return f"path parameter {v:.6g}"

    def remedy(self, point: Array, v: float) -> str:
        if self.transform is not None and np.linalg.det(self.transform.linear(self._fraction(v))) <= 0.0:
            return "the transform's determinant is not positive there; it must stay greater than 0"
        bend = self._bend(v)
        radius = float(np.linalg.norm(self.frame.path.derivative(v)) / np.linalg.norm(bend))
        reach = float(self._in_plane(point, v) @ bend / np.linalg.norm(bend))
        return (
            f"the path's radius of curvature is {radius:.6g} there, and the section reaches {reach:.6g} towards its"
            f" centre; a radius greater than {reach:.6g} would do, or a smaller section"
        )

    def refusal(self, ends: Ends) -> str | None:
        if self.transform is not None and self.closed(ends):
            first, last = (self.transform.series.value(fraction) for fraction in (0.0, 1.0))
            if np.max(np.abs(last - first)) > _CLOSING * np.max(np.abs(first)):
                return (
                    f"on a closed path the transform must come back to where it began, {np.round(first, 6).tolist()},"
                    f" not to {np.round(last, 6).tolist()} (f1 g1 h1 f2 g2 h2)"
                )
        return super().refusal(ends)

    def closed(self, ends: Ends) -> bool:
        return self.frame.path.closed and (ends.start, ends.finish) == (0.0, 1.0)

    @property
    def rotation_order(self) -> int:
        return 1

    def _bend(self, v: ArrayLike) -> Array:
        """χ = Eᵀ t′ (..., 2), towards the centre of curvature."""
        return np.sum(self.frame.across(v) * self.frame.path.tangent_rate(v)[..., :, None], axis=-2)

    def _in_plane(self, point: Array, v: ArrayLike) -> Array:
        """q (..., 2)."""
        if self.transform is None:
            return point
        fraction = self._fraction(v)
        return applied(self.transform.linear(fraction), point) + self.transform.offset(fraction)

    def _fraction(self, v: ArrayLike) -> Array:
        """Fraction of arc length (...) at path parameters v (...)."""
        path = self.frame.path
        return np.clip(path.length_to.value(v)[..., 0] / path.length, 0.0, 1.0)


def _parameter_at(path: Path, length: float) -> float:
    """The parameter at an arc length from the start."""
    from scipy.optimize import brentq

    return float(brentq(lambda u: float(path.length_to.value(u)[0]) - length, 0.0, 1.0, xtol=1e-15))


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return x, y, z

"""The concept of a motion: it carries every point of a section to its place in space."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from ..arrays import Array, ArrayLike
from ..curves.curve import Curve
from ..moments.body import BodyMoments
from ..sections.section import LoopedSection
from ..surfaces.surface import Surface
from .ends import Ends


@dataclass(frozen=True, kw_only=True)
class Motion(ABC):
    """A map (p, v) → r of section points p and a motion parameter v.

    rotation_order   turns of 2π/order about z that the motion commutes with; 0 stands for all turns
    layered          the section stays on surfaces that do not meet, one for each parameter, so that it may vary
    closed           the last position is the first one: a ring without end faces
    """

    @abstractmethod
    def place(self, point: Array, v: ArrayLike) -> Array:
        """r (..., 3) of section points (..., d) at parameters v (...)."""

    @abstractmethod
    def carry(self, point: Array, tangent: Array, v: ArrayLike) -> Array:
        """∂r/∂p · tangent (..., 3) for section tangents (..., d)."""

    @abstractmethod
    def velocity(self, point: Array, v: ArrayLike) -> Array:
        """∂r/∂v (..., 3)."""

    @abstractmethod
    def jacobian(self, point: Array, v: ArrayLike) -> Array:
        """Volume element (...): dV = jacobian dS dv. The motion is locally valid where it is positive."""

    @abstractmethod
    def end_surface(self, v: float) -> Surface:
        """The surface on which the section lies at a parameter, as at one end; its normal points along increasing v."""

    def swept_surface(self, curve: Curve) -> Surface | None:
        """The surface, if it is one of ours, that a curve sweeps; else None."""
        del curve
        return None

    def moments(self, section: LoopedSection, ends: Ends) -> BodyMoments | None:
        """The moments of the swept solid from those of its section; None where no reduction is known."""
        del section, ends
        return None

    def refusal(self, ends: Ends) -> str | None:
        """Why the motion cannot go between these ends; None where it can."""
        if not ends.start < ends.finish:
            return f"the motion must end beyond its start, {ends.start:.6g}, not at {ends.finish:.6g}"
        return None

    def breaks(self, ends: Ends) -> tuple[float, ...]:
        """Parameters between the ends at which the motion is not smooth."""
        del ends
        return ()

    def smooth_piece(self, span: Ends) -> Motion:
        """The motion within a span between neighbouring breaks, as one that is smooth up to both ends of it."""
        del span
        return self

    def panels(self, start: float, finish: float) -> tuple[float, ...]:
        """Parameters between two at which the motion is smooth but not analytic: where quadratures start anew."""
        del start, finish
        return ()

    def station(self, v: float) -> str:
        """What a parameter is called where a person reads it."""
        return f"parameter {v:.6g}"

    def remedy(self, point: Array, v: float) -> str:
        """What would keep the volume element positive at a section point (d,) and a parameter."""
        del point, v
        return "the section moves backwards there"

    @property
    def has_still_points(self) -> bool:
        """Whether a section may touch places that do not move, such as an axis, where the volume element vanishes."""
        return False

    @property
    def rotation_order(self) -> int:
        return 0

    @property
    def layered(self) -> bool:
        return False

    def closed(self, ends: Ends) -> bool:
        del ends
        return False

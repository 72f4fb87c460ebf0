"""Where a motion starts and stops, as constants or as functions of the section point."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..arrays import Array, ArrayLike


@dataclass(frozen=True, kw_only=True)
class End(ABC):
    """One end of a motion: its parameter as a function of the section point."""

    @abstractmethod
    def value(self, point: Array) -> Array:
        """Motion parameter v (...) at section points (..., d)."""

    @abstractmethod
    def gradient(self, point: Array) -> Array:
        """dv/dp (..., d)."""


@dataclass(frozen=True, kw_only=True)
class ConstantEnd(End):
    """An end at the same parameter everywhere: a plane end of an extrusion, a sphere of a radial sweep."""

    parameter: float

    def value(self, point: Array) -> Array:
        return np.full(point.shape[:-1], self.parameter)

    def gradient(self, point: Array) -> Array:
        return np.zeros(point.shape)


@dataclass(frozen=True, kw_only=True)
class Ends:
    """The two ends of a motion; at fraction t between them v = (1 − t) start + t finish."""

    start: End
    finish: End

    def value(self, point: Array, fraction: ArrayLike) -> Array:
        """Motion parameter v (...) at section points (..., d) and fractions t (...)."""
        t = np.asarray(fraction, float)
        return (1.0 - t) * self.start.value(point) + t * self.finish.value(point)

    def gradient(self, point: Array, fraction: ArrayLike) -> Array:
        """dv/dp (..., d) at fixed t."""
        t = np.asarray(fraction, float)[..., None]
        return (1.0 - t) * self.start.gradient(point) + t * self.finish.gradient(point)

    def span(self, point: Array) -> Array:
        """dv/dt (...)."""
        return self.finish.value(point) - self.start.value(point)

    def spans(self, breaks: Sequence[float]) -> tuple[Ends, ...]:
        """The ends of each smooth span, cut at a motion's breaks."""
        stations = (self.start, *(ConstantEnd(parameter=b) for b in breaks), self.finish)
        return tuple(Ends(start=a, finish=b) for a, b in pairwise(stations))

    @property
    def constants(self) -> tuple[float, float] | None:
        """Both parameters where both ends are constant, else None."""
        if isinstance(self.start, ConstantEnd) and isinstance(self.finish, ConstantEnd):
            return self.start.parameter, self.finish.parameter
        return None


def between(start: float, finish: float) -> Ends:
    """Constant ends."""
    return Ends(start=ConstantEnd(parameter=start), finish=ConstantEnd(parameter=finish))

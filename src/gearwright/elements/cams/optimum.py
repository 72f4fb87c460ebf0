"""What a synthesis is asked for, and what it has found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from .freedom import Freedom
from .limits import Limits
from .programme import Displacement, Step


@dataclass(frozen=True, kw_only=True)
class Task:
    """What is asked for: programme, follower, limits. unit   radians of a degree, or 1"""

    steps: Sequence[Step]
    unit: float
    sense: str
    freedom: Freedom
    limits: Limits


@dataclass(frozen=True, kw_only=True)
class Active:
    """A limit on which an optimum rests, and the cam angles (degrees) where; none for one of the dimensions."""

    name: str
    angles: tuple[float, ...]

    def __str__(self) -> str:
        where = ", ".join(f"{angle:.1f}°" for angle in self.angles)
        return f"{self.name} at {where}" if where else self.name


@dataclass(frozen=True, kw_only=True)
class Optimum:
    """The cam of least area with a law.

    law          its name
    dimensions   all dimensions of the follower, angles in degrees
    values       the free values of the spline, move after move; none of another law
    area         of the disk without its bore
    shortfall    by how much a limit is missed at the worst, in units of the mechanism's size or radians; ≤ 0 if none
    missed       the name of that limit
    active       the limits it rests on
    """

    law: str
    dimensions: Mapping[str, float]
    values: tuple[float, ...]
    displacement: Displacement
    area: float
    shortfall: float
    missed: str
    active: tuple[Active, ...]

    @property
    def keeps_limits(self) -> bool:
        return self.shortfall <= 0.0

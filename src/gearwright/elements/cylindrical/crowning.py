"""Lead crowning: flanks that turn into their teeth towards the ends of the face."""

from __future__ import annotations

from collections.abc import Sequence

from ...curves.arc import Arc
from ...curves.curve import Curve
from ...curves.polynomial import Polynomial
from ...curves.turning import TurnedArc, turned


def crowned(curves: Sequence[Curve], crowning: Polynomial | None) -> list[Curve]:
    """Curves that turn counter-clockwise by the crowning, a function of z in radians; as they are without one."""
    return list(curves) if crowning is None else [turned(curve, crowning) for curve in curves]


def crowned_arc(radius: float, azimuths: tuple[float, float], crowning: Polynomial | None) -> Curve:
    """The arc about the origin whose first end turns by the crowning, and whose second end turns by it backwards."""
    if crowning is None:
        return Arc(radius=radius, interval=azimuths)
    return TurnedArc(radius=radius, azimuths=azimuths, turnings=(crowning, -crowning))

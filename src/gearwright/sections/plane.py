"""Plane sections."""

from __future__ import annotations

from dataclasses import dataclass

from ..arrays import Array
from ..moments.boundary_integral import plane_moments
from .loop import Loop
from .section import LoopedSection


@dataclass(frozen=True, kw_only=True)
class Section(LoopedSection):
    """A region of the plane bounded by loops of curves (d = 2)."""

    def _integral(self, loops: tuple[Loop, ...], nodes: int) -> Array:
        parts = [plane_moments(*loop.quadrature(nodes), order=loop.copies) for loop in loops]
        return sum(parts[1:], start=parts[0])

"""Sections on the unit sphere."""

from __future__ import annotations

from dataclasses import dataclass

from ..arrays import Array
from ..curves.stereographic import Stereographic
from ..moments.sphere import region_moments
from .loop import Loop
from .section import LoopedSection


@dataclass(frozen=True, kw_only=True, repr=False)
class SphericalSection(LoopedSection):
    """A region of the unit sphere bounded by loops of curves (d = 3), seen from outside; −z lies outside it."""

    @property
    def _flat_loops(self) -> tuple[Loop, ...]:
        return tuple(
            Loop(
                curves=tuple(Stereographic(curve=curve, interval=curve.interval) for curve in loop.curves),
                copies=loop.copies,
            )
            for loop in self.loops
        )

    def _integral(self, loops: tuple[Loop, ...], nodes: int) -> Array:
        parts = [region_moments(*loop.quadrature(nodes), order=loop.copies) for loop in loops]
        return sum(parts[1:], start=parts[0])

    @property
    def moments(self) -> Array:
        """[Ω Nᵀ; N Q] (4, 4): solid angle, ∫ n dΩ and ∫ n nᵀ dΩ, on the true curves."""
        return self._converged[0]

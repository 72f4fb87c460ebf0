"""How far files round coordinates: from the digits they write, or from single precision."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..arrays import Array, Indices
from ..errors import FileError

_DOUBLE = 16
"""Digits from which a number keeps double precision, whose spacing is 1.1e-16 to 2.2e-16."""

_SINGLE = 9
"""Digits that keep single precision; with fewer the last digit is the coarser rounding of the two."""

_SHORT = 6
"""Digits that programs write at least; fewer are a person's, and meant, unless their last ones show rounding."""

_KINDS = 5
"""Different last digits, of ten, from which short numbers are rounded ones; lengths meant as such end in 0 and 5."""

_COARSEST = 1e-4
"""Rounding to single precision, relative to the body's diagonal, beyond which writing is refused."""


@dataclass(frozen=True, kw_only=True)
class Written:
    """What the numbers of a text look like.

    digits    most significant digits of any, noughts at the end included
    place     power of ten of the finest place of any
    endings   how many different last digits the numbers with the most digits have
    """

    digits: int
    place: int
    endings: int

    @classmethod
    def of(cls, seen: Indices) -> Written:
        """From what `decimals.take` has seen."""
        return cls(digits=int(seen[0]), place=int(seen[1]), endings=int(seen[2]).bit_count())

    def rounding(self, points: Array) -> float:
        """Largest error of coordinates (n, 3) by their rounding in this text.

        Programs write fixed decimal places or fixed significant digits, noughts at the end perhaps left away. In
        either form the number with the most digits shows how many the largest coordinate has, hence half a unit
        in the last place of the largest coordinate, the coarsest there is. 0 where the digits are those of double
        precision, where no number has decimals, and where the numbers are short (fewer than 6 digits) and their
        last digits so few that nothing shows rounding. Where 9 or more digits write single precision, half
        its spacing.
        """
        largest = float(np.abs(points).max(initial=0.0))
        if largest == 0.0 or self.place >= 0 or (self.digits < _SHORT and self.endings < _KINDS):
            return 0.0
        unit = 10.0 ** (np.floor(np.log10(largest)) - self.digits + 1)
        decimal = 0.0 if self.digits >= _DOUBLE else float(unit) / 2.0
        return max(decimal, single_precision(largest)) if self._writes_single(points) else decimal

    def _writes_single(self, points: Array) -> bool:
        """Whether every coordinate is a single precision number to within its own last digit."""
        if self.digits < _SINGLE:
            return False
        with np.errstate(over="ignore"):
            errors = np.abs(points - points.astype(np.float32))
        if self.digits >= _DOUBLE:
            return not errors.any()
        if not errors.any():
            return False  # lengths as 0.5 and 500 are single precision numbers anyway
        last = 0.5 * np.maximum(10.0 ** max(self.place, -300), np.abs(points) * 10.0 ** (1 - self.digits))
        return bool(np.all(errors <= 1.001 * last))


def single_precision(largest: float) -> float:
    """Half the spacing of single precision at the largest coordinate; 0 where that is beyond it."""
    with np.errstate(over="ignore"):
        spacing = float(np.spacing(np.float32(largest)))
    return spacing / 2.0 if np.isfinite(spacing) else 0.0


def in_single_precision(path: str | Path, form: str, vertices: Array) -> Array:
    """The vertices (n, 3) of a body rounded to single precision, still as float64.

    Raises FileError where it would move points by more than 1e-4 of the body's diagonal, or is beyond its numbers.
    """
    if not len(vertices):
        return vertices
    with np.errstate(over="ignore"):
        single = vertices.astype(np.float32).astype(np.float64)
    error = float(np.abs(single - vertices).max())
    diagonal = float(np.linalg.norm(vertices.max(axis=0) - vertices.min(axis=0)))
    if not error <= _COARSEST * diagonal:
        raise FileError(
            f"{path}: single precision, all that {form} has, would move points by {error:.3g}, and the body measures"
            f" {diagonal:.3g}; move it to the origin, or use a length unit that suits it"
        )
    return single

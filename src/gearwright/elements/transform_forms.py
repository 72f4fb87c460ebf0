"""Transforms of a section's plane as parameters: polynomials by their coefficients."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..motions.transform import NAMES
from ..parameters import MOST, Numbers, Parameter, Table, entry

_COEFFICIENTS = Numbers(most=16, words="a list of coefficients, lowest power first")

TRANSFORM = Parameter(
    meaning="polynomials in the height, or in the fraction of a path's length, in place of twist, scale and skew:"
    " x' = f1 x + g1 y + h1, y' = f2 x + g2 y + h2",
    kind="form",
    symbol="T",
    forms=(
        Table(
            entries=tuple(
                entry(
                    name,
                    Parameter(
                        meaning=f"coefficients of {name}, lowest power first; of the identity if not given",
                        kind="form",
                        forms=(_COEFFICIENTS,),
                    ),
                    default=None,
                )
                for name in NAMES
            )
        ),
    ),
)

_LARGEST = {"h1": MOST, "h2": MOST}
_LARGEST_FACTOR = 1e6


def too_large(coefficients: Mapping[str, Sequence[float] | None], reach: float) -> list[str]:
    """Which of the polynomials may become too large to compute with, from 0 to the reach, each in words."""
    found = []
    for name, row in coefficients.items():
        if row is None:
            continue
        bound = sum(abs(c) * reach**power for power, c in enumerate(row))
        most = _LARGEST.get(name, _LARGEST_FACTOR)
        if not bound <= most:
            found.append(f"{name} may reach {bound:.3g} between 0 and {reach:g}; at most {most:g} is possible")
    return found

"""Transforms of a section's plane as parameters: polynomials by their coefficients."""

from __future__ import annotations

from ..motions.transform import NAMES
from ..parameters import Numbers, Parameter, Table, entry

_COEFFICIENTS = Numbers(words="a list of coefficients, lowest power first")

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

"""How the plane of a section is mapped as it moves: a linear map and an offset, functions of one parameter."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from ..arrays import Array, ArrayLike
from ..curves.smooth import Smooth, smooth
from ..errors import GeometryError, Problem

NAMES = ("f1", "g1", "h1", "f2", "g2", "h2")
"""x′ = f₁ x + g₁ y + h₁, y′ = f₂ x + g₂ y + h₂."""
_GROUPS = (0, 0, 1, 0, 0, 1)  # offsets may be large, and must not take the linear map's digits
_IDENTITY = {"f1": [1.0], "g2": [1.0]}
_ALIKE = 1e-15  # of the largest coefficient: f₁ = g₂ and f₂ = −g₁ to rounding make a turn and an even scaling


@dataclass(frozen=True, kw_only=True, eq=False)
class Transform:
    """p ↦ [f₁ g₁; f₂ g₂] p + (h₁, h₂), the six of them functions of ξ. Source: Al-Daccak 1989, eqs. (5.3)–(5.5).

    series   the six, in the order of NAMES
    """

    series: Smooth

    def linear(self, xi: ArrayLike) -> Array:
        """[f₁ g₁; f₂ g₂] (..., 2, 2) at ξ (...)."""
        return _linear(self.series.value(xi))

    def linear_rate(self, xi: ArrayLike) -> Array:
        return _linear(self.series.derivative.value(xi))

    def offset(self, xi: ArrayLike) -> Array:
        """(h₁, h₂) (..., 2) at ξ (...)."""
        return self.series.value(xi)[..., [2, 5]]

    def offset_rate(self, xi: ArrayLike) -> Array:
        return self.series.derivative.value(xi)[..., [2, 5]]

    @property
    def rotation_order(self) -> int:
        """Turns of 2π/order that the map commutes with; 0 for all."""
        c = self.series.coefficients
        negligible = _ALIKE * float(np.max(np.abs(c)))
        if np.max(np.abs(c[..., [2, 5]])) > 0.0:
            return 1
        shear = max(float(np.max(np.abs(c[..., 0] - c[..., 4]))), float(np.max(np.abs(c[..., 1] + c[..., 3]))))
        return 0 if shear <= negligible else 2


def transform_of(function: Callable[[float], ArrayLike], length: float, tolerance: float) -> Transform:
    """The transform of a function ξ → [[f₁, g₁, h₁], [f₂, g₂, h₂], [0, 0, 1]], or without the last row or column.

    Called for one ξ at a time, 0 < ξ < length. Raises GeometryError where it gives something else or is not smooth.
    """

    def entries(xi: Array) -> Array:
        return np.array([_entries(function, float(x)) for x in xi])

    return Transform(series=smooth(entries, [0.0, length], tolerance=tolerance, name="transform", groups=_GROUPS))


def polynomial_transform(coefficients: Mapping[str, Sequence[float]], length: float) -> Transform:
    """The transform whose f₁, g₁, h₁, f₂, g₂, h₂ are polynomials in ξ by their coefficients, lowest power first.

    Those not named are those of the identity. Raises GeometryError for unknown names and for no numbers.
    """
    problems = [
        Problem(f"{name} = {value}", f"no such function; there are {', '.join(NAMES)}")
        for name, value in coefficients.items()
        if name not in NAMES
    ]
    rows = {}
    for name in NAMES:
        given = coefficients.get(name, _IDENTITY.get(name, [0.0]))
        row = np.array(given, float) if _numbers(given) else np.empty(0)
        if not row.size or not np.all(np.isfinite(row)):
            problems.append(Problem(f"{name} = {given}", "a list of finite coefficients is needed, lowest power first"))
        rows[name] = row
    if problems:
        raise GeometryError("The transform cannot be used", problems)
    count = max(len(row) for row in rows.values())
    powers = np.stack([np.pad(row, (0, count - len(row))) for row in rows.values()], axis=1)
    # ξ = length (1 + s)/2, s from −1 to 1
    shifted = np.polynomial.Polynomial([length / 2.0, length / 2.0])
    series = np.zeros((count, len(NAMES)))
    for power, row in enumerate(powers):
        terms = chebyshev.poly2cheb((shifted**power).coef)
        series[: len(terms)] += terms[:, None] * row
    return Transform(series=Smooth(breaks=np.array([0.0, length]), coefficients=series[None]))


def _numbers(given: object) -> bool:
    return isinstance(given, list | tuple) and all(
        isinstance(x, int | float) and not isinstance(x, bool) for x in given
    )


def _entries(function: Callable[[float], ArrayLike], xi: float) -> Array:
    try:
        matrix = np.asarray(function(xi), float)
    except Exception as error:  # whatever a person's function may raise
        problem = Problem(f"transform({xi:.6g}) fails: {type(error).__name__}: {error}", "a matrix is needed")
        raise GeometryError("The transform cannot be used", [problem]) from error
    if matrix.shape == (2, 2):
        matrix = np.concatenate([matrix, np.zeros((2, 1))], axis=1)
    bad = matrix.shape == (3, 3) and not np.array_equal(matrix[2], [0.0, 0.0, 1.0])
    if bad or matrix.shape not in ((3, 3), (2, 3)):
        problem = Problem(
            f"transform({xi:.6g}) = {matrix.tolist()}",
            "[[f1, g1, h1], [f2, g2, h2], [0, 0, 1]] is needed: x' = f1 x + g1 y + h1, y' = f2 x + g2 y + h2",
        )
        raise GeometryError("The transform cannot be used", [problem])
    return matrix[:2].ravel()


def _linear(entries: Array) -> Array:
    return entries[..., [0, 1, 3, 4]].reshape(*entries.shape[:-1], 2, 2)

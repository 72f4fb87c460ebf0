"""Splines in Open CASCADE: curves in space and in the parameters of a surface, and the arrays they are made from."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ....arrays import Array
from ..kernel import kernel
from .bases import Basis


def spline_curve(basis: Basis, poles: Array) -> Any:
    """A spline of poles (n, 3) in space, parameter from 0 to 1."""
    from OCP.Geom import Geom_BSplineCurve

    points = kernel().points(1, len(poles))
    for i, (x, y, z) in enumerate(poles.tolist()):
        points.SetValue(i + 1, point(x, y, z))
    return Geom_BSplineCurve(points, numbers(basis.breaks), counts(basis.multiplicities), basis.degree)


def spline_curve_2d(basis: Basis, poles: Array, first: float, last: float) -> Any:
    """A spline of poles (n, 2) in a plane of parameters, its own parameter from first to last."""
    from OCP.Geom2d import Geom2d_BSplineCurve
    from OCP.gp import gp_Pnt2d

    points = kernel().points_2d(1, len(poles))
    for i, (x, y) in enumerate(poles.tolist()):
        points.SetValue(i + 1, gp_Pnt2d(x, y))
    breaks = [first + at * (last - first) for at in basis.breaks[:-1]] + [last]
    return Geom2d_BSplineCurve(points, numbers(breaks), counts(basis.multiplicities), basis.degree)


def point(x: float, y: float, z: float) -> Any:
    """A point in space."""
    from OCP.gp import gp_Pnt

    return gp_Pnt(x, y, z)


def numbers(values: Sequence[float]) -> Any:
    """An array of numbers."""
    array = kernel().numbers(1, len(values))
    for i, value in enumerate(values):
        array.SetValue(i + 1, value)
    return array


def counts(values: tuple[int, ...]) -> Any:
    """An array of whole numbers."""
    array = kernel().counts(1, len(values))
    for i, value in enumerate(values):
        array.SetValue(i + 1, value)
    return array

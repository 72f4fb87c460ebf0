"""The terms of four triangles at a time, in plain arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

from numba.extending import intrinsic

from ...arrays import Array
from .lanes import Lanes, Vector, adding
from .sums import ROWS

_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def _minus(p: Vector, q: Vector) -> Vector:
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def _dot(u: Vector, v: Vector) -> Lanes:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def _terms(a: Vector, b: Vector, c: Vector, origin: Vector) -> list[Lanes]:
    """The rows of `sums` for triangles a, b, c."""
    u, v = _minus(b, a), _minus(c, a)
    a, b, c = _minus(a, origin), _minus(b, origin), _minus(c, origin)
    s = a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]
    forth = u[1] * v[2], u[2] * v[0], u[0] * v[1]
    back = u[2] * v[1], u[0] * v[2], u[1] * v[0]
    n = _minus(forth, back)
    d = _dot(a, n)
    second = [a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j] for i, j in _PAIRS]
    size = sum((abs(a[k]) * (abs(forth[k]) + abs(back[k])) for k in (1, 2)), abs(a[0]) * (abs(forth[0]) + abs(back[0])))
    trace = second[0] + second[1] + second[2]
    return [d, *(d * x for x in s), *(d * x for x in second), *n, _dot(n, n).root(), size, size * trace]


def _take(so_far: list[Lanes], a: Vector, b: Vector, c: Vector, origin: Vector) -> list[Lanes]:
    return [total + term for total, term in zip(so_far, _terms(a, b, c, origin), strict=True)]


add_triangles = cast(
    "Callable[[Array, Any, int, int, Array, Array], None]", intrinsic(adding(ROWS, _take, exactly=False))
)
"""Adds triangles `start` to `stop` to sums (LANES · ROWS,) in lanes, row after row; see `lanes.adding`."""

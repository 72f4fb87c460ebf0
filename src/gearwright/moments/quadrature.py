"""Gauss–Legendre quadrature, and integrals whose nodes are increased until they settle."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array

_NODES = (10, 14, 20, 28, 40, 56, 80, 112, 160, 224)
_ROUNDING = 16.0 * np.finfo(float).eps  # what is left of a converged sum of some hundred terms


def converged(integral: Callable[[int], Array]) -> tuple[Array, float]:
    """The value of an integral as its nodes are increased until it settles, and its change at the end.

    integral   the value with so many nodes an arc; entries of the order of 1, so that one change measures all

    An integral that has not settled at the most nodes returns its last change, which then is its honest
    error bound.
    """
    value, change = integral(_NODES[0]), np.inf
    for nodes in _NODES[1:]:
        following = integral(nodes)
        scale = float(np.max(np.abs(following))) or 1.0
        change = float(np.max(np.abs(following - value))) / scale
        value = following
        if change <= _ROUNDING:
            break
    return value, max(change, 2.0 * float(np.finfo(float).eps))


_RULES: dict[int, tuple[Array, Array]] = {}


def gauss_legendre(nodes: int) -> tuple[Array, Array]:
    """Nodes and weights (n,) of the Gauss–Legendre rule on [−1, 1], kept after the first use."""
    if nodes not in _RULES:
        _RULES[nodes] = _polished(*np.polynomial.legendre.leggauss(nodes))
    return _RULES[nodes]


def _polished(x: Array, w: Array) -> tuple[Array, Array]:
    """A rule with the last digits set right, which numpy's loses as nodes are added."""
    n = len(x)
    for _ in range(2):
        value, slope = _legendre(n, x)
        x = x - value / slope
    _, slope = _legendre(n, x)
    x = (x - x[::-1]) / 2.0
    w = 2.0 / ((1.0 - x) * (1.0 + x) * slope**2)
    return x, w * (2.0 / np.sum(w))


def _legendre(n: int, x: Array) -> tuple[Array, Array]:
    """P_n(x) and its derivative, by the three-term recurrence."""
    before, value = np.ones_like(x), x
    for k in range(2, n + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, n * (x * value - before) / ((x - 1.0) * (x + 1.0))

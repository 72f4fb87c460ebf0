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


_COARSE, _FINE = 12, 20  # nodes a panel: the difference of the two rules is the error of the coarse one
_MOST_LEVELS = 40  # bisections
_MOST_PANELS = 4096  # panels bisected at once, beyond which the error is reported as it is


def adaptive(integrand: Callable[[Array], Array], breaks: Array, tolerance: float) -> tuple[Array, float, int]:
    """∫ integrand over [breaks[0], breaks[-1]], its error bound, and how many values were taken.

    integrand   x (n,) → values (n, ...), entries of the order of the first one
    breaks      ends of the first panels; where two Gauss–Legendre rules differ, panels are halved
    tolerance   relative to the first entry of the result

    The error bound, also relative to it, is the sum of the differences that were left: more than the tolerance
    only where an integrand is not smooth.
    """
    panels = np.stack([breaks[:-1], breaks[1:]], axis=1)
    settled, error, evaluations = 0.0, 0.0, 0
    for level in range(_MOST_LEVELS):
        coarse, fine = (_by_panel(integrand, panels, nodes) for nodes in (_COARSE, _FINE))
        evaluations += len(panels) * (_COARSE + _FINE)
        total = settled + fine.sum(axis=0)
        scale = abs(float(np.ravel(total)[0])) or 1.0
        difference = np.abs(fine - coarse).reshape(len(panels), -1).max(axis=1)
        share = np.maximum(np.diff(panels, axis=1)[:, 0] / (breaks[-1] - breaks[0]), 1.0 / _MOST_PANELS)
        rough = difference > tolerance * scale * share / 2.0
        if level == _MOST_LEVELS - 1 or np.count_nonzero(rough) > _MOST_PANELS:
            rough[:] = False
        settled = settled + fine[~rough].sum(axis=0)
        error += float(difference[~rough].sum()) / scale
        if not rough.any():
            break
        start, stop = panels[rough].T
        middle = (start + stop) / 2.0
        panels = np.concatenate([np.stack([start, middle], axis=1), np.stack([middle, stop], axis=1)])
    return np.asarray(settled), max(error, 2.0 * float(np.finfo(float).eps)), evaluations


def _by_panel(integrand: Callable[[Array], Array], panels: Array, nodes: int) -> Array:
    """The integral over each panel (n, ...) by one Gauss–Legendre rule."""
    x, w = gauss_legendre(nodes)
    half = np.diff(panels, axis=1) / 2.0
    values = integrand((panels.mean(axis=1)[:, None] + half * x).ravel())
    return np.asarray(np.einsum("pn,pn...->p...", half * w, values.reshape(len(panels), nodes, *values.shape[1:])))


_RULES: dict[int, tuple[Array, Array]] = {}


def gauss_legendre(nodes: int) -> tuple[Array, Array]:
    """Nodes and weights (n,) of the Gauss–Legendre rule on [−1, 1], kept after the first use, not to be written to."""
    if nodes not in _RULES:
        rule = _polished(*np.polynomial.legendre.leggauss(nodes))
        for values in rule:
            values.setflags(write=False)
        _RULES[nodes] = rule
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

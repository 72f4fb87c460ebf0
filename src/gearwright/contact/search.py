"""Signs and maxima of many functions of one variable at once: column i of arrays belongs to the i-th one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..arrays import Array, Indices
from ..curves.crossing import crossing

Function = Callable[[Array], Array]

_GOLDEN = (3.0 - np.sqrt(5.0)) / 2.0


def stretches(function: Callable[[Indices, Array], Array], grid: Array) -> tuple[Indices, Array, Array]:
    """(columns, low, high) (m,) of the stretches on which functions are ≥ 0, found at the nodes grid (k, n).

    function   values (m,) of functions of columns (m,) at x (m,)

    A stretch is a run of nodes, reaching on either side to where the sign changes; shorter ones between two nodes are
    passed over. A column has none, one or several.
    """
    every = np.arange(grid.shape[1], dtype=np.int64)
    values = function(np.tile(every, len(grid)), grid.ravel()).reshape(grid.shape)
    good = np.pad(values >= 0.0, ((1, 1), (0, 0)))
    columns, first = np.nonzero((good[1:-1] & ~good[:-2]).T)
    _, last = np.nonzero((good[1:-1] & ~good[2:]).T)
    low, high = grid[first, columns], grid[last, columns]
    for ends, rows, step in ((low, first, -1), (high, last, 1)):
        cut = np.flatnonzero((rows + step >= 0) & (rows + step < len(grid)))
        if len(cut):
            outside = grid[rows[cut] + step, columns[cut]]
            ends[cut] = crossing(lambda x, at=columns[cut]: function(at, x), outside, ends[cut])  # type: ignore[misc]
    return columns, low, high


def largest(function: Function, low: Array, high: Array, *, nodes: int, steps: int) -> tuple[Array, Array]:
    """(x, value) of the greatest value between low and high (n,), both ends among the candidates.

    The best of so many nodes, denser towards the ends, and golden section about it in so many steps; a function may
    be −∞ where it has no value. The value of a smooth maximum is then good to the square of the width left.
    """
    fractions = (1.0 - np.cos(np.linspace(0.0, np.pi, nodes))) / 2.0
    grid = low + fractions[:, None] * (high - low)
    grid[-1] = high
    values = np.stack([function(x) for x in grid])
    best, columns = np.argmax(values, axis=0), np.arange(len(low))
    middle, at_middle = grid[best, columns], values[best, columns]
    left, right = grid[np.maximum(best - 1, 0), columns], grid[np.minimum(best + 1, nodes - 1), columns]
    for _ in range(steps):
        above = right - middle > middle - left
        x = middle + _GOLDEN * np.where(above, right - middle, left - middle)
        at_x = function(x)
        better = at_x > at_middle
        left = np.where(above & better, middle, np.where(~above & ~better, x, left))
        right = np.where(~above & better, middle, np.where(above & ~better, x, right))
        middle, at_middle = np.where(better, x, middle), np.where(better, at_x, at_middle)
    return middle, at_middle

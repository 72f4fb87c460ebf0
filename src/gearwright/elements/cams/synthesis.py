"""The cam of least area: free dimensions and a free law."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from .laws import FIXED_LAWS, SPLINE
from .led import Movement
from .optimum import Optimum, Task
from .search import Search
from .spline_law import fitted_values


def least_area(task: Task, law: str, count: int) -> Optimum:
    """The optimum with a fixed law, over the free dimensions; the best of those from several starts."""
    search = Search(task=task, law=law, movement=_movement(task, law, count))
    return _best(search.run(np.concatenate([start, search.values])) for start in task.freedom.starts())


def least_area_spline(task: Task, fixed: Mapping[str, Optimum], count: int) -> Optimum:
    """The optimum with free splines, begun from those with fixed laws, and from an even rise.

    A spline of few values fits no law well, and a search may end where it should not: then a fixed law's is better.
    """
    search = Search(task=task, law=SPLINE, movement=_movement(task, SPLINE, count))
    moves = search.movement.values // count
    x = np.linspace(0.0, 1.0, 201)
    starts = []
    for name, optimum in sorted(fixed.items(), key=lambda one: (not one[1].keeps_limits, one[1].area)):
        shape = fitted_values(FIXED_LAWS[name].derivatives(x), x, count)
        starts.append(np.concatenate([search.variables(optimum.dimensions), np.tile(shape, moves)]))
    found = [search.run(start) for start in starts[:2]]
    if not any(one.keeps_limits for one in found):
        found += [search.run(np.concatenate([s, search.values])) for s in task.freedom.starts()]
    return _best([*found, *fixed.values()])


def _best(found: Iterable[Optimum]) -> Optimum:
    """Of those that keep the limits the smallest; else the one that misses them least."""
    return min(found, key=lambda one: (not one.keeps_limits, one.area if one.keeps_limits else one.shortfall))


def _movement(task: Task, law: str, count: int) -> Movement:
    fixed = FIXED_LAWS.get(law)
    return Movement(steps=task.steps, unit=task.unit, law=fixed, count=0 if fixed else count)

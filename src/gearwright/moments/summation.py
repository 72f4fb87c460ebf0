"""Sums over many faces, in chunks, by several threads.

The chunks do not depend on the number of threads and are merged in their order, without loss: so neither does the
result, to the last bit. Few faces are summed at once by the caller's own thread.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import chain, pairwise
from typing import NamedTuple, TypeVar

import numpy as np

from ..arrays import Array
from . import compensated

CHUNK = 1 << 15
"""Faces a chunk: about 0.1 ms of work, many times what a call costs."""

_MANY = 32
"""Chunks a thread from which on they are handed out in more than one lot."""

_Part = TypeVar("_Part")


class Sums(NamedTuple):
    """Sums (16,), rows as in `kernels.sums`: their exact values are high + low, to about 32 digits."""

    high: Array
    low: Array

    @property
    def rounded(self) -> Array:
        with np.errstate(invalid="ignore"):
            return self.high + self.low


def nothing() -> Sums:
    """Sums over no faces."""
    return Sums(np.zeros(16), np.zeros(16))


def merged(parts: Iterable[Sums]) -> Sums:
    """The sums over several lots of faces together."""
    high, low = nothing()
    with np.errstate(invalid="ignore"):  # sums over coordinates that are not finite
        for part in parts:
            high, error = compensated.two_sum(high, part.high)
            low = low + (error + part.low)
    return Sums(high, low)


def in_chunks(part: Callable[[int, int], _Part], count: int, threads: int | None) -> list[_Part]:
    """What a function gives for the chunks of `count` faces, by first face and the one after the last, in order.

    threads   None for as many as there are processors for this process
    """
    starts = range(0, count, CHUNK)
    threads = min(threads or processors(), len(starts))

    def run(first: int, after: int) -> list[_Part]:
        return [part(start, min(start + CHUNK, count)) for start in starts[first:after]]

    if threads <= 1:
        return run(0, len(starts))
    # one lot a thread, the caller's own among them; of very many chunks several, so that no thread waits for long
    lots = threads if len(starts) < _MANY * threads else 4 * threads
    bounds = [len(starts) * lot // lots for lot in range(lots + 1)]
    others = [_pool(threads - 1).submit(run, first, after) for first, after in pairwise(bounds[1:])]
    return [*run(0, bounds[1]), *chain.from_iterable(other.result() for other in others)]


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@cache
def _pool(threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads, thread_name_prefix="gearwright")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_pool.cache_clear)  # a forked process has none of its parent's threads

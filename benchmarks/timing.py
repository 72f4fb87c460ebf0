"""How the benchmarks time things: repeated, in one process, medians."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable


def median_seconds(action: Callable[[], object], repeats: int, warm_up: int = 1) -> float:
    """Median wall-clock seconds of an action over so many runs, after warm-up runs that do not count."""
    for _ in range(warm_up):
        action()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return statistics.median(times)

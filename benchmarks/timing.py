"""How the benchmarks time things: repeated, in one process, medians; peers with an interpreter of their own in it."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any


def median_seconds(
    action: Callable[[], object],
    repeats: int,
    warm_up: int = 1,
    clock: Callable[[], float] = time.perf_counter,
) -> float:
    """Median seconds of an action over so many runs, after warm-up runs that do not count.

    clock   the wall's; `time.process_time` where others keep the machine busy
    """
    for _ in range(warm_up):
        action()
    times = []
    for _ in range(repeats):
        start = clock()
        action()
        times.append(clock() - start)
    return statistics.median(times)


def of_peer(script: str, measure: Callable[[], Any]) -> Any:
    """What `measure` gives, as JSON has it: here, or of the script under the interpreter named as its argument.

    Called there with `--peer`, it prints the same and ends.
    """
    if sys.argv[1:] == ["--peer"]:
        print(json.dumps(measure()))
        raise SystemExit
    if not sys.argv[1:]:
        return json.loads(json.dumps(measure()))
    command = [sys.argv[1], script, "--peer"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)  # noqa: S603  the caller's interpreter
    return json.loads(done.stdout.splitlines()[-1])

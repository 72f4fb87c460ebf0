"""CPU seconds of `gearwright --help` as a whole process, beside an interpreter that does nothing."""

from __future__ import annotations

import resource
import statistics
import subprocess
import sys

RUNS = 11


def median_cpu_seconds(command: list[str]) -> float:
    """Median of user and system time over RUNS processes, after one warm-up."""
    seconds = []
    for run in range(RUNS + 1):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, capture_output=True)  # noqa: S603  the command is our own
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if run:
            seconds.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return statistics.median(seconds)


def main() -> None:
    """Prints medians and the ratio."""
    ours = median_cpu_seconds([sys.executable, "-m", "gearwright", "--help"])
    bare = median_cpu_seconds([sys.executable, "-c", "pass"])
    print(f"gearwright --help {ours:.3f} s CPU, python -c pass {bare:.3f} s, ratio {ours / bare:.1f}")


if __name__ == "__main__":
    main()

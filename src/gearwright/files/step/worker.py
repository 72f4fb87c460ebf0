"""The process that runs Open CASCADE: a STEP file on its standard input, what is found in it on its standard output."""

from __future__ import annotations

import os
import sys
from contextlib import suppress

from ...errors import GearwrightError
from .exchange import packed
from .solids import found_in

MOST_MEMORY = 8 << 30
"""Bytes that it may take, where the system can hold it to a limit."""


def main() -> None:
    """Reads the file whose name for messages is the last argument."""
    _limit_memory()
    answer = os.dup(1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)  # whatever the kernel prints
    try:
        result = packed(found_in(sys.stdin.buffer.read(), sys.argv[-1]))
    except GearwrightError as error:
        result = packed(error)
    with os.fdopen(answer, "wb") as stream:
        stream.write(result)
        stream.flush()
        os._exit(0)  # not through the kernel's destructors, which can crash after damaged files


def _limit_memory() -> None:
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))


if __name__ == "__main__":
    main()

"""Functions that are compiled when they are first called, and kept on the disk.

The compiler's own cache looks at the file of a function alone. A function that calls others in other files would
stay what it was when those change, by an update for instance, and answer wrongly; here it is compiled anew when any
module of this package has changed that its own one uses. Where no folder can be written, nothing is kept.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, cast

_PACKAGE = __name__.rpartition(".")[0]

_Function = TypeVar("_Function", bound=Callable[..., Any])

_told: list[Callable[[bool], None]] = []


@contextmanager
def telling(listener: Callable[[bool], None]) -> Iterator[None]:
    """Has a listener called with True when a function begins to be compiled, with False when it is."""
    _told.append(listener)
    try:
        yield
    finally:
        _told.remove(listener)


def compiled(function: _Function) -> _Function:
    """The function compiled for the types it is called with; it lets other threads run meanwhile.

    Division follows IEEE 754: by zero it gives an infinity or NaN.
    """
    from numba import njit

    _watch()
    dispatcher: Any = njit(nogil=True, error_model="numpy")(function)
    try:
        dispatcher.enable_caching()
        file = dispatcher._cache._cache_file  # noqa: SLF001  there is no public way to say what a cache depends on
        file._source_stamp = (file._source_stamp, _stamps(function.__module__))  # noqa: SLF001
    except (AttributeError, RuntimeError):
        dispatcher = njit(nogil=True, error_model="numpy")(function)
    return cast("_Function", dispatcher)


def _stamps(name: str) -> list[tuple[str, int, int]]:
    """Time and size of the files of a module and of all modules of the package that it uses, directly or not."""
    found: dict[str, tuple[int, int]] = {}
    waiting = [name]
    while waiting:
        module = sys.modules.get(waiting.pop())
        if module is None or module.__name__ in found or not module.__file__:
            continue
        status = Path(module.__file__).stat()
        found[module.__name__] = (status.st_mtime_ns, status.st_size)
        for value in vars(module).values():
            home = getattr(value, "__module__", None) or getattr(value, "__name__", None)
            if isinstance(home, str) and home.startswith(_PACKAGE + "."):
                waiting.append(home)
    return sorted((name, *stamp) for name, stamp in found.items())


@cache
def _watch() -> None:
    """Has the compiler say when it works, once."""
    from numba.core import event

    class Watcher(event.Listener):
        depth = 0

        def on_start(self, _: Any) -> None:
            self.depth += 1
            if self.depth == 1:
                for listener in _told:
                    listener(True)

        def on_end(self, _: Any) -> None:
            self.depth -= 1
            if self.depth == 0:
                for listener in _told:
                    listener(False)

    event.register("numba:compile", Watcher())  # type: ignore[no-untyped-call]

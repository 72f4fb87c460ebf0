"""What runs in a worker process: one job after another, each a generator whose answers are sent as they come."""

from __future__ import annotations

import os
import queue
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Iterator
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from ..compiled import telling
from ..errors import GearwrightError
from ..sources import load
from .hidden_folders import folders_of, without
from .refusals import refused

COMPILING = {"answer": "stage", "text": "compiling for this machine, once"}
OUT_OF_MEMORY = (
    "There is not enough memory for this. Fewer teeth or a simpler section need less, and so do files of a coarser "
    "tolerance."
)

Answer = bytes | dict[str, Any]


def main(connection: Connection, memory: int, warm: str | None) -> None:
    """Does jobs until the other side ends.

    memory   bytes of address space at most, where the system can bound them
    warm     the Source of a function that loads what jobs need, before the first
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's, which ends its workers
    _end_with_parent()
    if not _debugging():
        warnings.simplefilter("ignore")  # they name lines of the source, on a terminal where nobody can tell of what
    _bound(memory)
    waiting: queue.SimpleQueue[tuple[int, str, Any]] = queue.SimpleQueue()
    cancelled: set[int] = set()
    threading.Thread(target=_listen, args=(connection, waiting, cancelled), daemon=True).start()
    with telling(lambda begins: _send(connection, None, "answer", COMPILING) if begins else None):
        if warm is not None:
            with suppress(Exception):  # jobs find out what is wrong, and say it
                load(warm)()
        _send(connection, None, "ready", None)
        while True:
            number, source, request = waiting.get()
            _do(connection, number, source, request, cancelled)
            cancelled.discard(number)


def _listen(connection: Connection, waiting: queue.SimpleQueue[tuple[int, str, Any]], cancelled: set[int]) -> None:
    """Takes jobs and cancellations, also while a job runs, and ends the process with the server's."""
    while True:
        try:
            number, source, request = connection.recv()
        except (EOFError, OSError):
            os._exit(0)
        if source is None:
            cancelled.add(number)
        else:
            waiting.put((number, source, request))


def _do(connection: Connection, number: int, source: str, request: Any, cancelled: set[int]) -> None:
    try:
        answers: Iterator[Answer] = load(source)(request)
        for answer in answers:
            if number in cancelled:
                break
            _send(connection, number, "answer", answer)
        _send(connection, number, "end", None)
    except GearwrightError as error:
        _trace(error)
        _send(connection, number, "refused", refused(error, _parameters(request)))
    except MemoryError as error:
        _trace(error)
        _send(connection, number, "lost", OUT_OF_MEMORY)
        os._exit(1)  # what is left of the heap is not to be relied on
    except Exception as error:  # noqa: BLE001  an edge: everything becomes an answer
        _trace(error)
        where = "GEARWRIGHT_DEBUG=1 at the server's start shows where"
        what = without(f"{type(error).__name__}: {error}", folders_of(request))
        text = f"Gearwright failed, and the fault is its own ({what}); {where}."
        _send(connection, number, "failed", text)


def _parameters(request: Any) -> set[str]:
    """The names of all parameters of the kind that a request is about."""
    from ..designs.design import design_of
    from ..designs.kinds import parameter_names

    try:
        inner = request.get("request", request)  # of one that was admitted
        return {name for kind in design_of(inner["design"]).kinds for name in parameter_names(kind)}
    except (GearwrightError, KeyError, TypeError, AttributeError):
        return set()


def _send(connection: Connection, number: int | None, word: str, value: object) -> None:
    try:
        connection.send((number, word, value))
    except OSError:
        os._exit(0)  # the server has gone


def _trace(error: BaseException) -> None:
    if _debugging():
        traceback.print_exception(error)


def _debugging() -> bool:
    return os.environ.get("GEARWRIGHT_DEBUG") == "1"


def _end_with_parent() -> None:
    """Has the system end the process with the one that made it, should compiled code keep it from noticing.

    That one ends with the server, unless a copy of what it watches is kept open here.
    """
    if sys.platform != "linux":
        return
    with suppress(OSError, AttributeError, ImportError):
        import ctypes
        from multiprocessing import forkserver

        maker: Any = forkserver._forkserver  # noqa: SLF001  there is no public way
        if maker._forkserver_alive_fd is not None:  # noqa: SLF001
            os.close(maker._forkserver_alive_fd)  # noqa: SLF001
            maker._forkserver_alive_fd = None  # noqa: SLF001
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


def _bound(memory: int) -> None:
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (memory, resource.getrlimit(resource.RLIMIT_AS)[1]))

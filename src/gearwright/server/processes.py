"""A worker process as the server holds it: a pipe, and a thread that reads from it."""

from __future__ import annotations

import asyncio
import multiprocessing
import threading
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any, final

from ..library_threads import one_thread
from .worker import main

_PRELOAD = ["gearwright.server.preload"]
_JOIN = 5.0  # seconds for the system to end a killed process

Arrived = Callable[["Process", int | None, str, Any], None]
Lost = Callable[["Process"], None]


def _context() -> Any:
    """Processes are made by one that has loaded the libraries, where the system has that, and never by ours."""
    methods = multiprocessing.get_all_start_methods()
    if "forkserver" not in methods:
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(_PRELOAD)
    return context


@final
class Process:
    """One worker.

    ready, gone   whether it takes jobs, whether it has ended; set by those who are told so
    """

    def __init__(self, memory: int, warm: str | None):
        self.ready = self.gone = False
        self._arguments = (memory, warm)
        self._process: Any = None
        self._connection: Connection | None = None
        self._thread: threading.Thread | None = None

    @property
    def pid(self) -> int:
        return int(self._process.pid)

    def start(self, loop: asyncio.AbstractEventLoop, arrived: Arrived, lost: Lost) -> None:
        """Starts it, which takes its time: not for the loop's own thread. What it sends is told in the loop."""
        one_thread()
        context = _context()
        ours, theirs = context.Pipe(duplex=True)
        process = context.Process(target=main, args=(theirs, *self._arguments), daemon=True, name="gearwright worker")
        try:
            process.start()
        except BaseException:
            ours.close()
            raise
        finally:
            theirs.close()
        self._process, self._connection = process, ours
        self._thread = threading.Thread(target=self._read, args=(ours, loop, arrived, lost), daemon=True)
        self._thread.start()

    def _read(self, connection: Connection, loop: asyncio.AbstractEventLoop, arrived: Arrived, lost: Lost) -> None:
        with suppress(RuntimeError):  # the loop has ended
            try:
                while True:
                    number, word, value = connection.recv()
                    loop.call_soon_threadsafe(arrived, self, number, word, value)
            except (EOFError, OSError, TypeError):
                loop.call_soon_threadsafe(lost, self)

    def send(self, message: tuple[int, str | None, Any]) -> None:
        """Sends a job or a cancellation; a worker that has gone is told by `lost`."""
        if self._connection is not None:
            with suppress(OSError):
                self._connection.send(message)

    def kill(self) -> None:
        """Ends it at once."""
        if self._process is not None:
            self._process.kill()

    def end(self) -> None:
        """Ends it and waits for that: not for the loop's own thread."""
        if self._process is None:
            return
        self._process.kill()
        self._process.join(_JOIN)
        if self._thread is not None:
            self._thread.join(_JOIN)
        if self._connection is not None:
            self._connection.close()

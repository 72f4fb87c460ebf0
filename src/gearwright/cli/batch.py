"""Many tasks done by processes, their results in the order of the tasks."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from typing import Generic, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")

_AHEAD = 4
"""Tasks begun for each worker before the first result is taken: more would only fill the memory."""


def in_order(
    tasks: Sequence[Task], work: Callable[[Task], Result], jobs: int, lost: Callable[[Task, int], Result]
) -> Generator[Result]:
    """What `work` gives for every task, in their order, done by so many processes at once; by this one for jobs = 1.

    work  sent to the processes, so a function of a module or a partial of one; it must raise nothing
    lost  what stands for a task whose process was killed, from the task and the process's exit code

    Each worker has a pipe of its own, so that it is known which task a killed one had; another takes its place. When
    the iterator is closed, or an interrupt arrives, the processes are ended.
    """
    if jobs == 1:
        yield from map(work, tasks)
        return
    pool: _Pool[Task, Result] = _Pool(work, lost, jobs)
    try:
        done: dict[int, Result] = {}
        begun = 0
        for number in range(len(tasks)):
            while number not in done:
                while begun < len(tasks) and begun < number + _AHEAD * jobs and pool.idle:
                    pool.begin(begun, tasks[begun])
                    begun += 1
                done |= pool.finished()
            yield done.pop(number)
    finally:
        pool.end()


class _Pool(Generic[Task, Result]):
    """So many processes, started when there is work for them."""

    def __init__(self, work: Callable[[Task], Result], lost: Callable[[Task, int], Result], jobs: int):
        self._work, self._lost, self._jobs = work, lost, jobs
        # forked from a process that has threads, numerical libraries may hang
        self._context = multiprocessing.get_context("spawn")
        self._free: list[_Worker] = []
        self._busy: dict[object, tuple[_Worker, int, Task]] = {}  # by their pipes

    @property
    def idle(self) -> bool:
        """Whether one more task can begin now."""
        return len(self._busy) < self._jobs

    def begin(self, number: int, task: Task) -> None:
        """Gives a task to a worker."""
        worker = self._free.pop() if self._free else _Worker(self._context, self._work)
        with suppress(OSError):  # a worker killed while it was idle: the end of its pipe tells
            worker.pipe.send(task)
        self._busy[worker.pipe] = (worker, number, task)

    def finished(self) -> dict[int, Result]:
        """Waits for a worker, and gives the results there are by the numbers of their tasks."""
        results = {}
        for pipe in wait([worker.pipe for worker, _, _ in self._busy.values()]):
            worker, number, task = self._busy.pop(pipe)
            try:
                results[number] = worker.pipe.recv()
                self._free.append(worker)
            except (EOFError, OSError):
                results[number] = self._lost(task, worker.end())
        return results

    def end(self) -> None:
        """Ends all processes, whatever they are doing."""
        for worker in [*self._free, *(worker for worker, _, _ in self._busy.values())]:
            worker.end()


class _Worker:
    """A process and this end of its pipe."""

    def __init__(self, context: multiprocessing.context.SpawnContext, work: Callable[[Task], Result]):
        self.pipe, far = context.Pipe()
        self._process = context.Process(target=_serve, args=(far, work), daemon=True)
        with _interrupts_held():
            self._process.start()
        far.close()  # so that the pipe ends with the process

    def end(self) -> int:
        """Ends the process, if it has not ended, and gives its exit code."""
        self.pipe.close()
        self._process.join(timeout=0.2)
        if self._process.exitcode is None:
            self._process.kill()
            self._process.join()
        return self._process.exitcode or 0


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """Keeps an interrupt back until the block ends; a process that is started in it begins with them kept back."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # which lets interrupts through when it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(pipe: Connection, work: Callable[[Task], Result]) -> None:
    """Does tasks until the pipe ends. Interrupts are for the process that started this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(EOFError, OSError):
        while True:
            pipe.send(work(pipe.recv()))

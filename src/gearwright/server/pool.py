"""Worker processes and the jobs that wait for them, in one event loop."""

from __future__ import annotations

import asyncio
import itertools
from collections import deque
from dataclasses import dataclass
from typing import Any, final

from .job import Job, Rank
from .outcomes import BusyError, JobCancelledError, JobFailedError, JobRefusedError
from .processes import Process

GRACE = 2.0
"""Seconds that a cancelled job has to its next answer, before its worker is killed: longer than a bit of an answer
takes on a busy machine, since another worker takes about as long to start."""

MEMORY = 6 << 30
"""Bytes of address space that a worker may take."""

PATIENCE = 2.0
"""Seconds that a job waits before those who asked are told so."""

WAITING = {"answer": "stage", "text": "waiting for a free worker"}

LESS = "fewer teeth or a simpler section"
"""What makes any job shorter."""

_AGAIN = 1.0  # seconds until a worker that could not be started is tried again

GONE = "The worker that did this was lost: it crashed, or the system ended it, as when memory runs out."


@dataclass(frozen=True, kw_only=True)
class Numbers:
    """A pool at one moment: processes that live, those busy, how many were replaced so far, jobs that wait."""

    alive: int
    busy: int
    replaced: int
    waiting: int


@final
class Pool:
    """So many workers, and spare ones that step in for those lost.

    Jobs are begun by their rank and in the order they came. kept   workers that have none of the last rank
    """

    def __init__(
        self,
        size: int,
        *,
        spares: int = 0,
        kept: int = 0,
        memory: int = MEMORY,
        most_waiting: int = 256,
        grace: float = GRACE,
        patience: float = PATIENCE,
        warm: str | None = "gearwright.server.warming:warm",
    ):
        self._size, self._spares, self._most_waiting, self._grace = size, spares, most_waiting, grace
        self._memory, self._warm, self._patience = memory, warm, patience
        self._most_others = max(1, size - kept)
        self._processes: list[Process] = []
        self._running: dict[Process, Job] = {}
        self._waiting: deque[Job] = deque()
        self._timers: dict[Job, list[asyncio.TimerHandle]] = {}
        self._numbers = itertools.count(1)
        self._tasks: set[asyncio.Task[None]] = set()
        self._replaced = 0
        self._closed = False

    @property
    def numbers(self) -> Numbers:
        """How it is doing."""
        return Numbers(
            alive=len(self._processes), busy=len(self._running), replaced=self._replaced, waiting=len(self._waiting)
        )

    @property
    def crowded(self) -> bool:
        """Whether others wait for what they look at."""
        return any(one.rank is Rank.SHOWN for one in self._waiting)

    def start(self) -> None:
        """Begins to start the workers; jobs can be submitted at once."""
        for _ in range(self._size):
            self._start_one()

    def submit(self, source: str, request: Any, *, seconds: float, rank: Rank = Rank.OTHER, less: str = LESS) -> Job:
        """A job for the next free worker.

        source    of a generator function of the request
        seconds   after which its worker is killed
        rank      whether somebody looks at what it answers
        less      what to ask for where it takes too long

        Raises BusyError where too many of its rank wait.
        """
        if self._closed or sum(one.rank is rank for one in self._waiting) >= self._most_waiting:
            raise BusyError("The server is busy; try again in a few seconds.")
        job = Job(next(self._numbers), source, request, self._cancel, seconds=seconds, rank=rank, less=less)
        self._waiting.append(job)
        self._dispatch()
        if job in self._waiting:
            self._tell_later(job)
        return job

    async def close(self) -> None:
        """Kills all workers and ends all jobs."""
        self._closed = True
        for job in [*self._waiting, *self._running.values()]:
            self._forget_timers(job)
            job.end(JobCancelledError("The server ends."))
        self._waiting.clear()
        processes, self._processes = self._processes, []
        for one in processes:
            one.kill()
        await asyncio.gather(*(asyncio.to_thread(one.end) for one in processes), *self._tasks)

    def _start_spares(self) -> None:
        """Once, when the first worker is ready, so as not to hold it up."""
        spares, self._spares = self._spares, 0
        for _ in range(spares):
            self._start_one()

    def _start_one(self) -> None:
        if self._closed:
            return
        task = asyncio.ensure_future(self._started())
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _started(self) -> None:
        loop = asyncio.get_running_loop()
        process = Process(self._memory, self._warm)
        try:
            await asyncio.to_thread(process.start, loop, self._arrived, self._lost)
        except (OSError, EOFError, RuntimeError):  # no more processes: try again, rather than lose a worker for good
            process.gone = True
        if self._closed:
            await asyncio.to_thread(process.end)
            return
        if process.gone:
            loop.call_later(_AGAIN, self._start_one)
            return
        self._processes.append(process)
        self._dispatch()

    def _dispatch(self) -> None:
        """Gives waiting jobs to free workers, never more than there are to be busy."""
        free = [one for one in self._processes if one.ready and one not in self._running]
        while free and len(self._running) < self._size and (job := self._next()) is not None:
            process = free.pop(0)
            self._waiting.remove(job)
            self._forget_timers(job)
            self._running[process] = job
            loop = asyncio.get_running_loop()
            self._timers[job] = [loop.call_later(job.seconds, self._too_long, process, job)]
            process.send((job.number, job.source, job.request))

    def _next(self) -> Job | None:
        """The job that waits for the next free worker; None where that is kept for such as somebody looks at."""
        found = min(self._waiting, key=lambda job: job.rank, default=None)
        others = sum(job.rank is Rank.OTHER for job in self._running.values())
        return None if found is not None and found.rank is Rank.OTHER and others >= self._most_others else found

    def _tell_later(self, job: Job) -> None:
        loop = asyncio.get_running_loop()
        self._timers[job] = [loop.call_later(self._patience, self._tell_waiting, job)]

    def _tell_waiting(self, job: Job) -> None:
        if any(one.ready for one in self._processes):
            job.put(WAITING)
        else:
            self._tell_later(job)  # workers start, and say themselves where that takes long

    def _arrived(self, process: Process, number: int | None, word: str, value: Any) -> None:
        """What a worker has sent."""
        if number is None:
            if word == "ready":
                process.ready = True
                self._dispatch()
                self._start_spares()
            elif process in self._running:
                self._running[process].put(value)
            elif not any(one.ready for one in self._processes):
                for waiting in self._waiting:
                    waiting.put(value)
            return
        job = self._running.get(process)
        if job is None or job.number != number:
            return
        match word:
            case "answer":
                job.put(value)
                return
            case "end":
                job.end()
            case "refused":
                job.end(JobRefusedError(value["headline"], value["problems"]))
            case "failed":
                job.end(JobFailedError(value))
            case "lost":
                job.end(JobFailedError(value, lost=True))
                self._replace(process)
                return
        self._free(process)

    def _free(self, process: Process) -> None:
        self._forget_timers(self._running.pop(process))
        self._dispatch()

    def _forget_timers(self, job: Job) -> None:
        for timer in self._timers.pop(job, []):
            timer.cancel()

    def _lost(self, process: Process) -> None:
        """A worker has ended by itself."""
        if job := self._running.get(process):
            job.end(JobFailedError(GONE, lost=True))
        self._replace(process)

    def _replace(self, process: Process) -> None:
        """Ends a worker, and what it does, and starts another; a spare one takes its place meanwhile."""
        process.gone = True
        if self._closed or process not in self._processes:
            return
        self._processes.remove(process)
        if job := self._running.pop(process, None):
            self._forget_timers(job)
            job.end(JobCancelledError("cancelled"))
        self._replaced += 1
        process.kill()
        ending = asyncio.ensure_future(asyncio.to_thread(process.end))
        self._tasks.add(ending)
        ending.add_done_callback(self._tasks.discard)
        delay = 0.0 if process.ready else _AGAIN  # where none can start, none is to be tried without end
        asyncio.get_running_loop().call_later(delay, self._start_one)
        self._dispatch()

    def _too_long(self, process: Process, job: Job) -> None:
        if self._running.get(process) is job:
            text = f"This took longer than {job.seconds:g} s and was stopped; ask for less, such as {job.less}."
            job.end(JobFailedError(text, lost=True))
            self._replace(process)

    def _cancel(self, job: Job) -> None:
        if job in self._waiting:
            self._waiting.remove(job)
            self._forget_timers(job)
            job.end(JobCancelledError("cancelled"))
            return
        for process, running in self._running.items():
            if running is job:
                process.send((job.number, None, None))
                loop = asyncio.get_running_loop()
                self._timers[job].append(loop.call_later(self._grace, self._graceless, process, job))

    def _graceless(self, process: Process, job: Job) -> None:
        if self._running.get(process) is job:
            job.end(JobCancelledError("cancelled"))
            self._replace(process)

"""A job as those who asked for it see it: its answers as they come, and how it ended."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from enum import IntEnum
from typing import Any, final

from .outcomes import JobCancelledError, JobError, JobFailedError
from .worker import Answer

MOST_UNREAD = 512 << 20
"""Bytes of answers that may wait to be taken."""


class Rank(IntEnum):
    """Which of the jobs that wait is done next."""

    SHOWN = 0  # somebody looks at where it will appear
    BESIDE = 1  # what is told besides
    OTHER = 2


@final
class Job:
    """Answers of a worker, to be taken by `async for`, which raises JobError where it did not end by itself.

    number, source, request   as the worker gets them
    seconds                   how long it may run
    rank                      lower ones go first
    less                      what to ask for where it takes too long
    """

    def __init__(
        self,
        number: int,
        source: str,
        request: Any,
        cancel: Callable[[Job], None],
        *,
        seconds: float,
        rank: Rank,
        less: str,
    ):
        self.number, self.source, self.request = number, source, request
        self.seconds, self.rank, self.less = seconds, rank, less
        self.ended = asyncio.Event()
        self.cancelled = False
        self._cancel = cancel
        self._unread = 0
        self._answers: asyncio.Queue[Answer | JobError | None] = asyncio.Queue()

    def cancel(self) -> None:
        """Ends it: at once for those who asked, for its worker at its next answer or after a grace."""
        if not self.ended.is_set() and not self.cancelled:
            self.cancelled = True
            self._answers.put_nowait(JobCancelledError("cancelled"))
            self._cancel(self)

    def put(self, answer: Answer) -> None:
        """Hands on an answer."""
        if self.ended.is_set() or self.cancelled:
            return
        self._unread += len(answer) if isinstance(answer, bytes) else 0
        if self._unread > MOST_UNREAD:
            self.end(JobFailedError("The answer is too large for this connection."))
            self._cancel(self)
            return
        self._answers.put_nowait(answer)

    def end(self, how: JobError | None = None) -> None:
        """There are no more answers. how   None where it ended by itself"""
        if not self.ended.is_set():
            self.ended.set()
            self._answers.put_nowait(JobCancelledError("cancelled") if self.cancelled else how)

    async def __aiter__(self) -> AsyncIterator[Answer]:
        while True:
            answer = await self._answers.get()
            if answer is None:
                return
            if isinstance(answer, JobError):
                raise answer
            self._unread -= len(answer) if isinstance(answer, bytes) else 0
            yield answer

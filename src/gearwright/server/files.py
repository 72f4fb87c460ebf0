"""Files that are made for the page: begun, told about, fetched, cancelled and forgotten."""

from __future__ import annotations

import asyncio
import secrets
import shutil
import time
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, final

from .job import Job
from .outcomes import BusyError, JobCancelledError, JobFailedError, JobRefusedError
from .own_folder import made_sure
from .pool import WAITING, Pool

SECONDS = 600.0
_KEPT = 600.0  # seconds, once done
_MOST = 50
_LESS = "a coarser tolerance"
_MOST_BYTES = 2 << 30

State = Literal["waiting", "working", "done", "failed", "cancelled"]


@dataclass(kw_only=True, eq=False)
class FileJob:
    """A file that is made or is there. name, path   once it is done; held   bytes on the disk, then"""

    id: str
    folder: Path
    job: Job
    begun: float
    state: State = "waiting"
    stage: str = ""
    name: str = ""
    path: Path | None = None
    seconds: float | None = None
    headline: str | None = None
    problems: list[dict[str, Any]] = field(default_factory=list)
    task: asyncio.Task[None] | None = None
    held: int = 0

    @property
    def over(self) -> bool:
        return self.state not in ("waiting", "working")

    def told(self) -> dict[str, Any]:
        """As the page is told."""
        seconds = time.monotonic() - self.begun if self.seconds is None else self.seconds
        return {
            "state": self.state,
            "stage": self.stage,
            "seconds": round(seconds, 3),
            "name": self.name or None,
            "bytes": self.path.stat().st_size if self.path is not None else None,
            "headline": self.headline,
            "problems": self.problems,
        }


@final
class Files:
    """Files by their ids, in a folder that nobody else reads.

    kept         seconds for which one is kept
    most         number of them, made and being made
    most_bytes   on the disk, beyond which the oldest are forgotten; the newest stays whatever its size
    seconds      that one may take
    """

    def __init__(
        self,
        folder: Path,
        pool: Pool,
        *,
        kept: float = _KEPT,
        most: int = _MOST,
        most_bytes: int = _MOST_BYTES,
        seconds: float = SECONDS,
    ):
        self._folder, self._pool, self._kept, self._seconds = folder, pool, kept, seconds
        self._most, self._most_bytes = most, most_bytes
        self._files: OrderedDict[str, FileJob] = OrderedDict()

    def __getitem__(self, name: str) -> FileJob:
        """Raises KeyError where there is none of this id, or none any more."""
        file = self._files[name]
        if file.path is not None and not file.path.is_file():
            self.forget(file)
            raise KeyError(name)
        return file

    def begin(self, source: str, request: Mapping[str, Any]) -> FileJob:
        """Has a worker make a file. Raises BusyError where too many are being made; OSError."""
        if len(self._files) >= self._most:
            oldest = next((one for one in self._files.values() if one.over), None)
            if oldest is None:
                raise BusyError(f"{self._most} files are being made; wait for one, or cancel it.")
            self.forget(oldest)
        name = secrets.token_hex(16)
        folder = made_sure(self._folder) / name
        folder.mkdir(mode=0o700)
        try:
            job = self._pool.submit(source, _with_folder(request, str(folder)), seconds=self._seconds, less=_LESS)
        except BusyError:
            folder.rmdir()
            raise
        file = FileJob(id=name, folder=folder, job=job, begun=time.monotonic())
        self._files[name] = file
        file.task = asyncio.ensure_future(self._follow(file))
        return file

    def drop(self, file: FileJob) -> None:
        """Cancels one that is being made; forgets one that is not."""
        if file.over:
            self.forget(file)
        else:
            file.state, file.stage = "cancelled", ""
            file.seconds = time.monotonic() - file.begun
            file.job.cancel()

    def forget(self, file: FileJob) -> None:
        """Removes it and what is told about it."""
        self._files.pop(file.id, None)
        file.job.cancel()
        shutil.rmtree(file.folder, ignore_errors=True)

    async def close(self) -> None:
        """Ends what is being made."""
        tasks = [file.task for file in self._files.values() if file.task is not None]
        for file in list(self._files.values()):
            self.forget(file)
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    def _forget_for(self, newest: FileJob) -> None:
        """Forgets the oldest files that are there until those that are left, with this one, are few enough bytes."""
        done = [one for one in self._files.values() if one.state == "done" and one is not newest]
        done.sort(key=lambda one: one.begun + (one.seconds or 0.0))
        too_much = newest.held + sum(one.held for one in done) - self._most_bytes
        for one in done:
            if too_much <= 0:
                return
            too_much -= one.held
            self.forget(one)

    async def _follow(self, file: FileJob) -> None:
        """Takes what the worker tells, and forgets the file in the end."""
        try:
            async for answer in file.job:
                if isinstance(answer, dict) and not file.over:
                    _take(file, answer)
                    self._forget_for(file)
            if not file.over:
                file.state, file.headline = "failed", "Nothing was written."
        except JobCancelledError:
            file.state = "cancelled"
        except JobRefusedError as error:
            file.state, file.headline, file.problems = "failed", error.headline, list(error.problems)
        except JobFailedError as error:
            file.state, file.headline = "failed", error.text
        if file.seconds is None:
            file.seconds = time.monotonic() - file.begun
        if file.state != "done":
            file.stage = ""
            shutil.rmtree(file.folder, ignore_errors=True)
        await asyncio.sleep(self._kept)
        self.forget(file)


def _take(file: FileJob, answer: Mapping[str, Any]) -> None:
    if "file" in answer:
        file.state, file.stage = "done", ""
        file.path, file.name = Path(answer["file"]), answer["name"]
        file.held = sum(one.stat().st_size for one in file.folder.rglob("*") if one.is_file())
        return
    file.state = "waiting" if answer == WAITING else "working"
    file.stage = str(answer.get("stage") or answer.get("text") or "")


def _with_folder(request: Mapping[str, Any], folder: str) -> dict[str, Any]:
    """A request to `jobs.admitted` for a file in a folder."""
    return {**request, "request": {**request["request"], "folder": folder}}

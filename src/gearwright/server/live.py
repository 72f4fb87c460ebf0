"""The page's live connection: a design in, its answers out, the newest design first."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, final

from starlette.websockets import WebSocket, WebSocketDisconnect

from .bodies import ASK, body_problems
from .buckets import Bucket
from .job import Job, Rank
from .outcomes import LOST, BusyError, JobCancelledError, JobFailedError, JobRefusedError
from .plain_json import NoJsonError, parsed, written
from .pool import Pool

NOT_TAKEN, POLICY, TRY_AGAIN = 1003, 1008, 1013
_PATIENCE = 100  # messages beyond the rate that are passed over, before the connection is closed


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Of connections: how many; messages a second, and at once; seconds for a job, and for a message to be taken."""

    connections: int = 64
    rate: float = 200.0
    burst: float = 400.0
    seconds: float = 20.0
    unread: float = 30.0


@final
class Connections:
    """All live connections.

    wrap    makes of a request that of the job "gearwright.server.jobs:admitted"
    abort   ends a connection whose other side does not read
    """

    def __init__(
        self, pool: Pool, wrap: Callable[[Any], Any], abort: Callable[[WebSocket], None], limits: Limits | None = None
    ):
        self.count = 0
        self._pool, self._wrap, self._abort, self._limits = pool, wrap, abort, limits or Limits()

    async def __call__(self, websocket: WebSocket) -> None:
        """Serves one until it ends."""
        await websocket.accept()
        if self.count >= self._limits.connections:
            await websocket.close(TRY_AGAIN, f"{self.count} connections are open; close another page first.")
            return
        self.count += 1
        connection = _Connection(websocket, self._pool, self._wrap, self._limits)
        try:
            await connection.serve()
        except (WebSocketDisconnect, RuntimeError):
            pass  # it has ended while something was sent
        except TimeoutError:
            self._abort(websocket)
        finally:
            self.count -= 1


class _Connection:
    """One of them: what was asked last, and the job that answers it."""

    def __init__(self, websocket: WebSocket, pool: Pool, wrap: Callable[[Any], Any], limits: Limits):
        self._websocket, self._pool, self._wrap, self._limits = websocket, pool, wrap, limits
        self._bucket, self._ignored = Bucket(limits.rate, limits.burst), 0
        self._newest: dict[str, Any] | None = None
        self._asked = asyncio.Event()
        self._job: Job | None = None

    async def serve(self) -> None:
        """Raises TimeoutError where the other side does not read."""
        tasks = [asyncio.ensure_future(self._hear()), asyncio.ensure_future(self._answer())]
        try:
            done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
            for task in done:
                task.result()
        finally:
            if self._job is not None:
                self._job.cancel()
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _hear(self) -> None:
        while True:
            message = await self._websocket.receive()
            if message["type"] == "websocket.disconnect":
                return
            if not self._bucket.take():
                self._ignored += 1
                if self._ignored > _PATIENCE:
                    await self._websocket.close(POLICY, "Too many messages.")
                    return
                if self._ignored == 1:
                    await self._send({"answer": "note", "text": "Too many messages; some are passed over."})
                continue
            text = message.get("text")
            if text is None:
                await self._websocket.close(NOT_TAKEN, "Requests are text.")
                return
            await self._take(text)

    async def _take(self, text: str) -> None:
        try:
            asked = parsed(text)
        except NoJsonError as error:
            await self._send({"answer": "failed", "id": None, "text": f"The request was not understood: {error}"})
            return
        if problems := body_problems(ASK, asked):
            number = asked.get("id") if isinstance(asked, dict) else None
            number = number if isinstance(number, int) else None
            headline = "The request was not understood"
            await self._send({"answer": "refused", "id": number, "headline": headline, "problems": problems})
            return
        self._newest = asked
        self._asked.set()
        if self._job is not None:
            self._job.cancel()

    async def _answer(self) -> None:
        while True:
            await self._asked.wait()
            self._asked.clear()
            asked, self._newest = self._newest, None
            if asked is not None:
                await self._answer_one(asked)

    async def _answer_one(self, asked: dict[str, Any]) -> None:
        """Streams the answers. What is left of an older job ends by itself: the next does not wait for it.

        Where others wait, too, all get their shapes before anybody gets more.
        """
        number, begun = asked["id"], time.monotonic()
        try:
            if self._pool.crowded:
                await self._stream({**asked, "part": "shape"}, Rank.SHOWN)
                if self._newest is None:
                    await self._stream({**asked, "part": "rest"}, Rank.BESIDE)
            else:
                await self._stream(asked, Rank.SHOWN)
            if self._newest is None:
                await self._send({"answer": "done", "id": number, "seconds": round(time.monotonic() - begun, 4)})
        except JobCancelledError:
            pass
        except JobRefusedError as error:
            told = {"headline": error.headline, "problems": list(error.problems)}
            await self._send({"answer": "refused", "id": number, **told})
        except JobFailedError as error:
            await self._send({"answer": "failed", "id": number, "text": error.text})
            if error.lost:
                await self._send({"answer": "note", "text": LOST})
        except BusyError as error:
            await self._send({"answer": "failed", "id": number, "text": str(error)})
        finally:
            if self._job is not None:
                self._job.cancel()
            self._job = None

    async def _stream(self, asked: dict[str, Any], rank: Rank) -> None:
        """Passes on what a job answers. Raises JobError where it does not end by itself."""
        source, request = self._wrap(asked)
        self._job = self._pool.submit(source, request, seconds=self._limits.seconds, rank=rank)
        async for answer in self._job:
            if self._job.cancelled:
                continue
            if isinstance(answer, dict):
                await self._send({"id": asked["id"], **answer})
            else:
                await self._sent(self._websocket.send_bytes(answer))

    async def _send(self, value: dict[str, Any]) -> None:
        await self._sent(self._websocket.send_text(written(value)))

    async def _sent(self, sending: Any) -> None:
        await asyncio.wait_for(sending, self._limits.unread)

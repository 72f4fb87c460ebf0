"""HTTP/1.1 on a connection, as uvicorn speaks it by h11, which bounds headers: with limits of its own."""

from __future__ import annotations

import asyncio
from typing import Any, cast, final

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

from .replies import refusal

HEAD = 10.0
"""Seconds that the head of a request may take, the first one's from the connection on."""

EACH = 64
"""Connections that an address may have open, of a server that others than its own machine reach."""


@final
class LimitedProtocol(H11Protocol):
    """One that ends connections on which no request comes, and those beyond an address's share.

    head   seconds for the head of a request
    each   connections of an address, None for any number
    """

    def __init__(self, *arguments: Any, head: float, each: int | None, **named: Any):
        super().__init__(*arguments, **named)
        self._head, self._each = head, each
        self._timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as uvicorn's own
        super().connection_made(transport)
        if self._each is not None and self._of_this_address() > self._each:
            transport.write(_too_many(self._each))
            transport.close()
            return
        self._time_head()

    def data_received(self, data: bytes) -> None:
        super().data_received(data)
        self._time_head()

    def connection_lost(self, exc: Exception | None) -> None:
        self._forget_timer()
        super().connection_lost(exc)

    def _of_this_address(self) -> int:
        """Connections of the address of this one, WebSockets among them."""
        clients = [cast("Any", one).client for one in self.connections]
        return sum(one is not None and self.client is not None and one[0] == self.client[0] for one in clients)

    def _time_head(self) -> None:
        """Begins to count where a head is awaited, and no more with each part of it that comes."""
        if self.conn.their_state is not h11.IDLE:
            self._forget_timer()
        elif self._timer is None and not self.transport.is_closing():
            self._timer = self.loop.call_later(self._head, self.transport.abort)

    def _forget_timer(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None


def _too_many(each: int) -> bytes:
    """A whole answer."""
    words = f"{each} connections from this address are open; close some first."
    answer = refusal(503, words, headers={"Connection": "close", "Retry-After": "10"})
    head = b"".join(name + b": " + value + b"\r\n" for name, value in answer.raw_headers)
    return b"HTTP/1.1 503 Service Unavailable\r\n" + head + b"\r\n" + bytes(answer.body)

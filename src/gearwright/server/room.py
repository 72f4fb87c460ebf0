"""Room for what is sent: bodies of all requests that are under way, together no more than so many bytes."""

from __future__ import annotations

from typing import final

from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

MOST_BYTES = 100_000_000


@final
class Room:
    """Around an application, inside what lets requests in; what a request has sent counts until it is answered.

    taken   bytes by now
    """

    def __init__(self, app: ASGIApp, most: int = MOST_BYTES):
        self.taken = 0
        self._app, self._most = app, most

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        own = 0

        async def receiving() -> Message:
            nonlocal own
            message = await receive()
            size = len(message.get("body", b""))
            if self.taken + size > self._most:
                words = "Too much is being sent to this server at once; try again in a moment."
                raise HTTPException(503, words, {"Retry-After": "2", "Connection": "close"})
            own, self.taken = own + size, self.taken + size
            return message

        try:
            await self._app(scope, receiving, send)
        finally:
            self.taken -= own

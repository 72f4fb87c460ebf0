"""Bodies of requests: counted and timed while they come."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import suppress

from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request

JSON_BYTES = 1 << 20
IDLE = 15.0
"""Seconds that a body may stand still."""

WHOLE = 120.0
"""Seconds that a body may take."""

_LINGER_BYTES, _LINGER_IDLE, _LINGER_SECONDS = 64 << 20, 1.0, 30.0


async def body(request: Request, most: int, idle: float = IDLE, whole: float = WHOLE) -> bytes:
    """The whole body. Raises HTTPException: 413 beyond so many bytes, keeping none of them; 408 where it is slow."""
    stated = request.headers.get("content-length", "")
    stream = aiter(request.stream())
    if stated.isdigit() and (len(stated) > 18 or int(stated) > most):
        if "expect" not in request.headers:  # such a client sends nothing before it is told to
            await _linger(stream)
        raise _too_large(most)
    data, ends = bytearray(), time.monotonic() + whole
    while (chunk := await _next(stream, min(idle, ends - time.monotonic()))) is not None:
        data += chunk
        if len(data) > most:
            await _linger(stream)
            raise _too_large(most)
    return bytes(data)


async def _next(stream: AsyncIterator[bytes], seconds: float) -> bytes | None:
    try:
        return await asyncio.wait_for(anext(stream, None), max(seconds, 0.0))
    except TimeoutError:
        raise HTTPException(408, "The request came too slowly.", {"Connection": "close"}) from None
    except ClientDisconnect:
        raise HTTPException(400, "The request ended before its body did.") from None


async def _linger(stream: AsyncIterator[bytes]) -> None:
    """Takes a little more, so that a client which only sends gets to read the answer; never all of it."""
    taken, ends = 0, time.monotonic() + _LINGER_SECONDS
    with suppress(HTTPException):
        while taken < _LINGER_BYTES and time.monotonic() < ends:
            chunk = await _next(stream, _LINGER_IDLE)
            if chunk is None:
                return
            taken += len(chunk)


def _too_large(most: int) -> HTTPException:
    size = f"{most / 1e6:g} MB" if most % 1_000_000 == 0 else f"{most >> 20} MiB"
    return HTTPException(413, f"The request is too large; at most {size} are taken.", {"Connection": "close"})

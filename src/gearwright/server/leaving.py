"""Clients that go before they are answered: what is done for them ends."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.requests import Request

from .job import Job


@asynccontextmanager
async def while_there(request: Request, job: Job) -> AsyncIterator[None]:
    """Has a job cancelled once the client of a request, whose body was read, has gone."""
    watching = asyncio.ensure_future(_watch(request, job))
    try:
        yield
    finally:
        watching.cancel()
        await asyncio.gather(watching, return_exceptions=True)


async def _watch(request: Request, job: Job) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass  # what comes after the body is not its matter
    job.cancel()

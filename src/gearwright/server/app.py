"""The application: routes to what does them, errors as refusals, the guard around it all."""

from __future__ import annotations

import errno
import shutil
import tempfile
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from os import cpu_count
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp
from starlette.websockets import WebSocket

from .api import Api, NotUnderstoodError
from .buckets import Buckets
from .files import Files
from .guard import Guard
from .hosts import Names, is_loopback
from .job_names import JobNames, admitted
from .live import Connections, Limits
from .operations import OPERATIONS
from .outcomes import BusyError, JobCancelledError, JobFailedError, JobRefusedError
from .page import FOLDER, page_files, page_reply
from .pool import Pool
from .protocol import HEAD
from .replies import refusal
from .room import MOST_BYTES, Room
from .uploads import Uploads

_NEAR, _FAR = (100.0, 300.0), (30.0, 120.0)  # requests a second, and at once, of an address


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Of a server.

    token   that requests must hold, None for none
    origin  that browsers reach it by through a proxy, None where there is none
    page    the folder of the page's files
    head    seconds for the head of a request
    each    connections of an address, None for any number
    room    bytes of all bodies under way
    """

    host: str
    port: int
    token: str | None = None
    origin: str | None = None
    page: Path = FOLDER
    jobs: JobNames = field(default_factory=JobNames)
    limits: Limits = field(default_factory=Limits)
    quick: int = field(default_factory=lambda: max(2, min(cpu_count() or 2, 4)))
    rate: tuple[float, float] | None = None
    head: float = HEAD
    each: int | None = None
    room: int = MOST_BYTES
    abort: Callable[[WebSocket], None] = lambda _: None


def application(settings: Settings) -> ASGIApp:
    """The whole server as an ASGI application; its workers and folders live between start-up and shutdown."""
    folder = Path(tempfile.mkdtemp(prefix="gearwright-")).resolve()  # only its owner reads it
    for name in ("uploads", "files"):
        (folder / name).mkdir(mode=0o700)
    quick, heavy = Pool(settings.quick, spares=1, kept=1), Pool(1, warm=None)
    files = Files(folder / "files", heavy)
    uploads = Uploads(folder / "uploads")
    api = Api(quick, heavy, files, uploads, settings.jobs)

    def wrap(asked: Any) -> Any:
        return admitted(settings.jobs.answers, asked, uploads.folder)

    connections = Connections(quick, wrap, settings.abort, settings.limits)
    api.connections = lambda: connections.count

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        quick.start()
        heavy.start()
        try:
            yield
        finally:
            await files.close()
            await quick.close()
            await heavy.close()
            shutil.rmtree(folder, ignore_errors=True)

    routes = [
        *(Route(one.path, getattr(api, one.name), methods=[one.method], name=one.name) for one in OPERATIONS),
        WebSocketRoute("/api/live", connections.__call__),
    ]
    inner = Starlette(routes=_joined(routes, settings), lifespan=lifespan, exception_handlers=_HANDLERS)
    rate = settings.rate or (_NEAR if is_loopback(settings.host) else _FAR)
    names = Names(host=settings.host, port=settings.port, origin=settings.origin)
    return Guard(Room(inner, settings.room), names, settings.token, Buckets(*rate))


def _joined(routes: list[Any], settings: Settings) -> list[Any]:
    """The routes, with a way to tell which methods a path has, and the page's files after all others."""
    files = page_files(settings.page)

    async def page(request: Request) -> Response:
        answer = page_reply(request, files)
        if answer is None:
            raise HTTPException(404, "There is nothing at this address.")
        return answer

    methods: dict[str, set[str]] = {}
    for route in routes:
        if isinstance(route, Route):
            methods.setdefault(route.path, set()).update(route.methods or ())

    def refuse(allowed: set[str]) -> Callable[[Request], Any]:
        async def refusing(_: Request) -> Response:
            raise HTTPException(405, "This address has no such method.", {"Allow": ", ".join(sorted(allowed))})

        return refusing

    others = [Route(path, _AnyMethod(refuse(allowed))) for path, allowed in methods.items()]
    return [*routes, *others, Route("/{path:path}", page, methods=["GET"])]


class _AnyMethod:
    """A handler of every method: Starlette lets functions have GET alone."""

    def __init__(self, handler: Callable[[Request], Any]):
        self._handler = handler

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        answer = await self._handler(Request(scope, receive))
        await answer(scope, receive, send)


async def _http(_: Request, error: Any) -> Response:
    return refusal(error.status_code, error.detail, headers=error.headers)


async def _refused(_: Request, error: Any) -> Response:
    return refusal(422, error.headline, error.problems)


async def _misunderstood(_: Request, error: Any) -> Response:
    return refusal(400, error.headline, error.problems)


async def _failed(_: Request, error: Any) -> Response:
    return refusal(503 if error.lost else 500, error.text)


async def _busy(_: Request, error: Any) -> Response:
    return refusal(503, str(error), headers={"Retry-After": "2"})


async def _disk(_: Request, error: Any) -> Response:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return refusal(507, "There is no space on the server's disk for this; what is forgotten there makes some.")
    raise error


async def _fault(_: Request, error: Any) -> Response:
    return refusal(500, f"Gearwright failed, and the fault is its own ({type(error).__name__}).")


_HANDLERS: Any = {
    HTTPException: _http,
    NotUnderstoodError: _misunderstood,
    JobRefusedError: _refused,
    JobFailedError: _failed,
    JobCancelledError: _busy,
    BusyError: _busy,
    OSError: _disk,
    Exception: _fault,
}

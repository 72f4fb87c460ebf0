"""The application on a socket, until it is told to end."""

from __future__ import annotations

import errno
import logging
import os
import secrets
import signal
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, cast

import uvicorn
from starlette.websockets import WebSocket

from ..errors import MachineError, Problem, ProblemsError
from .app import Settings, application
from .hosts import Names, is_loopback
from .protocol import EACH, LimitedProtocol
from .reading import JSON_BYTES

_TRIES = 50
_ENDING = 2  # seconds for what is under way


@dataclass(frozen=True, kw_only=True)
class Bound:
    """A socket that listens, and what it is called. moved   whether another port was taken than asked for"""

    listener: socket.socket
    names: Names
    token: str | None
    moved: bool

    @property
    def address(self) -> str:
        """To be opened in a browser."""
        return self._of(self.names.shown)

    @property
    def addresses_elsewhere(self) -> list[str]:
        """To be opened on other machines, where `address` is for this one."""
        return [] if self.names.origin else [self._of(shown) for shown in self.names.elsewhere]

    @property
    def each(self) -> int | None:
        """Connections that an address may have: any number, where only this machine has any, or a proxy has all."""
        return None if is_loopback(self.names.host) or self.names.origin is not None else EACH

    def _of(self, shown: str) -> str:
        return f"{self.names.origin or f'http://{shown}'}/" + (f"?token={self.token}" if self.token else "")


def bound(host: str, port: int, *, or_next: bool, origin: str | None = None) -> Bound:
    """A socket at a host and a port, 0 for any free one.

    or_next   take the next free one where it is taken
    origin    that browsers reach it by through a proxy, which lets in others than this machine

    Raises ProblemsError where it cannot be had.
    """
    for offered in range(port, min(port + (_TRIES if or_next else 1), 65536)):
        try:
            listener = _listening(host, offered)
        except OSError as error:
            if error.errno == errno.EADDRINUSE and or_next:
                continue
            raise ProblemsError("The server cannot start", [_problem(error, host, offered)]) from None
        token = None if is_loopback(host) and origin is None else secrets.token_urlsafe(24)
        names = Names(host=host, port=listener.getsockname()[1], origin=origin)
        return Bound(listener=listener, names=names, token=token, moved=offered != port)
    words = f"this and the next {_TRIES} ports are taken; name another one by --port"
    raise ProblemsError("The server cannot start", [Problem(f"--port {port}", words)])


def _listening(host: str, port: int) -> socket.socket:
    family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    listener = socket.socket(family, kind, protocol)
    try:
        if os.name == "posix":
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen(128)
    except BaseException:
        listener.close()
        raise
    listener.set_inheritable(False)
    return listener


def _problem(error: OSError, host: str, port: int) -> Problem:
    match error.errno:
        case errno.EADDRINUSE:
            return Problem(f"--port {port}", "another program has it; name another one, or 0 for any that is free")
        case errno.EACCES:
            return Problem(f"--port {port}", "the system keeps it to itself; take one from 1024 on")
    return Problem(f"--host {host}", f"this machine has no such name or address ({error.strerror or error})")


def serve(at: Bound, ready: Callable[[], None]) -> None:
    """Serves until SIGINT, SIGTERM or, unless it is ignored, SIGHUP. ready   called once requests are taken

    Raises MachineError where it cannot start.
    """
    server = server_of(
        Settings(host=at.names.host, port=at.names.port, token=at.token, origin=at.names.origin, each=at.each), ready
    )
    with _quiet_signals(), _hanging_up(server):
        server.run(sockets=[at.listener])
    if not server.started:
        raise MachineError("The server did not start; GEARWRIGHT_DEBUG=1 before the command shows why")


def server_of(settings: Settings, ready: Callable[[], None]) -> uvicorn.Server:
    """A server that is not yet run. ready   called once requests are taken"""
    holder: list[uvicorn.Server] = []
    config = uvicorn.Config(
        application(replace(settings, abort=lambda websocket: _abort(holder[0], websocket))),
        lifespan="on",
        http=cast("Any", partial(LimitedProtocol, head=settings.head, each=settings.each)),
        ws="websockets-sansio",
        ws_max_size=JSON_BYTES,
        ws_per_message_deflate=False,
        access_log=False,
        log_config=None,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=_ENDING,
        limit_concurrency=512,
    )
    if os.environ.get("GEARWRIGHT_DEBUG") != "1":
        logging.getLogger("uvicorn.error").setLevel(logging.CRITICAL + 1)
    server = _Server(config, ready)
    holder.append(server)
    return server


@contextmanager
def _quiet_signals() -> Iterator[None]:
    """Has signals to end do nothing more when uvicorn, which has ended by them, raises them again."""
    before = {one: signal.signal(one, lambda *_: None) for one in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)


@contextmanager
def _hanging_up(server: uvicorn.Server) -> Iterator[None]:
    """Has a terminal that is closed end the server as SIGTERM does; `nohup`, which has it ignored, is kept to."""
    hangup: Any = getattr(signal, "SIGHUP", None)
    if hangup is None or signal.getsignal(hangup) == signal.SIG_IGN:
        yield
        return
    before = signal.signal(hangup, lambda _, frame: server.handle_exit(signal.SIGTERM, frame))
    try:
        yield
    finally:
        signal.signal(hangup, before)


class _Server(uvicorn.Server):
    """One that says when it takes requests."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]):
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._ready()


def _abort(server: uvicorn.Server, websocket: WebSocket) -> None:
    """Ends a connection without waiting for its other side."""
    for protocol in list(server.server_state.connections):
        one: Any = protocol
        if getattr(one, "client", None) == tuple(websocket.client or ()) and one.transport is not None:
            one.transport.abort()

"""A server on loopback in a thread of its own."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import httpx
from websockets.sync.client import ClientConnection, connect

from gearwright.server.app import Settings
from gearwright.server.serving import bound, server_of


@dataclass(frozen=True)
class Running:
    port: int

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def client(self, **options) -> httpx.Client:
        return httpx.Client(base_url=self.url, timeout=60.0, trust_env=False, **options)

    def live(self, **options) -> ClientConnection:
        origin = options.pop("origin", self.url)
        return connect(
            f"ws://127.0.0.1:{self.port}/api/live",
            origin=origin,
            compression=None,
            proxy=None,
            max_size=None,
            **options,
        )


@contextmanager
def running(**settings) -> Iterator[Running]:
    """A server with these settings, at a free port, until the block ends."""
    at = bound("127.0.0.1", 0, or_next=False)
    ready = threading.Event()
    server = server_of(Settings(host="127.0.0.1", port=at.names.port, **settings), ready.set)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [at.listener]})
    thread.start()
    try:
        assert ready.wait(30)
        yield Running(at.names.port)
    finally:
        server.should_exit = True
        thread.join(30)
        at.listener.close()
        assert not thread.is_alive()

import json
import socket
import time
from contextlib import ExitStack, closing

import pytest

from gearwright.server.protocol import EACH
from gearwright.server.serving import bound

from .serving import running

HEAD, SHARE = 1.0, 5


@pytest.fixture(scope="module")
def server():
    with running(head=HEAD, each=SHARE) as one:
        yield one


def opened(server):
    return socket.create_connection(("127.0.0.1", server.port), timeout=20)


def request(server, *more):
    return "\r\n".join(["GET /api/materials HTTP/1.1", f"Host: 127.0.0.1:{server.port}", *more, "", ""]).encode()


def answer(connection):
    """All that is sent until the other side ends it."""
    found = b""
    try:
        while data := connection.recv(1 << 16):
            found += data
    except ConnectionResetError:
        pass
    return found


def test_connections_on_which_no_request_comes_are_ended(server):
    with opened(server) as idle:
        assert answer(idle) == b""


@pytest.mark.parametrize("before", [0, 1])
def test_the_head_of_a_request_has_one_time_however_many_parts_it_comes_in(server, before):
    with opened(server) as slow:
        for _ in range(before):
            slow.sendall(request(server))
            assert slow.recv(1 << 16).startswith(b"HTTP/1.1 200")
        begun, sent = time.monotonic(), 0
        slow.settimeout(0.1)
        for byte in request(server, "X: " + "x" * 1000):
            try:
                slow.sendall(bytes([byte]))
                sent += 1
                while slow.recv(1 << 16):
                    pass
                break
            except TimeoutError:
                continue
            except OSError:
                break
        assert sent < 100
        assert time.monotonic() - begun < 15


def test_requests_on_a_connection_that_is_kept_go_on_beyond_that_time(server):
    with server.client() as client:
        for _ in range(4):
            assert client.get("/api/materials").status_code == 200
            time.sleep(HEAD / 2)
    with server.live() as live:
        time.sleep(1.5 * HEAD)
        live.send("{")
        assert json.loads(live.recv(timeout=20))["answer"] == "failed"


def test_an_address_has_its_share_of_connections_and_gets_it_back(server):
    with ExitStack() as held:
        for _ in range(SHARE - 1):
            held.enter_context(opened(server)).sendall(b"GET")
        held.enter_context(server.live())
        one_more = held.enter_context(opened(server))
        told = answer(one_more)
        assert told.startswith(b"HTTP/1.1 503 ")
        assert f"{SHARE} connections" in json.loads(told.partition(b"\r\n\r\n")[2])["headline"]
    ends = time.monotonic() + 20
    while True:
        with opened(server) as again:
            again.sendall(request(server, "Connection: close"))
            if answer(again).startswith(b"HTTP/1.1 200"):
                break
        assert time.monotonic() < ends


def test_only_servers_that_others_reach_share_connections_out():
    own, all_ = bound("127.0.0.1", 0, or_next=False), bound("0.0.0.0", 0, or_next=False)  # noqa: S104
    with closing(own.listener), closing(all_.listener):
        assert (own.each, all_.each) == (None, EACH)


def test_headers_without_end_are_refused(server):
    with opened(server) as connection:
        connection.sendall(request(server)[:-2])
        try:
            for _ in range(64):
                connection.sendall(b"X: " + b"x" * 65536 + b"\r\n")
        except OSError:
            return
        assert not answer(connection).startswith(b"HTTP/1.1 200")

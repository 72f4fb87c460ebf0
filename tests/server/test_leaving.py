import json
import socket
import time

import pytest

from gearwright.server.job_names import JobNames

from . import work
from .serving import running

JOBS = JobNames(answers=f"{work.__name__}:live", plot=f"{work.__name__}:sleep", build=f"{work.__name__}:sleep")
DESIGN = {"element": "spur", "teeth": 16, "module": 3, "face_width": 20}


@pytest.fixture(scope="module")
def server():
    with running(jobs=JOBS, quick=2) as one:
        yield one


def posted(server, path, body):
    """A connection on which something was asked whose answer nobody has read."""
    data = json.dumps(body).encode()
    head = f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nContent-Length: {len(data)}\r\n\r\n"
    connection = socket.create_connection(("127.0.0.1", server.port), timeout=30)
    connection.sendall(head.encode() + data)
    return connection


def workers(server):
    with server.client() as client:
        return client.get("/api/health").json()["workers"]["quick"]


def until(server, found):
    ends = time.monotonic() + 20  # far less than the job takes
    while not found(told := workers(server)):
        assert time.monotonic() < ends, told
        time.sleep(0.05)


@pytest.mark.parametrize(("path", "more"), [("/api/plots", {"plot": "profile"}), ("/api/build", {})])
def test_clients_that_go_leave_no_work(server, path, more):
    connections = [posted(server, path, {"design": DESIGN, **more}) for _ in range(4)]
    until(server, lambda told: (told["busy"], told["waiting"]) == (1, 3))
    for one in connections:
        one.close()
    until(server, lambda told: (told["busy"], told["waiting"]) == (0, 0))


def test_a_client_that_stays_keeps_its_work_and_what_is_on_the_screen_is_answered(server):
    connections = [posted(server, "/api/plots", {"design": DESIGN, "plot": "profile"}) for _ in range(4)]
    until(server, lambda told: (told["busy"], told["waiting"]) == (1, 3))
    try:
        with server.live() as live:
            live.send(json.dumps({"ask": "design", "id": 1, "design": {}}))
            assert isinstance(live.recv(timeout=20), bytes)
        until(server, lambda told: (told["busy"], told["waiting"]) == (1, 3))
    finally:
        for one in connections:
            one.close()

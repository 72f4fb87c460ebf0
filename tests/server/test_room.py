import socket
import time
from contextlib import ExitStack

from gearwright.server.room import Room

from .serving import running


def begun(server, size, stated):
    """A connection that has sent so many bytes of an upload and holds the rest back."""
    connection = socket.create_connection(("127.0.0.1", server.port), timeout=30)
    head = f"POST /api/uploads?name=a.csv HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nContent-Length: {stated}\r\n\r\n"
    connection.sendall(head.encode() + bytes(size))
    return connection


def test_bodies_under_way_are_bounded_together_and_make_room_when_they_end(monkeypatch):
    rooms = []

    def made(*arguments):
        rooms.append(Room(*arguments))
        return rooms[-1]

    monkeypatch.setattr("gearwright.server.app.Room", made)
    with running(room=1_000_000, rate=(1e9, 1e9)) as server, server.client() as client, ExitStack() as held:

        def read(size):
            return client.post("/api/read", json={"toml": 'element = "spur"\n#' + "x" * size})

        def until(taken):
            ends = time.monotonic() + 20
            while rooms[0].taken != taken:
                assert time.monotonic() < ends
                time.sleep(0.02)

        assert read(10).status_code == 200  # workers are there: what is held is not held for longer than it may be
        for _ in range(3):
            held.enter_context(begun(server, 300_000, 400_000))
        until(900_000)
        refused = read(200_000)
        assert refused.status_code == 503
        assert refused.headers["retry-after"] == "2"
        assert "at once" in refused.json()["headline"]
        assert read(50_000).status_code == 200
        held.close()
        until(0)
        assert [read(900_000).status_code for _ in range(5)] == [200] * 5  # what is answered counts no longer

import json
import socket
import time
from contextlib import ExitStack, suppress

import pytest
from websockets.exceptions import ConnectionClosed

from gearwright.server.job_names import JobNames
from gearwright.server.live import Limits

from . import work
from .serving import running

JOBS = JobNames(answers=f"{work.__name__}:live")
LIMITS = Limits(connections=6, seconds=3.0, unread=1.0, rate=50.0, burst=60.0)


@pytest.fixture(scope="module")
def server():
    with running(jobs=JOBS, limits=LIMITS) as one:
        yield one


@pytest.fixture
def live(server):
    with server.live() as connection:
        yield connection


def ask(connection, number, **design):
    connection.send(json.dumps({"ask": "design", "id": number, "design": design}))


def answers(connection, number, last="done"):
    """What is answered to a request, to its last answer; nothing of others."""
    found = []
    while True:
        answer = connection.recv(timeout=30)
        answer = header(answer) if isinstance(answer, bytes) else json.loads(answer)
        if answer.get("id") == number:
            found.append(answer)
            if answer.get("answer") == last:
                return found


def header(frame):
    length = int.from_bytes(frame[:4], "little")
    return {**json.loads(frame[4 : 4 + length]), "buffers": frame[4 + length :]}


def workers(server):
    with server.client() as client:
        return client.get("/api/health").json()["workers"]["quick"]


def test_answers_come_in_their_order_each_with_the_id_it_answers(live):
    live.send(json.dumps({"ask": "design", "id": 7, "design": {"title": "spur"}, "have": ["a"]}))
    mesh, values, done = answers(live, 7)
    assert (mesh["answer"], mesh["title"], mesh["buffers"]) == ("mesh", "spur", b"\1\2\3\4")
    assert values == {"answer": "values", "id": 7, "have": ["a"]}
    assert done["seconds"] >= 0.0


def test_a_newer_design_supersedes_the_older_ones(server, live):
    ask(live, 1, do="slow")
    assert json.loads(live.recv(timeout=30)) == {"answer": "values", "id": 1, "k": 0}
    for number in range(2, 6):
        ask(live, number, do="slow")
    ask(live, 6)
    seen = []
    while not seen or seen[-1] != (6, "done"):
        answer = live.recv(timeout=30)
        answer = header(answer) if isinstance(answer, bytes) else json.loads(answer)
        seen.append((answer["id"], answer["answer"]))
    assert len([number for number, _ in seen if number < 6]) < 30  # of five times a hundred
    ids = [number for number, _ in seen]
    assert ids == sorted(ids)
    ends = time.monotonic() + 10
    while workers(server)["busy"]:  # older jobs end by themselves
        assert time.monotonic() < ends
        time.sleep(0.05)


def test_connections_that_ask_for_much_leave_others_a_worker(server):
    with server.live() as greedy, server.live() as modest:
        for number in range(20):
            ask(greedy, number, do="slow")
        ask(modest, 1)
        assert answers(modest, 1)[-1]["answer"] == "done"


def test_where_many_wait_all_have_their_shapes_before_anybody_has_more():
    with running(jobs=JOBS, limits=LIMITS, quick=1) as server, ExitStack() as held:
        holding, *others = (held.enter_context(server.live()) for _ in range(5))
        ask(holding, 1, do="slow")
        holding.recv(timeout=30)
        for waiting, connection in enumerate(others, 1):
            ask(connection, 1, do="note the time")
            while workers(server)["waiting"] < waiting:
                time.sleep(0.01)
        ask(holding, 2)
        first, *rest = [[one["at"] for one in answers(connection, 1) if "at" in one] for connection in others]
        assert [len(one) for one in (first, *rest)] == [2] * 4
        shapes, values = zip(*rest, strict=True)
        assert sorted(shapes) + sorted(values) == [*shapes, *values]
        assert max(shapes) < min(values)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("{", "no JSON"),
        ("[" * 100_000, "nested too deeply"),
        ("[" * 100 + "]" * 100, "nested too deeply"),
        ('{"ask": "design", "id": NaN}', "NaN"),
        ('{"ask": "design", "id": 1e999}', "too large"),
        ('"\\ud800"', "surrogate"),
        ("9" * 5000, "no JSON"),
    ],
)
def test_what_is_no_json_is_told_and_the_connection_goes_on(live, text, told):
    live.send(text)
    answer = json.loads(live.recv(timeout=30))
    assert (answer["answer"], answer["id"]) == ("failed", None)
    assert told in answer["text"]
    ask(live, 3)
    assert answers(live, 3)


@pytest.mark.parametrize(
    ("asked", "subject"),
    [
        ([], ""),
        ({"ask": "design", "id": 5}, "design"),
        ({"ask": "design", "id": 5, "design": []}, "design"),
        ({"ask": "design", "id": True, "design": {}}, "id"),
        ({"ask": "desing", "id": 5, "design": {}}, "ask"),
        ({"ask": "design", "id": 5, "design": {}, "desnity": 3}, "desnity"),
        ({"ask": "design", "id": 5, "design": {}, "have": "a"}, "have"),
        ({"ask": "design", "id": 5, "design": {}, "have": [[]]}, "have"),
        ({"ask": "design", "id": 5, "design": {}, "have": [1]}, "have"),
        ({"ask": "design", "id": 5, "design": {}, "turn": 0}, "turn"),  # the page turns it, and knows the inertia
        ({"ask": "design", "id": 5, "design": {}, "about": "origin"}, "about"),
    ],
)
def test_what_is_no_request_is_refused_by_its_entry(live, asked, subject):
    live.send(json.dumps(asked))
    answer = json.loads(live.recv(timeout=30))
    assert answer["answer"] == "refused"
    assert [problem["subject"] for problem in answer["problems"]] == [subject]


def test_refusals_and_faults_are_answers(live):
    ask(live, 1, do="refuse", element="spur", teeth=[16, 40])
    refused = answers(live, 1, "refused")[-1]
    assert [(one["parameter"], one["member"]) for one in refused["problems"]] == [("face_width", 1), (None, None)]
    ask(live, 2, do="fault")
    assert "its own" in answers(live, 2, "failed")[-1]["text"]


def test_a_lost_worker_is_told_and_the_next_design_answered(server, live):
    before = workers(server)["replaced"]
    ask(live, 1, do="die")
    assert "was lost" in answers(live, 1, "failed")[-1]["text"]
    assert json.loads(live.recv(timeout=30)) == {
        "answer": "note",
        "text": "A worker was lost and has been replaced.",
    }
    assert workers(server)["replaced"] == before + 1
    ask(live, 2)
    assert answers(live, 2)


def test_a_design_that_takes_too_long_is_stopped(live):
    ask(live, 1, do="sleep")
    assert "longer than 3 s" in answers(live, 1, "failed")[-1]["text"]


def test_a_page_that_leaves_leaves_no_work(server):
    with server.live() as connection:
        ask(connection, 1, do="slow")
        connection.recv(timeout=30)
    ends = time.monotonic() + 20
    while workers(server)["busy"]:
        assert time.monotonic() < ends
        time.sleep(0.05)


def test_binary_and_oversized_messages_end_the_connection(server):
    for message, code in ((b"\0\1", 1003), ("x" * (1 << 20) + "y", 1009)):
        with server.live() as connection:
            connection.send(message)
            with pytest.raises(ConnectionClosed) as closed:
                connection.recv(timeout=30)
            assert closed.value.rcvd.code == code


def test_text_that_is_no_utf8_ends_the_connection(server):
    with server.live() as connection:
        connection.send(b"\xff\xfe", text=True)
        with pytest.raises(ConnectionClosed) as closed:
            connection.recv(timeout=30)
        assert closed.value.rcvd.code == 1007


def test_more_connections_than_there_may_be_are_told_to_come_later(server):
    with ExitStack() as opened:
        for _ in range(LIMITS.connections):
            opened.enter_context(server.live())
        one_more = opened.enter_context(server.live())
        with pytest.raises(ConnectionClosed) as closed:
            one_more.recv(timeout=30)
    assert closed.value.rcvd.code == 1013
    assert "6 connections" in closed.value.rcvd.reason


def test_a_flood_is_told_then_closed(server):
    with server.live() as connection:
        with pytest.raises(ConnectionClosed) as closed:  # noqa: PT012
            for number in range(2000):
                ask(connection, number, do="slow")
            while True:
                connection.recv(timeout=30)
        assert closed.value.rcvd.code == 1008


def test_a_reader_that_does_not_read_is_ended(server):
    size = 64 << 20
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as connection:
        handshake = (
            f"GET /api/live HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n"
        )
        connection.sendall(handshake.encode())
        assert connection.recv(4096).startswith(b"HTTP/1.1 101")
        text = json.dumps({"ask": "design", "id": 1, "design": {"do": "large", "bytes": size}}).encode()
        connection.sendall(bytes([0x81, 0x80 | len(text), 0, 0, 0, 0]) + text)  # masked by zeros
        with server.client() as client:
            while client.get("/api/health").json()["connections"] == 0:
                time.sleep(0.02)
            ends = time.monotonic() + 30
            while client.get("/api/health").json()["connections"]:
                assert time.monotonic() < ends
                time.sleep(0.05)
        taken = 0
        with suppress(ConnectionResetError):
            while data := connection.recv(1 << 20):
                taken += len(data)
    assert taken < size  # what it did not read in time was thrown away


def test_a_large_answer_arrives_whole(live):
    ask(live, 1, do="large", bytes=32 << 20)
    mesh = answers(live, 1)[0]
    assert mesh["buffers"] == bytes(32 << 20)
    assert (mesh["answer"], mesh["id"]) == ("mesh", 1)


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1"])
def test_pages_of_other_origins_are_closed_out_with_a_reason(server, origin):
    with server.live(origin=origin) as connection:
        with pytest.raises(ConnectionClosed) as closed:
            connection.recv(timeout=30)
        assert closed.value.rcvd.code == 1008
        assert "origin" in closed.value.rcvd.reason


def test_scripts_without_an_origin_are_served(server):
    with server.live(origin=None) as connection:
        ask(connection, 1)
        assert answers(connection, 1)


def test_a_real_design_is_answered_whole():
    design = {"element": "spur", "teeth": [16, 40], "module": 3, "face_width": 20}
    with running() as server, server.live() as connection:
        ask(connection, 4, **design)
        told = answers(connection, 4)
        assert [one["answer"] for one in told if one["answer"] != "stage"] == [
            "mesh",
            "values",
            "overlays",
            "approximation",
            "done",
        ]
        ask(connection, 5, **design | {"module": -3})
        refused = answers(connection, 5, "refused")[-1]
        assert [problem["parameter"] for problem in refused["problems"]] == ["module"]
        values = next(one for one in told if one["answer"] == "values")
        with server.client() as client:
            assert client.post("/api/build", json={"design": design}).json() == values["document"]

import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import contextmanager
from pathlib import Path
from socket import AF_INET

import httpx
import pytest

from gearwright.server.hosts import Names

from ..signals import begun_with


@contextmanager
def serving(*words, **variables):
    """The command in a process of its own, with the address that it prints, until the block ends."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), **variables}
    command = [sys.executable, "-m", "gearwright", "serve", *map(str, words)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, start_new_session=True
    ) as process:
        try:
            line = process.stdout.readline()
            found = re.fullmatch(r"Gearwright's designer page: (https?://\S+) – Ctrl-C ends it\.\n", line)
            assert found, line + process.stderr.read()
            yield process, found[1]
        finally:
            process.kill()


def children(pid):
    """All processes that come from one, by /proc."""
    parents = {}
    for status in Path("/proc").glob("[0-9]*/status"):
        try:
            parents[int(status.parent.name)] = int(re.search(r"PPid:\t(\d+)", status.read_text())[1])
        except OSError:
            continue
    found = {pid}
    while more := {one for one, parent in parents.items() if parent in found} - found:
        found |= more
    return found - {pid}


def answered(address, path="api/materials"):
    return httpx.get(address.partition("?")[0] + path, timeout=30, trust_env=False)


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_serves_until_it_is_told_to_end_and_leaves_nothing(how):
    with (
        begun_with(signal.SIGHUP, signal.SIG_DFL),
        tempfile.TemporaryDirectory(prefix="gw-") as own,
        serving("--port", 0, TMPDIR=own) as (process, address),
    ):
        assert answered(address).status_code == 200
        assert answered(address, "").headers["content-type"].startswith("text/html")
        ends = time.monotonic() + 30
        while answered(address, "api/health").json()["workers"]["quick"]["alive"] < 3:
            assert time.monotonic() < ends
            time.sleep(0.05)
        workers = children(process.pid)
        assert len(workers) >= 4
        assert len(list(Path(own).glob("gearwright-*/uploads"))) == 1
        os.killpg(process.pid, how)  # as Ctrl-C does: to all of them
        code = process.wait(20)
        err = process.stderr.read()
        assert list(Path(own).glob("gearwright-*")) == []
    assert code == 0, err
    assert "Traceback" not in err
    ends = time.monotonic() + 10
    while any(Path(f"/proc/{pid}").exists() and "Z" not in state(pid) for pid in workers):
        assert time.monotonic() < ends
        time.sleep(0.05)


def test_a_closed_terminal_does_not_end_what_was_told_to_go_on():
    with begun_with(signal.SIGHUP, signal.SIG_IGN), serving("--port", 0) as (process, address):
        process.send_signal(signal.SIGHUP)
        assert answered(address).status_code == 200
        time.sleep(0.5)
        assert answered(address).status_code == 200
        process.send_signal(signal.SIGTERM)
        assert process.wait(20) == 0


def state(pid):
    try:
        return re.search(r"State:\t(\w)", Path(f"/proc/{pid}/status").read_text())[1]
    except OSError:
        return "Z"


def test_another_port_is_taken_where_none_was_asked_for():
    with serving() as (_, first), serving() as (process, second):
        assert first != second
        assert answered(second).status_code == 200
        process.send_signal(signal.SIGTERM)
        assert "is taken" in process.stderr.read()


def test_a_port_that_is_asked_for_and_taken_is_refused(run):
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        outcome = run("serve", "--port", port)
    assert outcome.code == 2
    assert f"--port {port}: another program has it" in outcome.err


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--port", 70000), "0 to 65535"),
        (("--port", -1), "0 to 65535"),
        (("--port", "x"), "--port"),
        (("--origin", "gear.example"), "such as https://gear.example"),
        (("--origin", "https://gear.example/gears"), "such as https://gear.example"),
        (("--host", "no host"), "name or an address"),
        (("--host", "a..b"), "name or an address"),
        (("--host", "a" * 64), "name or an address"),
        (("--host", "x." + "a" * 64 + ".y"), "name or an address"),
        (("--host", "a-.b"), "name or an address"),
        (("--host", "ab." * 84 + "cd"), "name or an address"),
        (("--host", "192.0.2.1", "--port", 0), "no such name or address"),
        (("--host", "nowhere.invalid", "--port", 0), "no such name or address"),
    ],
)
def test_a_port_or_a_host_that_cannot_be_is_refused(run, words, told):
    outcome = run("serve", *words)
    assert outcome.code == 2
    assert told in outcome.err
    assert "Traceback" not in outcome.err


def test_what_it_needs_is_said_where_it_is_missing(run, monkeypatch):
    monkeypatch.setattr("gearwright.cli.serve.find_spec", lambda name: None if name == "uvicorn" else object())
    outcome = run("serve")
    assert outcome.code == 3
    assert "uvicorn is not installed" in outcome.err
    assert "pip install 'gearwright[web]'" in outcome.err


def test_others_than_this_machine_need_the_token_that_is_printed():
    with serving("--host", "0.0.0.0", "--port", 0) as (process, address):  # noqa: S104
        token = re.search(r"\?token=(\S{20,})$", address)[1]
        url = address.partition("?")[0]
        assert httpx.get(url, trust_env=False).status_code == 401
        with httpx.Client(trust_env=False, follow_redirects=True) as browser:
            assert browser.get(address).status_code == 200
            assert browser.get(f"{url}api/materials").status_code == 200
        headers = {"Authorization": f"Bearer {token}"}
        assert httpx.get(f"{url}api/materials", headers=headers, trust_env=False).status_code == 200
        port = httpx.URL(url).port
        for _ in Names(host="0.0.0.0", port=port).elsewhere:  # noqa: S104
            found = re.fullmatch(r"From other machines: (http://(\S+)/\?token=(\S+))\n", process.stdout.readline())
            assert found[3] == token
            hosted = {"Host": found[2], **headers}
            assert httpx.get(f"{url}api/materials", headers=hosted, trust_env=False).status_code == 200


def test_a_server_for_all_is_known_elsewhere_by_its_name_and_its_address(monkeypatch):
    monkeypatch.setattr("socket.gethostname", lambda: "Gears")
    monkeypatch.setattr(
        "gearwright.server.hosts._outward", lambda family: "10.1.2.3" if family == AF_INET else "fd00::7"
    )
    everywhere = Names(host="0.0.0.0", port=8321)  # noqa: S104
    assert everywhere.elsewhere == ["gears:8321", "10.1.2.3:8321"]
    assert all(map(everywhere.known, everywhere.elsewhere))
    assert Names(host="::", port=8321).elsewhere == ["gears:8321", "[fd00::7]:8321"]
    assert Names(host="127.0.0.1", port=8321).elsewhere == []
    assert Names(host="gears.local", port=8321).elsewhere == []
    monkeypatch.setattr("socket.gethostname", lambda: "localhost")
    monkeypatch.setattr("gearwright.server.hosts._outward", lambda _: None)
    assert everywhere.elsewhere == []


def test_behind_a_proxy_the_token_is_needed_although_it_is_this_machine_that_asks():
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with serving("--port", port, "--origin", "https://gear.example/") as (_, address):
        token = re.fullmatch(r"https://gear\.example/\?token=(\S{20,})", address)[1]
        url = f"http://127.0.0.1:{port}/api/read"
        headers = {"Host": "gear.example", "Origin": "https://gear.example", "Authorization": f"Bearer {token}"}
        asked = {"json": {"toml": 'element = "spur"'}, "timeout": 60, "trust_env": False}
        assert httpx.post(url, headers=headers, **asked).status_code == 200
        assert httpx.post(url, headers={**headers, "Authorization": ""}, **asked).status_code == 401
        assert httpx.post(url, headers={**headers, "Origin": "https://evil.example"}, **asked).status_code == 403


def test_the_browser_is_opened_at_the_address(monkeypatch, run):
    opened = threading.Event()
    addresses = []

    def serve(at, ready):
        ready()
        assert opened.wait(10)

    monkeypatch.setattr("gearwright.server.serving.serve", serve)
    monkeypatch.setattr("webbrowser.open", lambda address: (addresses.append(address), opened.set()))
    outcome = run("serve", "--open", "--port", 0)
    assert outcome.code == 0
    assert addresses[0] in outcome.out


def test_help_and_the_command_s_help_load_no_server():
    script = (
        "import sys; from gearwright.cli import main; code = main({words});"
        "heavy = {{'numpy', 'scipy', 'numba', 'starlette', 'uvicorn', 'websockets', 'asyncio'}} & set(sys.modules);"
        "print('heavy:', sorted(heavy), 'code:', code)"
    )
    for words in (["--help"], ["serve", "--help"]):
        told = subprocess.run(
            [sys.executable, "-c", script.format(words=words)], capture_output=True, text=True, timeout=60, check=False
        )
        assert "serve" in told.stdout
        assert "heavy: [] code: 0" in told.stdout, told.stdout[-300:] + told.stderr[-300:]

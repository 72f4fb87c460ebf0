import errno
import json
import os
import tempfile
import time
from pathlib import Path

import pytest

from gearwright.server.hidden_folders import without
from gearwright.server.job_names import JobNames
from gearwright.server.uploads import Uploads, plain_name

from .serving import running

SQUARE = b"0,0\n10,0\n10,10\n0,10\n"


@pytest.fixture
def full(monkeypatch):
    """A disk that has room for a part of each file."""
    whole = Path.write_bytes

    def write(path, data):
        whole(path, data[: len(data) // 2])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    monkeypatch.setattr(Path, "write_bytes", write)


def test_an_upload_that_a_full_disk_breaks_off_leaves_nothing(tmp_path, full):
    with pytest.raises(OSError, match="No space"):
        Uploads(tmp_path).keep("a.csv", SQUARE)
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_is_told_as_such(full):
    with running() as server, server.client() as client:
        answer = client.post("/api/uploads", params={"name": "a.csv"}, content=SQUARE)
    assert answer.status_code == 507
    assert "no space" in answer.json()["headline"]


@pytest.mark.parametrize("name", ["é" * 400 + ".csv", "漢" * 99 + ".csv", "a" + "😀" * 60 + ".csv", "𝛼" * 90 + ".csv"])
def test_names_of_many_bytes_are_cut_to_what_systems_keep(tmp_path, name):
    path = Uploads(tmp_path).keep(plain_name(name), SQUARE)
    assert path.read_bytes() == SQUARE
    assert len(path.name.encode()) <= 104
    assert path.name.endswith(".csv")
    assert "\ufffd" not in path.name


@pytest.mark.parametrize(
    ("how", "told"),
    [
        ("told", "spur.stl: cannot be written"),
        ("folder", "the folder: cannot be written to"),
        ("system", "spur.stl: No space left"),
        ("fault", "ValueError: spur.stl has no end"),
    ],
)
def test_a_file_that_cannot_be_written_is_told_by_its_name_alone(tmp_path, monkeypatch, how, told):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    body = {"design": {"element": how}, "suffix": ".stl", "what": "body"}
    with running(jobs=JobNames(file="tests.server.work:full_disk")) as server, server.client() as client:
        url = client.post("/api/files", json=body).json()["url"]
        ends = time.monotonic() + 30
        while (answer := client.get(url).json())["state"] in ("waiting", "working"):
            assert time.monotonic() < ends
            time.sleep(0.02)
    assert answer["state"] == "failed"
    words = json.dumps(answer)
    assert f'"{told}' in words or f"({told}" in words
    assert str(tmp_path) not in words
    assert "/files" not in words


def test_only_folders_of_the_server_are_cut_from_texts():
    home = "/tmp/gearwright-a/files/0123"  # noqa: S108
    part = f"{home}/files/.{'0' * 16}.part/new/pinion.stl and {home}/filesystem.stl, /tmp/b/files/c.stl"
    assert without([part], [home]) == ["pinion.stl and filesystem.stl, /tmp/b/files/c.stl"]

import errno
import json
import os
import shutil
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


def test_folders_that_something_has_tidied_away_are_made_again(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    names = JobNames(file="tests.server.work:write")
    body = {"design": {"element": "x", "bytes": 7}, "suffix": ".stl", "what": "body"}
    with running(jobs=names) as server, server.client() as client:

        def made():
            url = client.post("/api/files", json=body).json()["url"]
            ends = time.monotonic() + 30
            while (answer := client.get(url).json()).get("state") in ("waiting", "working"):
                assert time.monotonic() < ends
                time.sleep(0.02)
            return url, answer["state"]

        def uploaded():
            return client.post("/api/uploads", params={"name": "a.csv"}, content=SQUARE).status_code

        (folder,) = tmp_path.glob("gearwright-*")
        old, state = made()
        assert (state, uploaded()) == ("done", 201)
        shutil.rmtree(folder)
        assert client.get(old).status_code == 404
        assert client.get(f"{old}/content").status_code == 404
        assert (uploaded(), made()[1]) == (201, "done")
        for one in (folder, *folder.iterdir()):
            assert one.stat().st_mode & 0o077 == 0
    assert not folder.exists()


def test_what_another_has_put_in_place_of_a_folder_is_not_used(tmp_path):
    (tmp_path / "theirs").mkdir()
    (tmp_path / "ours").symlink_to(tmp_path / "theirs")
    for folder in (tmp_path / "ours", tmp_path / "ours" / "uploads"):
        with pytest.raises(PermissionError):
            Uploads(folder).keep("a.csv", SQUARE)
    assert list((tmp_path / "theirs").rglob("*.csv")) == []

import errno
import os
from pathlib import Path

import pytest

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

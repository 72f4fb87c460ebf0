"""Whatever bytes a reader gets, it gives bodies or says what is wrong, soon and in little memory.

`make test` tries a fixed number of spoilt files a format, always the same; `make fuzz` sets FUZZ_SECONDS and tries new
ones for as long, and puts any that breaks a reader into the corpus, which every later run tries, too.
"""

from __future__ import annotations

import hashlib
import os
import resource
import secrets
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from gearwright.errors import FileError, MachineError
from gearwright.files.formats import FILE_FORMATS
from gearwright.files.recognition import recognise
from gearwright.sources import load

from .documents import spoilt_scene
from .exchanges import spoilt_exchange
from .mutations import spoilt
from .packages import spoilt_package

CORPUS = Path(__file__).parent / "corpus"
SECONDS = float(os.environ.get("FUZZ_SECONDS", "0"))
INPUTS = 1500
FEW = {"STEP": 2}
"""Inputs of formats that take a process and seconds a file; `make fuzz` tries more."""

OWN = {"3MF": spoilt_package, "glTF": spoilt_scene, "STEP": spoilt_exchange}
"""What spoils files inside, where anything else is refused at their outside."""

READ = [one for one in FILE_FORMATS if one.parser]

SLOWEST = 2.0
"""Seconds of processor time for a file of some kB: hundreds of times what is usual."""

MOST_MEMORY = 300 * 2**20
"""Bytes that the process may grow beyond what reading the corpus takes."""


def corpus(one):
    return [path.read_bytes() for path in sorted((CORPUS / one.name.lower()).glob("*"))]


def peak():
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def assert_sound(contents):
    assert contents.bodies
    for body in contents.bodies:
        assert body.vertices.dtype == np.float64
        assert body.vertices.shape == (len(body.vertices), 3)
        assert np.isfinite(body.vertices).all()
        assert body.indices.dtype == body.offsets.dtype == np.int64
        assert body.offsets[0] == 0
        assert body.offsets[-1] == len(body.indices)
        assert np.diff(body.offsets).min() >= 3
        assert body.indices.min() >= 0
        assert body.indices.max() < len(body.vertices)
        assert 0.0 <= body.rounding < np.inf
        assert isinstance(body.name, str)


def attempt(parse, data, bound):
    """Whether the bytes are read; asserts that they are else refused, in one short line that names the file."""
    start = time.process_time()
    try:
        recognise(data, "spoilt")
    except FileError as error:
        assert "spoilt" in str(error)  # noqa: PT017
    read = False
    try:
        assert_sound(parse(data, "spoilt"))
        read = True
    except (FileError, MachineError) as error:
        assert "spoilt" in str(error)  # noqa: PT017
        assert len(str(error)) < 1000  # noqa: PT017
        assert "\n" not in str(error)  # noqa: PT017
    assert time.process_time() - start < SLOWEST
    assert peak() < bound
    return read


def warm_up(one):
    """Loads modules and compiles kernels, which is not to count; not where another process does."""
    for data in corpus(one) if one.name not in FEW else ():
        with suppress(FileError, MachineError):
            load(one.parser)(data, "spoilt")


@pytest.mark.parametrize("one", READ, ids=lambda one: one.name)
def test_every_format_has_a_corpus_that_is_read(one):
    parse, files = load(one.parser), corpus(one)
    assert files, f"put small valid files into {CORPUS / one.name.lower()}"
    warm_up(one)
    assert sum(attempt(parse, data, np.inf) for data in files) >= 2


@pytest.mark.parametrize("one", READ, ids=lambda one: one.name)
def test_spoilt_files_are_read_or_refused(one):
    parse, files, inputs = load(one.parser), corpus(one), FEW.get(one.name, INPUTS)
    warm_up(one)
    bound = peak() + MOST_MEMORY
    root = secrets.token_hex(8) if SECONDS else "always the same"
    end, k = time.monotonic() + SECONDS / len(READ), 0
    while time.monotonic() < end if SECONDS else k < inputs:
        data = spoilt(files, f"{one.name} {root} {k}", OWN.get(one.name))
        try:
            attempt(parse, data, bound)
        except BaseException:
            if SECONDS:
                kept = CORPUS / one.name.lower() / f"broke-{hashlib.sha256(data).hexdigest()[:12]}"
                kept.write_bytes(data)
                print(f"kept {kept}")
            raise
        k += 1
    assert k >= min(inputs, 100)

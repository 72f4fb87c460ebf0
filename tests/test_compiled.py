"""Compiled functions, kept on the disk, follow what they are made of."""

from __future__ import annotations

import subprocess
import sys

import pytest

INNER = "from gearwright.compiled import compiled\n@compiled\ndef inner(x):\n    return x + {}\n"
OUTER = """
from gearwright.compiled import compiled
from .inner import inner
@compiled
def outer(x):
    return inner(x)
"""
RUN = """
import sys
import gearwright, gearwright.compiled as c
gearwright.__path__.append(sys.argv[1])
said = []
from gearwright.made.outer import outer
with c.telling(said.append):
    print(outer(1), outer(2.5), said)
"""


@pytest.fixture
def made(tmp_path):
    """A package of two functions, the outer of which calls the inner."""
    made = tmp_path / "made"
    made.mkdir()
    (made / "__init__.py").touch()
    (made / "outer.py").write_text(OUTER)
    (made / "inner.py").write_text(INNER.format(10))
    return made


def run(folder):
    done = subprocess.run([sys.executable, "-c", RUN, str(folder)], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def test_a_change_in_another_file_is_compiled_anew(tmp_path, made):
    # told of each of the two functions, whole number and fraction: the inner one while the outer is compiled
    assert run(tmp_path) == "11 12.5 [True, False, True, False]"
    assert run(tmp_path) == "11 12.5 []"  # kept
    (made / "inner.py").write_text(INNER.format(300))
    assert run(tmp_path).startswith("301 302.5 [True, False")


def test_without_a_folder_to_keep_it_in_it_works(tmp_path, made):
    nowhere = f"import os; os.environ['NUMBA_CACHE_DIR'] = {str(tmp_path / 'file' / 'x')!r}\n"
    (tmp_path / "file").touch()
    done = subprocess.run(
        [sys.executable, "-c", nowhere + RUN, str(tmp_path)], capture_output=True, text=True, check=True
    )
    assert done.stdout.startswith("11 12.5")

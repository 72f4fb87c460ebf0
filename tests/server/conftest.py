from collections.abc import Callable
from types import SimpleNamespace

import pytest

from gearwright.cli import main


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., SimpleNamespace]:
    """Runs a command line in this process; what it wrote to stdout and stderr, and its exit code."""

    def in_process(*words: object) -> SimpleNamespace:
        code = main([str(word) for word in words])
        captured = capsys.readouterr()
        return SimpleNamespace(code=code, out=captured.out, err=captured.err)

    return in_process

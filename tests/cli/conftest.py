from collections.abc import Callable
from dataclasses import dataclass

import pytest

from gearwright.cli import main


@dataclass(frozen=True)
class Outcome:
    code: int
    out: str
    err: str


Run = Callable[..., Outcome]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Runs a command line in this process; what it wrote to stdout and stderr, and its exit code."""

    def in_process(*words: object) -> Outcome:
        code = main([str(word) for word in words])
        captured = capsys.readouterr()
        return Outcome(code, captured.out, captured.err)

    return in_process


@pytest.fixture
def pair_options() -> list[str]:
    """A complete 16/20 pair."""
    return "--teeth 16 20 --module 4 --face-width 15 --root radial --ends spherical".split()

"""How a job can end other than by its last answer, and what those who asked are told."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

LOST = "A worker was lost and has been replaced."
"""The note to those whose job it had."""


class JobError(Exception):
    """A job that did not end by itself."""


class JobRefusedError(JobError):
    """What was asked for cannot be. problems   {"parameter", "member", "subject", "message"} each"""

    def __init__(self, headline: str, problems: Sequence[dict[str, Any]] = ()):
        super().__init__(headline)
        self.headline = headline
        self.problems = tuple(problems)


class JobFailedError(JobError):
    """A job that failed through no fault of the asker's. lost   whether its worker had to be replaced"""

    def __init__(self, text: str, *, lost: bool = False):
        super().__init__(text)
        self.text = text
        self.lost = lost


class JobCancelledError(JobError):
    """A job that nobody waits for any more."""


class BusyError(JobError):
    """So many jobs wait that no more are taken."""

"""Refusals as plain values: the headline and the problems, each with the parameter and the member that it is about."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

from ..errors import GearwrightError, Problem, ProblemsError

_MEMBERS = ("pinion", "gear")
_START = re.compile(rf"(?:({'|'.join(_MEMBERS)}) )?(\w+)")


def refused(error: GearwrightError, parameters: Collection[str] = ()) -> dict[str, Any]:
    """{"headline", "problems"} of an error. parameters   the names that a subject may start with"""
    if isinstance(error, ProblemsError):
        return {"headline": error.headline, "problems": [_problem(one, parameters) for one in error.problems]}
    return {"headline": "This cannot be done", "problems": [told(str(error))]}


def told(message: str, subject: str = "") -> dict[str, Any]:
    """A problem that is about no one parameter."""
    return {"parameter": None, "member": None, "subject": subject, "message": message}


def _problem(problem: Problem, parameters: Collection[str]) -> dict[str, Any]:
    plain = told(problem.message, problem.subject)
    found = _START.match(problem.subject)
    if found is None or found[2] not in parameters:
        return plain
    return plain | {"parameter": found[2], "member": _MEMBERS.index(found[1]) if found[1] else None}

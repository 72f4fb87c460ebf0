"""Texts without the server's own folders: a file is told by its name alone."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from ..errors import GearwrightError, Problem, ProblemsError

_BELOW = r"(?:[/\\](?:[0-9a-f]{32}|files|new|old|\.[0-9a-f]{16}\.part)(?=[/\\]|$|[^\w.-]))*"
_WHOLE = "the folder"


def folders_of(request: object) -> list[str]:
    """The folders of the server that a job's request names, and that of the request in it."""
    found = []
    while isinstance(request, Mapping):
        if isinstance(folder := request.get("folder"), str) and folder:
            found.append(folder)
        request = request.get("request")
    return found


def without(value: Any, folders: Sequence[str]) -> Any:
    """A value with the names of files in place of where they lie, in all its texts."""
    match value:
        case str():
            for folder in folders:
                value = _cut(value, folder) if folder in value else value
            return value
        case Mapping():
            return {name: without(one, folders) for name, one in value.items()}
        case list() | tuple():
            return [without(one, folders) for one in value]
        case _:
            return value


def error_without(error: GearwrightError, folders: Sequence[str]) -> GearwrightError:
    """The same error, told so."""
    if not isinstance(error, ProblemsError):
        return type(error)(without(str(error), folders))
    problems = [Problem(*without((one.subject, one.message), folders)) for one in error.problems]
    return ProblemsError(without(error.headline, folders), problems)


def _cut(text: str, folder: str) -> str:
    """A text without a folder and those that the server makes in it."""
    return re.sub(rf"{re.escape(folder)}{_BELOW}([/\\]?)", lambda found: "" if found[1] else _WHOLE, text)

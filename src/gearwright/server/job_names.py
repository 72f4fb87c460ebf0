"""Where the functions are that workers run, for a server that loads none of them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..sources import Source

_HERE = "gearwright.server.jobs"


@dataclass(frozen=True, kw_only=True)
class JobNames:
    """Sources of generator functions, all of a request."""

    answers: Source = "gearwright.designs.live:answers"
    plot: Source = "gearwright.designs.plots:plot"
    file: Source = "gearwright.designs.writing:written"
    build: Source = f"{_HERE}:build"
    texts: Source = f"{_HERE}:texts"
    read: Source = f"{_HERE}:read"
    elements: Source = f"{_HERE}:elements"
    schema: Source = f"{_HERE}:schema"
    suffixes: Source = f"{_HERE}:suffixes"
    check_upload: Source = f"{_HERE}:check_upload"


def admitted(source: Source, request: Any, uploads: Path) -> tuple[Source, dict[str, Any]]:
    """The job, and its request, that puts files in place of a design's uploads and then does another."""
    return f"{_HERE}:admitted", {"source": source, "request": request, "folder": str(uploads)}

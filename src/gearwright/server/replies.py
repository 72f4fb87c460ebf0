"""Answers in JSON, refusals among them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from starlette.responses import Response

from .plain_json import written


def reply(value: Any, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """A value as JSON in UTF-8, not to be kept."""
    kept = {"cache-control": "no-store", **(headers or {})}
    return Response(written(value), status_code=status, media_type="application/json", headers=kept)


def refusal(
    status: int,
    headline: str,
    problems: Sequence[Mapping[str, Any]] = (),
    headers: Mapping[str, str] | None = None,
) -> Response:
    """{"headline", "problems"}."""
    return reply({"headline": headline, "problems": list(problems)}, status, headers)

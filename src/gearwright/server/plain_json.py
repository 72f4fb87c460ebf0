"""JSON in and out, bounded: what no design needs is refused before anything else looks at it."""

from __future__ import annotations

import json
import math
from typing import Any

from ..designs.toml_bounds import DEEPEST


class NoJsonError(ValueError):
    """A text that is no JSON, or JSON that no request can be."""


def parsed(data: bytes | str) -> Any:
    """The value of a JSON text. Raises NoJsonError where it is none, or has numbers or texts that JSON has not."""
    try:
        value = json.loads(data, parse_constant=_no_number)
    except RecursionError:
        raise NoJsonError("lists or tables are nested too deeply") from None
    except UnicodeDecodeError:
        raise NoJsonError("this is no text in UTF-8") from None
    except ValueError as error:
        raise NoJsonError(f"this is no JSON: {error}") from None
    _require_sound(value)
    return value


def written(value: Any) -> str:
    """A value as JSON text, without blanks."""
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False, allow_nan=False)


def _no_number(word: str) -> float:
    raise ValueError(f"{word} is no number")


def _require_sound(value: Any) -> None:
    level, depth = [value], 0
    while level:
        depth += 1
        if depth > DEEPEST:
            raise NoJsonError("lists or tables are nested too deeply")
        inner: list[Any] = []
        for one in level:
            if isinstance(one, float) and not math.isfinite(one):
                raise NoJsonError("a number is too large")
            if isinstance(one, str):
                _require_text(one)
            elif isinstance(one, dict):
                for key in one:
                    _require_text(key)
                inner.extend(one.values())
            elif isinstance(one, list):
                inner.extend(one)
        level = inner


def _require_text(text: str) -> None:
    try:
        text.encode()
    except UnicodeEncodeError:
        raise NoJsonError("a text holds half a character (a lone surrogate)") from None

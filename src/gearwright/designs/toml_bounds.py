"""What no design needs of TOML, refused before it costs time or breaks what reads on."""

from __future__ import annotations

import re
from typing import Any

MOST_BYTES = 1 << 20
DEEPEST = 24
"""Levels of lists and tables; the deepest design has seven."""

MOST_KEYS = 2000
"""In all tables together."""

_DOTTED = DEEPEST + 1
# possessive, and begun at no letter within a word: the time grows with the text and no faster
_LONG_KEY = re.compile(
    rf"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{_DOTTED}}}""",
)


def text_problem(text: str) -> str | None:
    """Why a text is not parsed, with its line; None where it may be."""
    if len(text) > MOST_BYTES:
        return f"this is too long for a design; at most {MOST_BYTES >> 20} MiB are read"
    if found := _LONG_KEY.search(text):
        line = text.count("\n", 0, found.start()) + 1
        return f"line {line}: a key has more than {DEEPEST} parts, which no design has"
    return None


def table_problem(table: dict[str, Any]) -> str | None:
    """Why what was parsed can be no design; None where it may be one."""
    level: list[tuple[str, Any]] = list(table.items())
    keys = len(table)
    for _ in range(DEEPEST):
        inner: list[tuple[str, Any]] = []
        for name, value in level:
            if isinstance(value, int) and not -(1 << 63) <= value < 1 << 63:
                return f"{name[:100]}: a whole number of more than 64 bits is too large for TOML"
            if isinstance(value, dict):
                keys += len(value)
                inner.extend(value.items())
            elif isinstance(value, list):
                inner.extend((name, one) for one in value)
        if keys > MOST_KEYS:
            return f"there are more than {MOST_KEYS} keys, which no design has"
        level = inner
    return "lists or tables are nested more deeply than any design" if level else None

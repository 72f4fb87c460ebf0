"""Values as TOML that reads back to the same values."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from typing import Any

from .kinds import NOT_THIS_MEMBER

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_WIDTH = 100  # columns beyond which a list has an item a line


def toml_text(table: Mapping[str, Any]) -> str:
    """A table as a TOML document: numbers in full, None in a list as "none", keys whose value is None left out."""
    return "".join(f"{_key(name)} = {_value(value, 0)}\n" for name, value in table.items() if value is not None)


def _key(name: str) -> str:
    return name if _BARE.fullmatch(name) else _string(name)


def _value(value: Any, indent: int) -> str:
    match value:
        case None:
            return _string(NOT_THIS_MEMBER)
        case bool():
            return "true" if value else "false"
        case int():
            return str(value)
        case float():
            return repr(value) if math.isfinite(value) else str(value)
        case str():
            return _string(value)
        case Mapping():
            entries = (f"{_key(name)} = {_value(one, indent)}" for name, one in value.items() if one is not None)
            return "{" + ", ".join(entries) + "}"
        case list() | tuple():
            return _list([_value(one, indent + 1) for one in value], indent)
        case _:
            raise TypeError(f"TOML has no word for {value!r}")


def _list(items: list[str], indent: int) -> str:
    line = "[" + ", ".join(items) + "]"
    if len(line) <= _WIDTH:
        return line
    inner = "    " * (indent + 1)
    return "[\n" + "".join(f"{inner}{item},\n" for item in items) + "    " * indent + "]"


def _string(text: str) -> str:
    """A basic string: JSON's escapes are TOML's, but for DEL, and for halves of pairs, which are no characters."""
    sound = text.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
    return json.dumps(sound, ensure_ascii=False).replace("\x7f", "\\u007f")

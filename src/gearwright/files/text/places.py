"""Refusals that name the line of a text, what stands there and what is expected."""

from __future__ import annotations

import re

from ...errors import FileError

MARK = b"\xef\xbb\xbf"
"""The byte order mark that some programs put before UTF-8."""

_SHOWN = 40
_WORD = re.compile(rb"[^\s]+")
AGAIN = "write the file again from the program that made it"


def with_line_feeds(text: bytes) -> bytes:
    """A text whose lines end with "\\n", perhaps after "\\r"; every character keeps its place."""
    return text if b"\n" in text else text.replace(b"\r", b"\n")


def line_at(text: bytes, place: int) -> int:
    """The number of the line, from 1, that a place lies in."""
    return text.count(b"\n", 0, place) + 1


def shown(text: str, most: int = _SHOWN) -> str:
    """Words of a file for a message: so many characters, on one line."""
    return "".join(c if c.isprintable() else "?" for c in text[:most])


def misfit(path: str, kind: str, text: bytes, place: int, wanted: str, *, found: str = "") -> FileError:
    """Says what stands at a place, unless `found` does, and what is expected there."""
    if not found:
        word = _WORD.match(text, place, place + _SHOWN)
        if word:
            found = f'"{shown(word[0].decode("ascii", "replace"))}"'
        else:
            found = "its end" if place < len(text) else "the end of the file"
    return FileError(
        f"{path}: not a whole {kind} file: line {line_at(text, place)} has {found} where {wanted} is expected; {AGAIN}"
    )

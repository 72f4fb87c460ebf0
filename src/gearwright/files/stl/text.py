"""STL files in text form.

solid NAME
  facet normal x y z
    outer loop
      vertex x y z   (three times)
    endloop
  endfacet           (as often as there are triangles)
endsolid NAME        (the whole as often as there are bodies)
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ..rounding import Written
from ..text.decimals import NO_NUMBER, NOT_FINITE, none_late, none_seen, read_late
from ..text.places import AGAIN, MARK, line_at, misfit, with_line_feeds
from .facets import FACET, NO_WORD, UNFINISHED, read_facets

_NAMES = re.compile(rb"[ \t\r\f\v]*(?P<end>end)?solid\b(?P<name>[^\n]*)", re.IGNORECASE)
"""Lines that hold names, which may be any words."""
_SAMPLE = 4096
_BINARY = re.compile(rb"[\x00-\x08\x0e-\x1f]")


class Solid(NamedTuple):
    """A solid of the file: its name and the corners (3 m, 3) of its triangles."""

    name: str
    corners: Array


def looks_like_text(data: bytes) -> bool:
    """Whether data begins like a text STL file: with "solid" and without binary characters nearby."""
    sample = data[:_SAMPLE].removeprefix(MARK)
    return sample.lstrip()[:5].lower() == b"solid" and not _BINARY.search(sample)


def parse_text(path: str, data: bytes) -> tuple[list[Solid], Written]:
    """The solids in their order, and what their coordinates look like.

    Raises FileError naming the line where the text is not that of an STL file.
    """
    text = with_line_feeds(data)
    if text.startswith(MARK):
        text = b" " * len(MARK) + text[len(MARK) :]
    ends = text.rfind(b"\n", 0, len(text.rstrip())) + 1
    if not text[ends:].lower().split()[:1] == [b"endsolid"]:
        raise FileError(
            f'{path}: a text STL file that does not end with "endsolid"; it is cut off; write or copy it again'
        )
    characters, seen = np.frombuffer(text, np.uint8), none_seen()
    solids = []
    heads = list(_heads(text))
    for head, after in zip(heads, [*heads[1:], None], strict=True):
        start, end = head.end(), after.start() if after else len(text)
        if not head["end"]:
            name = " ".join(head["name"].decode("utf-8", "replace").split())
            solids.append(Solid(name, _corners(path, text, characters, start, end, seen)))
        elif text[start:end].strip():
            place = start + len(text[start:end]) - len(text[start:end].lstrip())
            raise misfit(path, "text STL", text, place, '"solid" or the end')
    return solids, Written.of(seen)


def _heads(text: bytes) -> Iterator[re.Match[bytes]]:
    """The lines that hold names. Looking for the word first is several times faster than for its line."""
    small, place = text.lower(), 0
    while (found := small.find(b"solid", place)) >= 0:
        head = _NAMES.match(text, small.rfind(b"\n", place, found) + 1 or place)
        if head:
            yield head
        place = small.find(b"\n", found)
        place = len(text) if place < 0 else place


def _corners(path: str, text: bytes, characters: np.ndarray, start: int, end: int, seen: np.ndarray) -> Array:
    """Corners of the facets between two places, neither inside a facet."""
    if text[start:end].isspace():
        return np.empty((0, 3))
    problem, place, k, points, late = read_facets(characters, start, end, none_late(), seen)
    if not problem:
        beyond = read_late(text, points, late)
        problem, place = (NOT_FINITE, beyond) if beyond is not None else (problem, place)
    if problem == UNFINISHED:
        raise FileError(
            f"{path}: line {line_at(text, place)}: a facet of this text STL file is not complete, where"
            f' "{FACET[k]}" is expected the solid ends; it is cut off; {AGAIN}'
        )
    if problem:
        wanted = {
            NO_NUMBER: "a number",
            NOT_FINITE: "a finite number (this one is not finite)",
            NO_WORD: f'"{FACET[k]}"',
        }
        raise misfit(path, "text STL", text, place, wanted[problem])
    return points.reshape(-1, 3)

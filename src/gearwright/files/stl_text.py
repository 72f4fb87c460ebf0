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

import numpy as np

from ..arrays import Array
from ..errors import FileError

_FACET = b"facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 0 0 endloop endfacet".split()
_COORDINATES = np.array([8, 9, 10, 12, 13, 14, 16, 17, 18])
_KEYWORDS = np.array([k for k, word in enumerate(_FACET) if word != b"0"])
_NAMES = re.compile(rb"^[ \t\r\f\v]*(?:end)?solid\b[^\n]*", re.MULTILINE)
"""Lines that hold names, which may be any words."""
_CHUNK = 1 << 22
_LONGEST_WORD = 64
_SAMPLE = 4096
_BINARY = re.compile(rb"[\x00-\x08\x0e-\x1f]")


def looks_like_text(data: bytes) -> bool:
    """Whether data begins like a text STL file: with "solid" and without binary characters nearby."""
    sample = data[:_SAMPLE].removeprefix(b"\xef\xbb\xbf")
    return sample.lstrip()[:5].lower() == b"solid" and not _BINARY.search(sample)


def parse_text(path: str, data: bytes) -> Array:
    """Corners (m, 3, 3) of the triangles.

    Raises FileError naming the line where the text is not that of an STL file.
    """
    data = data.removeprefix(b"\xef\xbb\xbf").lower()
    if b"\n" not in data:
        data = data.replace(b"\r", b"\n")
    last_line = data.rstrip().rpartition(b"\n")[2].strip()
    if not last_line.startswith(b"endsolid"):
        raise FileError(
            f'{path}: a text STL file that does not end with "endsolid"; it is cut off; write or copy it again'
        )
    parts, start = [np.empty((0, 3, 3))], 0
    while start < len(data):
        end = data.find(b"endfacet", min(start + _CHUNK, len(data)))
        end = len(data) if end < 0 else end + len(b"endfacet")
        parts.append(_facets(path, data, start, end))
        start = end
    return np.concatenate(parts)


def _facets(path: str, data: bytes, start: int, end: int) -> Array:
    """Corners of the facets between two places, neither inside a facet."""
    text = _NAMES.sub(b"", data[start:end])
    words = text.split()
    if not words:
        return np.empty((0, 3, 3))
    if len(words) % len(_FACET) or max(map(len, words)) > _LONGEST_WORD or b"_" in text:  # 1_0 is 10 to Python alone
        raise _refusal(path, data, start, end)
    table = np.array(words).reshape(-1, len(_FACET))
    if np.any(table[:, _KEYWORDS] != np.array(_FACET)[_KEYWORDS]):
        raise _refusal(path, data, start, end)
    try:
        return table[:, _COORDINATES].astype(np.float64).reshape(-1, 3, 3)
    except ValueError:
        raise _refusal(path, data, start, end) from None


def _refusal(path: str, data: bytes, start: int, end: int) -> FileError:
    """Says which line is the first that does not fit."""
    line, place = data.count(b"\n", 0, start) + 1, 0
    for text in data[start:end].split(b"\n"):
        if not _NAMES.match(text):
            for word in text.split():
                if not _fits(word, _FACET[place]):
                    shown = word[:40].decode("ascii", "replace")
                    wanted = "a number" if _FACET[place] == b"0" else f'"{_FACET[place].decode()}"'
                    return FileError(
                        f'{path}: not a text STL file: line {line} has "{shown}" where {wanted} is expected;'
                        " write the file again from the program that made it"
                    )
                place = (place + 1) % len(_FACET)
        line += 1
    return FileError(
        f"{path}: the last facet of a text STL file is not complete; it is cut off; write or copy it again"
    )


def _fits(word: bytes, pattern: bytes) -> bool:
    if pattern != b"0":
        return word == pattern
    try:
        float(word)
    except ValueError:
        return False
    return len(word) <= _LONGEST_WORD and b"_" not in word

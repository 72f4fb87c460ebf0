"""OFF files: vertices and faces of any number of corners, as text or binary.

[ST][C][N]OFF [BINARY]
vertices faces edges
x y z [normal] [colour] [texture]    a vertex a line
corners numbers… [colour]            a face a line; numbers from 0
"""

from __future__ import annotations

import re

import numpy as np

from ...errors import FileError
from ...moments.faces import Corners
from ..contents import Body, Contents, Data
from ..noted_unit import noted_unit
from ..parts import used_alone
from ..rounding import Written
from ..text.decimals import NO_NUMBER, NOT_FINITE, none_late, none_seen, read_late
from ..text.places import AGAIN, MARK, misfit, with_line_feeds
from ..text.rows import CORNERS, FEW_CORNERS, NO_COUNT, NO_VERTEX, X, next_place, read_rows
from .binary import parse_binary

_HEADER = re.compile(rb"(?P<parts>(?:ST)?C?N?)(?P<four>4?)(?P<any>n?)OFF(?![^\s#])[ \t]*(?P<binary>BINARY\b)?")
_WORD = re.compile(rb"[^\s#]+")
_COUNT = re.compile(rb"[+]?\d{1,18}\Z")
_SHORTEST = {"vertices": len("0 0 0\n"), "faces": len("3 0 0 0\n")}
_VERTEX = np.array([X, X + 1, X + 2])
_FACE = np.array([CORNERS])


def parse(data: Data, name: str) -> Contents:
    """The one body of an OFF file, text or binary. Polygons stay whole; vertices without faces are left out.

    Normals, colours and texture are ignored, and so is the count of edges. Rounding is as `Written.rounding` finds it
    in text, that of single precision in binary files.
    Raises FileError with the place and what stands there if the file is no whole OFF file of 3 dimensions.
    """
    data = bytes(data)
    if not data.strip():
        raise FileError(f"{name}: the file is empty; an OFF file was expected; write it again")
    text = with_line_feeds(data)
    start = next_place(text, len(MARK) if data.startswith(MARK) else 0)
    header = _HEADER.match(text, start)
    if not header:
        raise misfit(name, "OFF", text, start, 'the word that begins such files, "OFF", "COFF" or "NOFF",')
    _require_three_dimensions(name, header)
    if header["binary"]:
        body = parse_binary(data, data.find(b"\n", header.end()) + 1 or len(data), header["parts"].decode(), name)
    else:
        body = _text(text, header, name)
    return Contents(bodies=(body,), length_unit=noted_unit(data))


def _require_three_dimensions(path: str, header: re.Match[bytes]) -> None:
    if header["four"] or header["any"]:
        raise FileError(
            f"{path}: its vertices have {'4' if header['four'] else 'any number of'} coordinates"
            f" ({header[0].decode().strip()}); bodies have 3: write an OFF file"
        )


def _text(text: bytes, header: re.Match[bytes], path: str) -> Body:
    place = header.end()
    counts: dict[str, int] = {}
    for what in ("vertices", "faces"):
        place, counts[what] = _count(path, text, place, what)
    place = text.find(b"\n", place)
    place = len(text) if place < 0 else place
    _require_room(path, text, place, counts)
    characters, seen = np.frombuffer(text, np.uint8), none_seen()
    table = read_rows(characters, place, counts["vertices"], _VERTEX, 0, False, none_late(), seen)
    if table.problem:
        raise _refusal(path, text, table.place, table.problem, counts)
    beyond = read_late(text, table.points, table.late)
    if beyond is not None:
        raise _refusal(path, text, beyond, NOT_FINITE, counts)
    faces = read_rows(
        characters, table.place, counts["faces"], _FACE, counts["vertices"], False, none_late(), none_seen()
    )
    if faces.problem:
        raise _refusal(path, text, faces.place, faces.problem, counts)
    end = next_place(text, faces.place)
    if end < len(text):
        raise misfit(
            path, "OFF", text, end, f"the end, after {counts['vertices']} vertices and {counts['faces']} faces,"
        )
    points, corners = used_alone(table.points.reshape(-1, 3), Corners(faces.indices, faces.offsets))
    rounding = Written.of(seen).rounding(points)
    return Body(name="", vertices=points, indices=corners.indices, offsets=corners.offsets, rounding=rounding)


def _count(path: str, text: bytes, place: int, what: str) -> tuple[int, int]:
    place = next_place(text, place)
    word = _WORD.match(text, place)
    if not word or not _COUNT.match(word[0]):
        raise misfit(path, "OFF", text, place, f"the number of {what}")
    if not int(word[0]):
        raise FileError(f"{path}: an OFF file without {what}; nothing was exported, or no polygons")
    return word.end(), int(word[0])


def _require_room(path: str, text: bytes, place: int, counts: dict[str, int]) -> None:
    least = sum(count * _SHORTEST[what] for what, count in counts.items()) - 1
    if least > len(text) - place:
        raise FileError(
            f"{path}: not a whole OFF file: it announces {counts['vertices']} vertices and {counts['faces']} faces,"
            f" which take at least {least} bytes, and has {len(text) - place}; it is cut off, or the counts are wrong;"
            f" {AGAIN}"
        )


def _refusal(path: str, text: bytes, place: int, problem: int, counts: dict[str, int]) -> FileError:
    wanted = {
        NO_NUMBER: "a number",
        NOT_FINITE: "a finite number (this one is not finite)",
        NO_COUNT: "the number of corners of a face",
        NO_VERTEX: f"the number of a vertex, 0 to {counts['vertices'] - 1},",
        FEW_CORNERS: "one of at least 3",
    }
    found = "a face of fewer than 3 corners" if problem == FEW_CORNERS else ""
    return misfit(path, "OFF", text, place, wanted[problem], found=found)

"""The data of PLY files in text: a line for every row of an element."""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import FileError
from ...moments.faces import Corners
from ..rounding import Written
from ..text.decimals import NO_NUMBER, NOT_FINITE, none_late, none_seen, read_late
from ..text.places import AGAIN, misfit, with_line_feeds
from ..text.rows import (
    CORNERS,
    FEW_CORNERS,
    NO_COUNT,
    NO_VERTEX,
    PASSED,
    PASSED_LIST,
    TOO_MUCH,
    Rows,
    X,
    next_place,
    read_rows,
)
from .header import LISTS, Element, Header, Property


def read_text(data: bytes, header: Header, path: str) -> tuple[Array, Corners, float]:
    """Vertices (n, 3), faces, and how far the text rounds. Raises FileError with the line that does not fit."""
    text = with_line_feeds(data)
    place, seen, total = header.end, none_seen(), _count(header, "vertex")
    points, corners = np.empty((0, 3)), Corners(np.empty(0, np.int64), np.zeros(1, np.int64))
    for element in header.elements:
        rows = _rows(path, text, place, element, total, seen if element.name == "vertex" else none_seen())
        place = rows.place
        if element.name == "vertex":
            points = rows.points.reshape(-1, 3)
        elif element.name == "face":
            corners = Corners(rows.indices, rows.offsets)
    end = next_place(text, place)
    if end < len(text):
        raise misfit(path, "PLY", text, end, "the end, after all that its header announces,")
    return points, corners, Written.of(seen).rounding(points)


def _count(header: Header, name: str) -> int:
    element = header.element(name)
    return element.count if element else 0


def _rows(path: str, text: bytes, place: int, element: Element, total: int, seen: np.ndarray) -> Rows:
    least = element.count * 2 * len(element.properties) - 1  # a character and what ends it
    if least > len(text) - place:
        raise FileError(
            f"{path}: not a whole PLY file: {element.count} rows of {element.name} are announced, which take at least"
            f" {least} bytes, and {max(len(text) - place, 0)} are left; it is cut off, or the count is wrong; {AGAIN}"
        )
    parts = np.array([_part(element, one) for one in element.properties])
    rows = read_rows(np.frombuffer(text, np.uint8), place, element.count, parts, total, True, none_late(), seen)
    problem, where = rows.problem, rows.place
    if not problem:
        beyond = read_late(text, rows.points, rows.late)
        problem, where = (NOT_FINITE, beyond) if beyond is not None else (problem, where)
    if problem:
        raise _refusal(path, text, where, problem, element, total)
    return rows


def _part(element: Element, one: Property) -> int:
    if element.name == "face" and one is element.named(*LISTS):
        return CORNERS
    if one.count_type:
        return PASSED_LIST
    return X + "xyz".index(one.name) if element.name == "vertex" and one.name in ("x", "y", "z") else PASSED


def _refusal(path: str, text: bytes, place: int, problem: int, element: Element, total: int) -> FileError:
    wanted = {
        NO_NUMBER: f"a number ({element.name}: {element.listed})",
        NOT_FINITE: "a finite number (this one is not finite)",
        NO_COUNT: f"the count of a list ({element.name}: {element.listed})",
        NO_VERTEX: f"the number of a vertex, 0 to {total - 1},"
        if element.name == "face"
        else f"the next number of a list ({element.name}: {element.listed})",
        FEW_CORNERS: "one of at least 3",
        TOO_MUCH: f"the end of the line ({element.name}: {element.listed})",
    }
    found = "a face of fewer than 3 corners" if problem == FEW_CORNERS else ""
    return misfit(path, "PLY", text, place, wanted[problem], found=found)

"""Paths in space from files of points."""

from __future__ import annotations

import math
import re
from pathlib import Path as FilePath

from ..disk import contents
from ..errors import FileError, GeometryError
from .path import Path, path_through

_SEPARATOR = re.compile(r"\s*[,;]\s*|\s+")
_MOST_NAMED = 5  # wrong lines in one refusal
_MOST_LINES = 1_000_000

Point = tuple[float, float, float]


def path_from_file(path: str | FilePath) -> Path:
    """The cubic spline through the points of a CSV file; closed where the last point is the first again.

    A point is a line "x, y, z", with commas, semicolons or blanks between the numbers; # begins a comment, and the
    first line may be a heading. Raises FileError naming the lines that are not so; GeometryError where there is no
    smooth path through the points; MachineError where the file cannot be read.
    """
    points = _points(str(path), _text(path))
    try:
        return path_through(points)
    except GeometryError as error:
        raise GeometryError(f"{path}: no path leads through these points", error.problems) from None


def _text(path: str | FilePath) -> str:
    if FilePath(path).suffix.lower() != ".csv":
        raise FileError(f"{path}: a path is read from a .csv file of lines x, y, z")
    try:
        text = contents(path).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise FileError(f"{path}: this is no text; a line x, y, z for each point was expected") from None
    if text.count("\n") > _MOST_LINES:
        raise FileError(f"{path}: more than {_MOST_LINES} lines; a spline through fewer points will do")
    return text


def _points(source: str, text: str) -> list[Point]:
    points: list[Point] = []
    wrong: list[str] = []
    heading_allowed = True
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.split("#", 1)[0].strip()
        if not bare:
            continue
        fields = _SEPARATOR.split(bare)
        point = _point(fields)
        if point is not None:
            points.append(point)
        elif not heading_allowed or any(map(_is_number, fields)):
            wrong.append(f"  line {number}: {line.strip()[:60]!r}")
        heading_allowed = False
    if wrong:
        more = [f"  and {len(wrong) - _MOST_NAMED} lines more"] if len(wrong) > _MOST_NAMED else []
        headline = f"{source}: a point of the path is a line of three finite numbers, x, y, z, with a decimal point:"
        raise FileError("\n".join([headline, *wrong[:_MOST_NAMED], *more]))
    if len(points) < 2:
        raise FileError(f"{source}: it holds {len(points)} points; a path needs at least two, a line x, y, z for each")
    return points


def _point(fields: list[str]) -> Point | None:
    if len(fields) != 3 or not all(map(_is_number, fields)):
        return None
    x, y, z = map(float, fields)
    return (x, y, z) if all(map(math.isfinite, (x, y, z))) else None


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return "_" not in field  # Python would read 1_0 as 10

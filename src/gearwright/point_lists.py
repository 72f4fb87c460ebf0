"""Points as text: a line of numbers a point, an empty line between runs of them."""

from __future__ import annotations

import math
import re

from .errors import FileError

_SEPARATOR = re.compile(r"\s*[,;]\s*|\s+")
_MOST_NAMED = 8  # wrong lines in one refusal
_NUMBERS = {2: "two", 3: "three"}

Point = tuple[float, ...]


def point_runs(source: str, data: bytes, *, what: str, names: str, most: int) -> list[tuple[int, list[Point]]]:
    """Runs of points, each with the number of the line where it starts.

    source   what the text is called in refusals
    what     what a line is: "a corner"
    names    of the coordinates: "x, y"
    most     lines accepted

    Numbers stand between commas, semicolons or blanks, with a decimal point; # begins a comment; the first line may be
    a heading. Raises FileError naming the lines that are not so.
    """
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise FileError(f"{source}: this is no text of points; a line {names} for {what} was expected") from None
    if text.count("\n") > most:
        raise FileError(f"{source}: more than {most} lines; fewer points will do")
    count = names.count(",") + 1
    runs: list[tuple[int, list[Point]]] = []
    wrong: list[str] = []
    gap, heading_allowed = True, True
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.split("#", 1)[0].strip()
        if not bare:
            gap = gap or not line.strip()
            continue
        fields = _SEPARATOR.split(bare)
        heading = heading_allowed and not any(map(_is_number, fields))
        heading_allowed = False
        if heading:
            continue
        point = _point(fields, count)
        if point is None:
            wrong.append(f"  line {number}: {line.strip()[:60]!r}")
            continue
        if gap:
            runs.append((number, []))
        runs[-1][1].append(point)
        gap = False
    if wrong:
        more = [f"  and {len(wrong) - _MOST_NAMED} lines more"] if len(wrong) > _MOST_NAMED else []
        headline = (
            f"{source}: {what} is a line of {_NUMBERS[count]} finite numbers, {names}, with a point as the decimal sign"
            " and a comma, semicolon or blank between them:"
        )
        raise FileError("\n".join([headline, *wrong[:_MOST_NAMED], *more]))
    return runs


def _point(fields: list[str], count: int) -> Point | None:
    if len(fields) != count or not all(map(_is_number, fields)):
        return None
    point = tuple(map(float, fields))
    return point if all(map(math.isfinite, point)) else None


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return "_" not in field  # Python would read 1_0 as 10

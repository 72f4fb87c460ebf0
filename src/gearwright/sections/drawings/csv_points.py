"""Points of polygons as text: a line of x and y a corner, an empty line between loops."""

from __future__ import annotations

import re

import numpy as np

from ...curves.curve import Curve
from ...curves.line import lines_through
from ...errors import FileError
from .sheet import MOST_CURVES, Sheet

_SEPARATOR = re.compile(r"\s*[,;]\s*|\s+")

_MOST_NAMED = 8
"""Lines named in one refusal."""

Corner = tuple[float, float]


def read(source: str, data: bytes, layer: str | None) -> Sheet:
    """The sides of the polygons, one a run of lines.

    A corner is "x, y", "x; y" or "x y" with a point as the decimal sign; # begins a comment; the first line
    may be a heading. The last corner may repeat the first one. Raises FileError naming the lines that are not so.
    """
    if layer is not None:
        raise FileError(f"{source}: a list of points has no layers; leave out layer={layer!r}")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise FileError(
            f"{source}: this is no text of points; a line of x and y for each corner was expected"
        ) from None
    if text.count("\n") > MOST_CURVES:
        raise FileError(f"{source}: more than {MOST_CURVES} lines; that many corners are no drawing of a section")
    curves: list[Curve] = []
    for first_line, corners in _loops(source, text):
        closed = corners if corners[0] == corners[-1] else [*corners, corners[0]]
        if len(set(closed)) < 3:
            raise FileError(
                f"{source}: line {first_line}: a loop of {len(set(closed))} different corners; at least 3 are needed, "
                "and an empty line ends a loop"
            )
        curves += lines_through(closed)
    return Sheet(curves=tuple(curves), passed_over={})


def _loops(source: str, text: str) -> list[tuple[int, list[Corner]]]:
    """Runs of corners with the number of the line where each starts."""
    loops: list[tuple[int, list[Corner]]] = []
    wrong: list[str] = []
    gap, heading_allowed = True, True
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.split("#", 1)[0].strip()
        if not bare:
            gap = gap or not line.strip()
            continue
        fields = _SEPARATOR.split(bare)
        if heading_allowed and not any(map(_is_number, fields)):
            heading_allowed = False
            continue
        heading_allowed = False
        corner = _corner(fields)
        if corner is None:
            wrong.append(f"  line {number}: {line.strip()[:60]!r}")
        elif gap:
            loops.append((number, [corner]))
        else:
            loops[-1][1].append(corner)
        gap = False if corner else gap
    if wrong:
        _refuse(source, wrong)
    return loops


def _corner(fields: list[str]) -> Corner | None:
    if len(fields) != 2 or not all(map(_is_number, fields)):
        return None
    x, y = map(float, fields)
    return (x, y) if np.isfinite(x) and np.isfinite(y) else None


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return True


def _refuse(source: str, wrong: list[str]) -> None:
    more = [f"  and {len(wrong) - _MOST_NAMED} lines more"] if len(wrong) > _MOST_NAMED else []
    headline = (
        f"{source}: a corner is a line of two finite numbers, x and y, with a point as the decimal sign and "
        "a comma, semicolon or blank between them:"
    )
    raise FileError("\n".join([headline, *wrong[:_MOST_NAMED], *more]))

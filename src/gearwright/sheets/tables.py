"""Tables and the title block of a sheet, as marks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..arrays import Array
from .content import Content, Row, Table, TitleBlock
from .line_kinds import CENTRE, THIN, VISIBLE
from .marks import Mark, Text, circle, line, polyline
from .papers import Paper

_INDENT = 1.2  # of text from the side of its cell
_COLUMNS = (0.60, 0.14, 0.26)  # of the data table: name, symbol, value
Align = Literal["left", "centre", "right"]


@dataclass(frozen=True, kw_only=True)
class Cell:
    """A rectangle and what is written in it. text   what follows its first underscore is lower, if `symbol`"""

    low: tuple[float, float]
    high: tuple[float, float]
    text: str
    height: float
    align: Align = "left"
    symbol: bool = False

    @property
    def mark(self) -> Text:
        """The text, as small as it must be to stand within the cell."""
        (left, low), (right, high) = self.low, self.high
        x = {"left": left + _INDENT, "centre": (left + right) / 2.0, "right": right - _INDENT}[self.align]
        height = min(self.height, 0.6 * (high - low))
        at = np.array([x, (low + high) / 2.0 - 0.46 * height])
        base, _, lower = self.text.partition("_") if self.symbol else (self.text, "", "")
        whole = Text(text=base, subscript=lower, at=at, height=height, align=self.align)
        return whole.fitting(right - left - 2.0 * _INDENT)


def data_cells(rows: Sequence[Row], paper: Paper, left: float, top: float, row: float) -> list[Cell]:
    """Cells of the data table, whose upper left corner is given; row is a row's height."""
    edges = left + paper.data * np.cumsum([0.0, *_COLUMNS])
    cells = []
    for k, one in enumerate(rows):
        high = top - k * row
        for column, (text, align) in enumerate(((one.name, "left"), (one.symbol, "centre"), (one.value, "right"))):
            corner, other = (float(edges[column]), high - row), (float(edges[column + 1]), high)
            cells.append(
                Cell(low=corner, high=other, text=text, height=paper.lettering, align=align, symbol=column == 1)  # type: ignore[arg-type]
            )
    return cells


def number_cells(table: Table, paper: Paper, left: float, top: float, row: float) -> list[Cell]:
    """Cells of a table of numbers, all equally wide."""
    columns = max(len(one) for one in table.rows)
    step = paper.data / columns
    return [
        Cell(
            low=(left + j * step, top - (k + 1) * row),
            high=(left + (j + 1) * step, top - k * row),
            text=text,
            height=paper.lettering * 0.92,
            align="centre" if k == 0 else "right",
        )
        for k, one in enumerate(table.rows)
        for j, text in enumerate(one)
    ]


def ruled(cells: Sequence[Cell]) -> list[Mark]:
    """The text of the cells and the lines around them, those of the whole thick."""
    boxes = {(*cell.low, *cell.high) for cell in cells}
    marks: list[Mark] = [cell.mark for cell in cells if cell.text]
    rules = {(a, d, c, d) for a, _, c, d in boxes} | {(a, b, a, d) for a, b, _, d in boxes}
    marks += [line(r[:2], r[2:], THIN) for r in sorted(rules)]
    corners = np.array(sorted(boxes))
    (left, low), (right, high) = corners[:, :2].min(axis=0), corners[:, 2:].max(axis=0)
    return [*marks, rectangle(left, low, right, high)]


def rectangle(left: float, low: float, right: float, high: float) -> Mark:
    """A thick frame."""
    return polyline([(left, low), (right, low), (right, high), (left, high)], VISIBLE, closed=True)


def title_marks(content: Content, title: TitleBlock, paper: Paper, scale: str) -> list[Mark]:
    """The title block in the lower right corner of the frame."""
    width, height = paper.title_block
    left, low = paper.frame[2] - width, paper.frame[1]
    third = height / 3.0
    edges = left + width * np.array([0.0, 0.56, 0.72, 0.86, 1.0])
    number, count = title.sheet
    fields = [
        [("Part", title.name or content.title), ("Material", title.material or ""), ("Mass", title.mass or "")],
        [("Description", content.description), ("Scale", scale), ("Lengths in", content.length_unit)],
        [("Made by", title.made_by), ("Date", title.date or ""), ("Size", paper.name), ("Sheet", f"{number}/{count}")],
    ]
    marks: list[Mark] = []
    for i, row in enumerate(fields):
        top = low + height - i * third
        for j, (label, text) in enumerate(row):
            right = edges[4] if (i, j) == (0, 2) else edges[j + 1]
            box = (float(edges[j]), top - third), (float(right), top)
            marks += _field(*box, label, text, first=(i, j) == (0, 0))
    marks += _first_angle(np.array([(edges[3] + edges[4]) / 2.0, low + 1.5 * third]), third)
    return [*marks, rectangle(left, low, left + width, low + height)]


def _field(low: tuple[float, float], high: tuple[float, float], label: str, text: str, *, first: bool) -> list[Mark]:
    """A field with its name small above what is written in it; the first one is larger."""
    tall = high[1] - low[1]
    middle = low[1] + 0.68 * tall
    named = Cell(low=(low[0], middle), high=high, text=label, height=1.8)
    large = 5.0 if first else 3.0
    written = Cell(low=low, high=(high[0], middle), text=text, height=large)
    lines = [line((low[0], low[1]), (high[0], low[1]), THIN), line((low[0], low[1]), (low[0], high[1]), THIN)]
    return [*lines, named.mark, *([written.mark] if text else [])]


def _first_angle(middle: Array, room: float) -> list[Mark]:
    """The sign of first angle projection: a cone from the side, its larger end to the left, and from its small end.

    Source: ISO 5456-2.
    """
    r, x, y = 0.3 * room, *middle
    cone, end = x - 1.3 * r, x + 1.3 * r
    sides = [(cone - r, y - r), (cone + r, y - r / 2.0), (cone + r, y + r / 2.0), (cone - r, y + r)]
    return [
        polyline(sides, THIN, closed=True),
        circle(r, THIN, (end, y)),
        circle(r / 2.0, THIN, (end, y)),
        line((cone - 1.4 * r, y), (cone + 1.4 * r, y), CENTRE),
        line((end - 1.3 * r, y), (end + 1.3 * r, y), CENTRE),
        line((end, y - 1.3 * r), (end, y + 1.3 * r), CENTRE),
    ]

"""A sheet laid out: frame, title block, data at the right, views as large as they can be in what is left."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..arrays import Array
from ..errors import ParameterError, Problem
from .content import Content, TitleBlock
from .dimensioning import Drafting
from .line_kinds import FRAME
from .marks import Mark, Sheet, Text, polyline
from .papers import PAPERS, Paper
from .scales import in_words, on_paper, scales
from .tables import data_cells, number_cells, ruled, title_marks
from .views import View

_CLEAR = 5.0  # between frame, tables and views
_BETWEEN = 12.0  # views
_CAPTION = 3.5


def sheet(content: Content, title: TitleBlock) -> Sheet:
    """The sheet of a part. Raises ParameterError for paper that is not known."""
    if title.paper not in PAPERS:
        wanted = f"choose {' or '.join(PAPERS)}"
        raise ParameterError("The sheet", [Problem(f"paper = {title.paper!r}", wanted)])
    paper = PAPERS[title.paper]
    left, low, right, high = paper.frame
    area = np.array(
        [
            [left + _CLEAR, low + paper.title_block[1] + _CLEAR],
            [right - paper.data - _CLEAR, high - _CLEAR],
        ]
    )
    scale, views = _largest(content.views, area, content.length_unit)
    marks = [
        polyline([(left, low), (right, low), (right, high), (left, high)], FRAME, closed=True),
        *title_marks(content, title, paper, in_words(scale)),
        *_tables(content, paper),
        *_notes(content, paper),
        *views,
    ]
    return Sheet(size=(paper.width, paper.height), scale=scale, unit=content.length_unit, marks=tuple(marks))


def _tables(content: Content, paper: Paper) -> list[Mark]:
    """The data, and other tables below them, in rows that are less high where there are many."""
    left, top = paper.frame[2] - paper.data, paper.frame[3]
    counts = [len(content.rows), *(len(table.rows) for table in content.tables)]
    headings = len(counts)
    room = top - paper.frame[1] - paper.title_block[1] - _CLEAR
    row = min(paper.row, room / (sum(counts) + 1.6 * headings))
    marks: list[Mark] = []
    cells = [data_cells(content.rows, paper, left, top - 1.4 * row, row)]
    tops = [top]
    for table in content.tables:
        tops.append(tops[-1] - (1.6 + counts[len(tops) - 1]) * row)
        cells.append(number_cells(table, paper, left, tops[-1] - 1.4 * row, row))
    for at, name, group in zip(tops, ["Data", *(table.title for table in content.tables)], cells, strict=True):
        heading = Text(text=name, at=np.array([left + 1.2, at - row]), height=min(1.2 * paper.lettering, 0.6 * row))
        marks += [heading.fitting(paper.data - 2.4), *ruled(group)]
    return marks


def _notes(content: Content, paper: Paper) -> list[Mark]:
    """General notes to the left of the title block, numbered, in lines as long as there is room for."""
    left, low, right, _ = paper.frame
    room = right - paper.title_block[0] - left - 2.0 * _CLEAR
    lines = [line for k, note in enumerate(content.notes, 1) for line in wrapped(f"{k}  {note}", room, paper.lettering)]
    if not lines:
        return []
    step = min(1.8 * paper.lettering, (paper.title_block[1] - 4.0) / len(lines))
    height = min(paper.lettering, 0.62 * step)
    top = low + paper.title_block[1] - 2.0
    return [
        Text(text=text, at=np.array([left + _CLEAR, top - (k + 1) * step]), height=height).fitting(room)
        for k, text in enumerate(lines)
    ]


def wrapped(text: str, room: float, height: float) -> list[str]:
    """The text in lines of at most a width, broken at blanks; a longer word has a line of its own."""
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}" if lines[-1] else word
        if lines[-1] and Text(text=longer, at=np.zeros(2), height=height).width > room:
            lines.append(f"    {word}")
        else:
            lines[-1] = longer
    return lines


def _largest(views: Sequence[View], area: Array, length_unit: str) -> tuple[float, list[Mark]]:
    """The largest of the scales at which the views have room in an area (2, 2), beside or below each other."""
    for scale in scales():
        for beside in (True, False):
            placed = _arranged(views, area, on_paper(scale, length_unit), length_unit, beside=beside)
            if placed is not None:
                return scale, placed
    raise ParameterError("The sheet", [Problem("the part", "is too large for any scale of ISO 5455")])


def _arranged(
    views: Sequence[View], area: Array, factor: float, length_unit: str, *, beside: bool
) -> list[Mark] | None:
    """The views with what is dimensioned in them, aligned; None where they have no room."""
    room = area[1] - area[0]
    if np.any([factor * np.ptp(view.box(), axis=0) > room for view in views]):
        return None
    boxes = [_extent(_with_caption(view, Drafting(factor=factor, shift=(0.0, 0.0), length_unit=length_unit))) for view in views]
    along, across = (0, 1) if beside else (1, 0)
    lows, highs = np.array([box[0] for box in boxes]), np.array([box[1] for box in boxes])
    sizes = highs[:, along] - lows[:, along]
    whole = np.array([float(sizes.sum() + _BETWEEN * (len(views) - 1)), highs[:, across].max() - lows[:, across].min()])
    if np.any(whole > (room if beside else room[::-1])):
        return None
    free = room[along] - whole[0]
    spread = min(free / (len(views) + 1.0), 2.0 * _BETWEEN)
    start = (area[0] + area[1])[along] / 2.0 - (whole[0] + spread * (len(views) - 1)) / 2.0
    line = (area[0] + area[1])[across] / 2.0 - (highs[:, across].max() + lows[:, across].min()) / 2.0
    order = range(len(views)) if beside else reversed(range(len(views)))
    marks: list[Mark] = []
    for k in order:
        shift = np.zeros(2)
        shift[along], shift[across] = start - lows[k, along], line
        start += sizes[k] + _BETWEEN + spread
        drafting = Drafting(factor=factor, shift=(float(shift[0]), float(shift[1])), length_unit=length_unit)
        marks += _with_caption(views[k], drafting)
    return marks


def _with_caption(view: View, drafting: Drafting) -> list[Mark]:
    marks = drafting.marks(view)
    box = _extent(marks)
    middle = drafting.factor * view.box().mean(axis=0)[0] + drafting.shift[0]
    at = np.array([middle, box[1, 1] + _CAPTION])
    return [*marks, Text(text=view.title, at=at, height=3.0, align="centre")]


def _extent(marks: Sequence[Mark]) -> Array:
    points = np.concatenate([mark.samples() for mark in marks])
    return np.array([points.min(axis=0), points.max(axis=0)])

"""A sheet laid out: frame, title block, data at the right, views as large as they can be in what is left."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

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


@dataclass(frozen=True, kw_only=True, eq=False)
class _Arranged:
    """Views on paper. low   what is below them of their area is free, from this y on"""

    scale: float
    marks: tuple[Mark, ...]
    low: float


def _largest(views: Sequence[View], area: Array, length_unit: str) -> tuple[float, list[Mark]]:
    """The views of a part at the largest scale at which they have room, and below them details, larger still."""
    main, details = [view for view in views if not view.detail], [view for view in views if view.detail]
    found = _fitting(main, area, length_unit, top=bool(details))
    if not details:
        return found.scale, list(found.marks)
    left = np.array([area[0], [area[1, 0], found.low - _BETWEEN]])
    if left[1, 1] - left[0, 1] < _LEAST_DETAIL:
        return found.scale, list(_fitting(main, area, length_unit, top=False).marks)
    below = _fitting(details, left, length_unit, top=False, titled=True)
    if below.scale <= found.scale:
        return found.scale, list(_fitting(main, area, length_unit, top=False).marks)
    return found.scale, [*found.marks, *below.marks]


_LEAST_DETAIL = 40.0  # of the height that is left for details


def _fitting(views: Sequence[View], area: Array, length_unit: str, *, top: bool, titled: bool = False) -> _Arranged:
    """The views at the largest of the scales at which they have room in an area (2, 2), beside or below each other.

    top      as high in it as they can be, else in its middle
    titled   their captions say the scale
    """
    for scale in scales():
        named = [replace(view, title=f"{view.title}, {in_words(scale)}") for view in views] if titled else views
        for beside in (True, False):
            drafting = Drafting(factor=on_paper(scale, length_unit), shift=(0.0, 0.0), length_unit=length_unit)
            marks = _arranged(named, area, drafting, beside=beside, top=top)
            if marks is not None:
                return _Arranged(scale=scale, marks=tuple(marks), low=float(_extent(marks)[0, 1]))
    raise ParameterError("The sheet", [Problem("the part", "is too large for any scale of ISO 5455")])


def _arranged(views: Sequence[View], area: Array, drafting: Drafting, *, beside: bool, top: bool) -> list[Mark] | None:
    """The views with what is dimensioned in them, aligned; None where they have no room."""
    room = area[1] - area[0]
    if np.any([drafting.factor * np.ptp(view.box(), axis=0) > room for view in views]):
        return None
    boxes = np.array([_extent(_with_caption(view, drafting)) for view in views])
    along, across = (0, 1) if beside else (1, 0)
    sizes = boxes[:, 1, along] - boxes[:, 0, along]
    low, high = boxes[:, 0, across].min(), boxes[:, 1, across].max()
    whole = np.array([float(sizes.sum()) + _BETWEEN * (len(views) - 1), high - low])
    if np.any(whole > (room if beside else room[::-1])):
        return None
    spread = min((room[along] - whole[0]) / (len(views) + 1.0), 2.0 * _BETWEEN)
    start = area[:, along].mean() - (whole[0] + spread * (len(views) - 1)) / 2.0
    level = area[1, 1] - high if top and beside else area[:, across].mean() - (high + low) / 2.0
    marks: list[Mark] = []
    for k in range(len(views)) if beside else reversed(range(len(views))):
        shift = [0.0, 0.0]
        shift[along], shift[across] = float(start - boxes[k, 0, along]), float(level)
        start += sizes[k] + _BETWEEN + spread
        marks += _with_caption(views[k], replace(drafting, shift=(shift[0], shift[1])))
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

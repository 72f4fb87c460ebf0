"""Sizes of paper, and where on them things stand, in millimetres. Source: ISO 5457 (frame), ISO 7200 (title block)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Paper:
    """A landscape sheet: filing margin on the left, the title block at the right and below, data above it.

    title_block   its width and height
    data          width of the data table
    row           height of a row of a table, and `lettering` that of its letters
    """

    name: str
    width: float
    height: float
    title_block: tuple[float, float]
    data: float
    row: float
    lettering: float

    @property
    def frame(self) -> tuple[float, float, float, float]:
        """Left, lower, right and upper side."""
        return _FILING, _MARGIN, self.width - _MARGIN, self.height - _MARGIN


_FILING, _MARGIN = 20.0, 10.0

PAPERS: Mapping[str, Paper] = {
    paper.name: paper
    for paper in (
        Paper(name="A3", width=420.0, height=297.0, title_block=(180.0, 36.0), data=118.0, row=5.0, lettering=2.5),
        Paper(name="A4", width=297.0, height=210.0, title_block=(150.0, 30.0), data=88.0, row=4.0, lettering=1.9),
    )
}

"""What a sheet shows, before anything has a place on paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..parameters import Size
from . import numbers
from .views import View


@dataclass(frozen=True, kw_only=True)
class Row:
    """A row of the data table. symbol   what follows the first underscore is its subscript"""

    name: str
    symbol: str
    value: str

    @classmethod
    def of(cls, name: str, size: Size, length_unit: str) -> Row:
        """A derived size, its value rounded as a sheet does."""
        return cls(name=name, symbol=size.symbol, value=numbers.of_unit(size.value, size.unit, length_unit))


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table of numbers below the data: cells of each row, the first row its heading."""

    title: str
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Content:
    """A part as a sheet shows it: views in the order of the first angle projection."""

    title: str
    description: str
    length_unit: str
    views: tuple[View, ...]
    rows: tuple[Row, ...]
    tables: tuple[Table, ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class TitleBlock:
    """What the title block says besides what the part is; None: left empty.

    paper     "A3" or "A4", landscape
    name      of the part
    mass      with its unit
    sheet     which of how many
    """

    paper: str = "A3"
    name: str | None = None
    material: str | None = None
    mass: str | None = None
    date: str | None = None
    made_by: str = ""
    sheet: tuple[int, int] = (1, 1)

"""Kinds of lines on a sheet, their widths and dashes. Source: ISO 128-2, line group 0.5."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class LineKind:
    """A kind of line.

    name    of its layer in DXF
    width   on paper, mm
    dashes  lengths of dash, gap, dash, gap … on paper, mm; none for a continuous line
    """

    name: str
    width: float
    dashes: tuple[float, ...] = ()


_THIN = 0.25

VISIBLE = LineKind(name="visible", width=0.5)
"""01.2: edges and outlines that are seen, tips of teeth."""

THIN = LineKind(name="thin", width=_THIN)
"""01.1: dimension and extension lines, hatching, roots of teeth."""

HIDDEN = LineKind(name="hidden", width=_THIN, dashes=(12 * _THIN, 3 * _THIN))
"""02.1: edges that are not seen."""

CENTRE = LineKind(name="centre", width=_THIN, dashes=(24 * _THIN, 3 * _THIN, 0.5 * _THIN, 3 * _THIN))
"""04.1: axes, pitch circles and pitch lines."""

FRAME = LineKind(name="frame", width=0.7)
"""The frame of the sheet."""

LINE_KINDS = (VISIBLE, THIN, HIDDEN, CENTRE, FRAME)

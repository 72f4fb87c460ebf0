"""Sheets as SVG, in millimetres, one below another. Text stays text and takes the room it was given in any font."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from xml.sax.saxutils import escape, quoteattr

from ..arrays import Array
from ..sections.drawings.svg_writing import path_data
from . import lettering
from .line_kinds import THIN
from .marks import Dimension, Filled, Hatch, Mark, Sheet, Stroke, Text

_BETWEEN = 10.0  # mm, from sheet to sheet


def encoded(source: str, sheets: Sequence[Sheet], title: str) -> bytes:
    """The bytes of an SVG file."""
    del source
    width = max(sheet.size[0] for sheet in sheets)
    height = sum(sheet.size[1] for sheet in sheets) + _BETWEEN * (len(sheets) - 1)
    drawn, top = [], 0.0
    for sheet in sheets:
        body = "\n".join(element for mark in sheet.marks for element in _elements(mark))
        drawn.append(f'<g transform="translate(0 {_n(top + sheet.size[1])})">\n{body}\n</g>')
        top += sheet.size[1] + _BETWEEN
    head = (
        '<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg"'
        f' width="{_n(width)}mm" height="{_n(height)}mm" viewBox="0 0 {_n(width)} {_n(height)}"'
        f' fill="none" stroke="black" stroke-linecap="butt" font-family={quoteattr(_FONTS)}>\n'
        f"<title>{escape(title)}</title>\n"
        f'<rect width="{_n(width)}" height="{_n(height)}" fill="white" stroke="none"/>\n'
    )
    return (head + "\n".join(drawn) + "\n</svg>\n").encode()


_FONTS = f"{lettering.FONT}, Verdana, Arial, sans-serif"


def _elements(mark: Mark) -> Iterable[str]:
    match mark:
        case Stroke():
            yield _stroke(mark)
        case Text():
            yield from map(_text, mark.lines)
        case Filled():
            points = " ".join(map(_pair, mark.corners))
            yield f'<polygon points="{points}" fill="black" stroke="none"/>'
        case Hatch():
            parts = " ".join(f"M{_pair(a)}L{_pair(b)}" for a, b in mark.lines)
            yield f'<path stroke-width="{_n(THIN.width)}" d="{parts}"/>'
        case Dimension():
            for part in (*mark.marks, mark.text):
                yield from _elements(part)


def _stroke(stroke: Stroke) -> str:
    dashes = f' stroke-dasharray="{" ".join(map(_n, stroke.kind.dashes))}"' if stroke.kind.dashes else ""
    return f'<path stroke-width="{_n(stroke.kind.width)}"{dashes} d="{path_data(stroke.chain, closed=stroke.closed)}"/>'


def _text(text: Text) -> str:
    turned = f' transform="rotate({_n(-text.angle)} {_n(text.at[0])} {_n(-text.at[1])})"' if text.angle else ""
    return (
        f'<text x="{_n(text.at[0])}" y="{_n(-text.at[1])}" font-size="{_n(text.height / lettering.CAPITALS)}"'
        f' textLength="{_n(text.width)}" lengthAdjust="spacingAndGlyphs" fill="black" stroke="none"{turned}'
        f' xml:space="preserve">{escape(text.text)}</text>'
    )


def _pair(point: Array) -> str:
    return f"{_n(point[0])},{_n(-point[1])}"


def _n(value: float) -> str:
    """To a tenth of a micrometre on paper."""
    return f"{round(float(value), 4) + 0.0:.12g}"

"""SVG files of profiles: one path a profile, as large on paper as it is."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from xml.sax.saxutils import quoteattr

import numpy as np

from ...arrays import Array
from ...parameters import MILLIMETRES
from .contours import Contour
from .primitives import Free, Primitive, Round, Straight
from .strokes import Hand

HAND = Hand(degree=3, rational=False)

_MOST = 2.0 * math.pi / 3.0
"""Arcs are written in pieces of at most so many radians: between ends half a turn apart a centre is ill determined."""

_MARGIN = 0.02  # of the longer side, around everything
_LINE = 0.1  # mm, the width of the line on paper: what engravers and cutters take for a line without width

_PAGE = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
    width="{width}{unit}" height="{height}{unit}" viewBox="{x} {y} {width} {height}">
{layers}
</svg>
"""

_LAYER = """<g inkscape:groupmode="layer" inkscape:label={name} fill="none" stroke="black" stroke-width="{line}">
<path fill-rule="evenodd" d="{path}"/>
</g>"""


def encoded(source: str, layers: Mapping[str, Sequence[Contour]], corners: Array, length_unit: str) -> bytes:
    """The bytes of an SVG file of contours by layer; corners (2, 2) are the least and largest x and y of them all.

    User units are the length unit, x as it is, y turned round, since it points down in SVG.
    """
    del source
    margin = _MARGIN * float(np.max(np.ptp(corners, axis=0)))
    low, high = corners[0] - margin, corners[1] + margin
    shown = [
        _LAYER.format(
            name=quoteattr(layer),
            line=_number(_LINE / MILLIMETRES[length_unit]),
            path="\n".join(path_data(contour) for contour in drawn),
        )
        for layer, drawn in layers.items()
    ]
    width, height = (_number(side) for side in high - low)
    page = _PAGE.format(
        width=width, height=height, unit=length_unit, x=_number(low[0]), y=_number(-high[1]), layers="\n".join(shown)
    )
    return page.encode()


def path_data(contour: Contour) -> str:
    """Path data of a closed chain; a line at its end is left to Z."""
    commands = [command for one in contour for command in _commands(one)]
    if isinstance(contour[-1], Straight):
        commands.pop()
    return " ".join([f"M{_pair(contour[0].start)}", *commands, "Z"])


def _commands(one: Primitive) -> list[str]:
    match one:
        case Straight():
            return [f"L{_pair(one.end)}"]
        case Round():
            return _arcs(one)
        case Free():
            letter = "Q" if one.degree == 2 else "C"
            return [letter + " ".join(map(_pair, points[1:])) for points in one.control]


def _arcs(arc: Round) -> list[str]:
    """Counter-clockwise, which is SVG's sweep 0, since its y points down."""
    length = math.hypot(*arc.major)
    turned = -math.degrees(math.atan2(arc.major[1], arc.major[0]))
    form = f"A{_number(length)} {_number(length * arc.ratio)} {_number(turned)} 0 {int(arc.sweep < 0.0)} "
    pieces = arc.pieces(_MOST)
    return [form + _pair(end) for end in [*(piece.end for piece in pieces[:-1]), arc.end]]


def _pair(point: Array) -> str:
    return f"{_number(point[0])},{_number(-point[1])}"


def _number(value: float) -> str:
    """Fifteen digits: what is drawn at 0.1 is written so, and nothing moves by more than 1e-15 of where it is."""
    return f"{value + 0.0:.15g}"

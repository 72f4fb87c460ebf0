"""Sheets as PDF, a page each, by matplotlib: vectors and text with its letters embedded; the same bytes each time."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array
from ..sections.drawings.primitives import Free, Primitive, Round, Straight
from . import lettering
from .line_kinds import THIN, LineKind
from .marks import Dimension, Filled, Hatch, Mark, Sheet, Stroke, Text

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.transforms import Transform

_INCH, _POINT = 25.4, 25.4 / 72.0  # in millimetres
_PIECE = np.pi / 4.0  # an arc no longer than this is a cubic to 4e-6 of its radius


def encoded(source: str, sheets: Sequence[Sheet], title: str) -> bytes:
    """The bytes of a PDF file."""
    del source
    import matplotlib as mpl
    from matplotlib.backends.backend_pdf import FigureCanvasPdf, PdfPages
    from matplotlib.figure import Figure

    file = io.BytesIO()
    metadata = {"Title": title, "Creator": None, "Producer": None, "CreationDate": None}
    look: dict[Any, Any] = {"pdf.fonttype": 42, "font.family": lettering.FONT, "text.parse_math": False}
    with mpl.rc_context(look), PdfPages(file, metadata=metadata) as pages:
        for sheet in sheets:
            figure = Figure(figsize=(sheet.size[0] / _INCH, sheet.size[1] / _INCH))
            FigureCanvasPdf(figure)
            for mark in sheet.marks:
                _draw(figure, mark)
            pages.savefig(figure)
    return file.getvalue()


def _millimetres(figure: Figure) -> Transform:
    from matplotlib.transforms import Affine2D

    return Affine2D().scale(1.0 / _INCH) + figure.dpi_scale_trans


def _draw(figure: Figure, mark: Mark) -> None:
    match mark:
        case Stroke():
            vertices, codes = _path(mark.chain)
            _add_path(figure, vertices, codes, mark.kind)
        case Text():
            for text in mark.lines:
                _write(figure, text)
        case Filled():
            _fill(figure, mark.corners)
        case Hatch():
            count = len(mark.lines)
            _add_path(figure, mark.lines.reshape(-1, 2), [1, 2] * count, THIN)
        case Dimension():
            for part in (*mark.marks, mark.text):
                _draw(figure, part)


def _add_path(figure: Figure, vertices: Array, codes: Sequence[int], kind: LineKind) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    if len(vertices) == 0:
        return
    width = kind.width / _POINT
    # matplotlib counts dashes in widths of the line
    style: Any = (0.0, tuple(dash / kind.width for dash in kind.dashes)) if kind.dashes else "solid"
    patch = PathPatch(
        Path(vertices, codes),
        transform=_millimetres(figure),
        facecolor="none",
        edgecolor="black",
        linewidth=width,
        linestyle=style,
        capstyle="butt",
        joinstyle="round",
    )
    figure.add_artist(patch)


def _fill(figure: Figure, corners: Array) -> None:
    from matplotlib.patches import Polygon

    figure.add_artist(
        Polygon(corners, closed=True, transform=_millimetres(figure), facecolor="black", edgecolor="none")
    )


def _write(figure: Figure, text: Text) -> None:
    figure.text(
        float(text.at[0]),
        float(text.at[1]),
        text.text,
        transform=_millimetres(figure),
        fontsize=text.height / lettering.CAPITALS / _POINT,
        rotation=text.angle,
        rotation_mode="anchor",
        ha="left",
        va="baseline",
        parse_math=False,
    )


def _path(chain: Sequence[Primitive]) -> tuple[Array, list[int]]:
    """Vertices (n, 2) and matplotlib's codes: 1 to move, 2 for a line, 3 and 4 for points of curves."""
    points, codes = [chain[0].start], [1]
    for one in chain:
        match one:
            case Straight():
                points.append(one.end)
                codes.append(2)
            case Round():
                for piece in one.pieces(_PIECE):
                    points += list(_cubic(piece))
                    codes += [4, 4, 4]
            case Free():
                degree = one.degree
                for control in one.control:
                    points += list(control[1:])
                    codes += [degree + 1] * degree
    return np.array(points), codes


def _cubic(arc: Round) -> Array:
    """The three further control points (3, 2) of the cubic that an arc is to a few millionths of its size."""
    handle = 4.0 / 3.0 * np.tan(arc.sweep / 4.0)
    minor = arc.ratio * np.array([-arc.major[1], arc.major[0]])
    u = np.array([arc.first, arc.first + arc.sweep])
    ends = arc.centre + np.outer(np.cos(u), arc.major) + np.outer(np.sin(u), minor)
    tangents = np.outer(-np.sin(u), arc.major) + np.outer(np.cos(u), minor)
    return np.array([ends[0] + handle * tangents[0], ends[1] - handle * tangents[1], ends[1]])

"""What is written on a picture: title, callouts in free places, a triad of axes and a scale bar."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from ..arrays import Array

_INK = "#20262d"
_QUIET = "#66707b"
_HALO = "#ffffff"
_DPI = 100.0
_STEP = 8
"""Pixels between the places tried for a callout."""


@dataclass(frozen=True, kw_only=True)
class Callout:
    """A body's name: first line of the text, quieter further lines; mask (h, w) where the body is seen."""

    text: str
    colour: tuple[float, float, float]
    mask: NDArray[np.bool_]


@dataclass(frozen=True, kw_only=True)
class _Box:
    """A rectangle in pixels, y down."""

    left: float
    top: float
    right: float
    bottom: float


def annotated(
    colours: Array, title: str, callouts: Sequence[Callout], axes: Array, units_a_pixel: float, unit: str
) -> bytes:
    """A PNG file of colours (h, w, 3) with a title, callouts, axes (3, 3: each as drawn) and a scale."""
    height, width = colours.shape[:2]
    figure = Figure(figsize=(width / _DPI, height / _DPI), dpi=_DPI)
    FigureCanvasAgg(figure)
    figure.figimage(np.rint(colours * 255.0).astype(np.uint8), origin="upper")
    sheet = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    sheet.set_zorder(1)  # above the image
    sheet.set_axis_off()
    sheet.set_xlim(0.0, width)
    sheet.set_ylim(height, 0.0)
    scale = min(width / 1600.0, height / 1000.0)
    occupied = np.zeros((height, width), bool)
    for callout in callouts:
        occupied |= callout.mask
    margin = 36.0 * scale
    if title:
        _fill(occupied, _title(sheet, title, margin, scale))
    _fill(occupied, _triad(sheet, axes, margin, scale))
    _fill(occupied, _scale_bar(sheet, units_a_pixel, unit, margin, scale))
    for callout in callouts:
        _call_out(sheet, callout, occupied, scale)
    file = BytesIO()
    figure.savefig(file, dpi=_DPI, metadata={"Software": None}, format="png")
    return file.getvalue()


def _size_of(text: Text) -> tuple[float, float]:
    extent = text.get_window_extent()
    return float(extent.width), float(extent.height)


def _points(scale: float, pixels: float) -> float:
    """Font size of so many pixels in a picture 1600 wide; small pictures keep it legible."""
    return max(pixels * scale, 10.0) * 72.0 / _DPI


def _fill(occupied: NDArray[np.bool_], box: _Box) -> None:
    top, left = max(int(box.top), 0), max(int(box.left), 0)
    occupied[top : max(int(box.bottom), 0), left : max(int(box.right), 0)] = True


def _title(sheet: Axes, title: str, margin: float, scale: float) -> _Box:
    """The title at the upper left, made smaller where it is too long."""
    text = sheet.text(margin, margin, title, color=_INK, fontsize=_points(scale, 27.0), va="top", ha="left")
    room = sheet.get_xlim()[1] - 2.0 * margin
    width, _ = _size_of(text)
    if width > room:
        text.set_fontsize(_points(scale, 27.0) * room / width * 0.99)
    width, height = _size_of(text)
    return _Box(left=0.0, top=0.0, right=margin + width + margin, bottom=margin + height + margin / 2.0)


def _triad(sheet: Axes, axes: Array, margin: float, scale: float) -> _Box:
    """The three axes as they lie in the picture, lower left; one that points at the eye is a dot."""
    length = 46.0 * scale
    height = sheet.get_ylim()[0]
    x0, y0 = margin + length * 0.9, height - margin - length * 0.9
    for index in np.argsort(axes[:, 2]):
        right, up, towards = axes[index]
        x, y = x0 + length * right, y0 - length * up
        shade = _INK if towards > -0.3 else _QUIET
        sheet.plot([x0, x], [y0, y], color=shade, linewidth=1.6 * scale, solid_capstyle="round")
        flat = max(float(np.hypot(right, up)), 1e-9)
        beyond = 13.0 * scale
        dx, dy = (right / flat, up / flat) if flat > 0.2 else (0.7, 0.7)
        sheet.text(
            x + beyond * dx, y - beyond * dy, "xyz"[index],
            color=shade, fontsize=_points(scale, 17.0), ha="center", va="center_baseline", style="italic",
        )  # fmt: skip
    sheet.plot([x0], [y0], "o", color=_INK, markersize=3.4 * scale)
    reach = length + 26.0 * scale
    return _Box(left=x0 - reach, top=y0 - reach, right=x0 + reach, bottom=y0 + reach)


def _scale_bar(sheet: Axes, units_a_pixel: float, unit: str, margin: float, scale: float) -> _Box:
    """A bar of 1, 2 or 5 × 10ⁿ units, lower right."""
    width, height = sheet.get_xlim()[1], sheet.get_ylim()[0]
    longest = 0.15 * width * units_a_pixel
    power = 10.0 ** np.floor(np.log10(longest))
    value = power * max(step for step in (1.0, 2.0, 5.0) if step * power <= longest)
    right, y, tick = width - margin, height - margin, 5.0 * scale
    left = right - value / units_a_pixel
    sheet.plot(
        [left, left, left, right, right, right], [y - tick, y + tick, y, y, y - tick, y + tick],
        color=_INK, linewidth=1.4 * scale, solid_joinstyle="miter",
    )  # fmt: skip
    text = sheet.text(
        (left + right) / 2.0, y - 2.0 * tick, f"{value:g} {unit}",
        color=_INK, fontsize=_points(scale, 17.0), ha="center", va="bottom",
    )  # fmt: skip
    half, tall = _size_of(text)[0] / 2.0, _size_of(text)[1]
    middle = (left + right) / 2.0
    return _Box(left=min(left, middle - half) - margin / 2.0, top=y - 3.0 * tick - tall, right=width, bottom=height)


def _call_out(sheet: Axes, callout: Callout, occupied: NDArray[np.bool_], scale: float) -> None:
    """The callout in the free place nearest to its body, with a thin leader to a point well inside the body."""
    name, *further = callout.text.split("\n")
    name_text = sheet.text(0, 0, name, color=_INK, fontsize=_points(scale, 21.0), va="top", ha="left", weight="bold")
    lower_text = sheet.text(
        0, 0, "\n".join(further), color=_QUIET, fontsize=_points(scale, 16.0), va="top", ha="left", linespacing=1.3
    )
    (width, first), (width2, second) = _size_of(name_text), _size_of(lower_text) if further else (0.0, 0.0)
    gap = 6.0 * scale if further else 0.0
    wide, tall = max(width, width2), first + gap + second
    place = _place(callout.mask, occupied, wide, tall, 34.0 * scale)
    if place is None:  # nothing of the body is seen, or nowhere is room
        name_text.remove()
        lower_text.remove()
        return
    (left, top), (x, y) = place
    on_left = left + wide / 2.0 < x
    name_text.set_position((left, top))
    lower_text.set_position((left, top + first + gap))
    if on_left:
        name_text.set(ha="right", x=left + wide)
        lower_text.set(ha="right", x=left + wide)
    start = left + wide + 9.0 * scale if on_left else left - 9.0 * scale
    bar = top + first / 2.0
    sheet.plot([start, x], [bar, y], color=_HALO, linewidth=3.0 * scale, alpha=0.65, solid_capstyle="round")
    sheet.plot([start, x], [bar, y], color=_INK, linewidth=1.1 * scale)
    sheet.plot([x], [y], "o", color=_INK, markersize=6.0 * scale, markeredgecolor=_HALO, markeredgewidth=1.0 * scale)
    _fill(occupied, _Box(left=left - 12, top=top - 8, right=left + wide + 12, bottom=top + tall + 8))


def _place(
    mask: NDArray[np.bool_], occupied: NDArray[np.bool_], wide: float, tall: float, padding: float
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Upper left corner of a free box of this size, and the point of the body it is joined to; None where none is.

    Short leaders win; those that cross other things or run steeply lose.
    """
    depth = distance_transform_edt(mask[::4, ::4]) * 4.0
    deep = np.argwhere(depth >= min(0.5 * float(depth.max()), 5.0 * _STEP)) * 4
    boxes = _free_boxes(occupied, wide + 2.0 * padding, tall + 2.0 * padding)
    if not len(deep) or not len(boxes) or not mask.any():
        return None
    inside = deep[:: max(len(deep) // 300, 1)]
    best, found = np.inf, None
    lefts, tops = boxes[:, 1] + padding, boxes[:, 0] + padding
    for y, x in inside:
        starts = np.where(lefts + wide / 2.0 < x, lefts + wide, lefts)
        across, down = x - starts, y - (tops + tall / 2.0)
        # a leader of at least 40 pixels beside the box; steep ones cost half as much again
        lengths = np.hypot(across, 1.5 * down) + np.where(np.abs(across) < 40.0, 1e4, 0.0)
        order = int(np.argmin(lengths))
        cost = float(lengths[order]) + 3.0 * _foreign(mask, occupied, (starts[order], tops[order] + tall / 2.0), (x, y))
        if cost < best:
            best, found = cost, ((float(lefts[order]), float(tops[order])), (float(x), float(y)))
    return found


def _free_boxes(occupied: NDArray[np.bool_], wide: float, tall: float) -> NDArray[np.int64]:
    """Upper left corners (row, column) on a grid, of the boxes of this size that meet nothing occupied."""
    height, width = occupied.shape
    rows = np.arange(0, height - int(np.ceil(tall)), _STEP)
    columns = np.arange(0, width - int(np.ceil(wide)), _STEP)
    sums = np.zeros((height + 1, width + 1), np.int64)
    sums[1:, 1:] = np.cumsum(np.cumsum(occupied, axis=0, dtype=np.int64), axis=1)
    lower, right = rows + int(np.ceil(tall)), columns + int(np.ceil(wide))
    taken = sums[np.ix_(lower, right)] - sums[np.ix_(rows, right)] - sums[np.ix_(lower, columns)]
    taken = taken + sums[np.ix_(rows, columns)]
    free = np.argwhere(taken == 0)
    return np.stack([rows[free[:, 0]], columns[free[:, 1]]], axis=-1)


def _foreign(
    mask: NDArray[np.bool_], occupied: NDArray[np.bool_], start: tuple[float, float], end: tuple[float, float]
) -> float:
    """Pixels of the leader from start to end, (x, y) each, that lie on things other than its own body."""
    steps = np.linspace(0.0, 1.0, 64)
    x = np.clip(np.rint(start[0] + steps * (end[0] - start[0])).astype(int), 0, mask.shape[1] - 1)
    y = np.clip(np.rint(start[1] + steps * (end[1] - start[1])).astype(int), 0, mask.shape[0] - 1)
    share = float(np.mean(occupied[y, x] & ~mask[y, x]))
    return share * float(np.hypot(end[0] - start[0], end[1] - start[1]))

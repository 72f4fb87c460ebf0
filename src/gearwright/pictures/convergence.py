"""Errors over steps of refinement, log over log: knows numbers, not solids."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from .plot_file import GRID, QUIET, write_plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLOURS = ("#1f5fa8", "#b5642d", "#2e7d4f")  # one a quantity; told apart in grey and by the colour-blind too
_MARKERS = ("o", "s", "^")
_PANEL = (4.0, 4.6)  # inches
_SMALL = 10.5  # points


@dataclass(frozen=True, kw_only=True)
class Series:
    """Errors of one quantity.

    quantity   its number: colour and marker
    style      number of the study among those of the panel: the second and later ones are dashed and hollow
    order      measured order, None where there is none
    """

    label: str
    quantity: int
    style: int
    steps: Array
    errors: Array
    order: float | None


@dataclass(frozen=True, kw_only=True)
class Panel:
    """One diagram; descending: steps become finer as they become smaller, so that finer is to the right."""

    title: str
    label: str
    descending: bool
    series: tuple[Series, ...]


def convergence_plot(panels: Sequence[Panel], path: str | os.PathLike[str], title: str = "") -> None:
    """Draws panels side by side into a PNG or SVG file, finer to the right; the file appears complete or not at all.

    Raises FileError if the suffix is another or there is no folder, MachineError if the disk refuses, ValueError
    without panels.
    """
    if not panels:
        raise ValueError("a plot needs at least one study")
    write_plot(path, lambda: _drawn(panels, title))


def _drawn(panels: Sequence[Panel], title: str) -> Figure:
    """The drawing. matplotlib loads here, when something is really drawn."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_PANEL[0] * len(panels), _PANEL[1]), dpi=150.0, layout="constrained")
    row = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    if title:
        figure.suptitle(title, fontsize=14.0)
    for axes, panel in zip(row, panels, strict=True):
        _draw(axes, panel)
    row[0].set_ylabel("relative error")
    _leave_room(row[0], panels)
    for axes, panel in zip(row, panels, strict=True):
        if panel.series:
            _show_slopes(axes)
    return figure


def _draw(axes: Axes, panel: Panel) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(panel.title, fontsize=13.0)
    axes.set_xlabel(panel.label)
    axes.grid(which="major", color=GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    for spine in ("top", "right"):
        axes.spines[spine].set_visible(False)
    axes.tick_params(which="minor", length=2.0)
    for series in panel.series:
        order = "" if series.order is None else f", order {series.order:.2f}"
        axes.plot(
            series.steps,
            series.errors,
            color=_COLOURS[series.quantity],
            marker=_MARKERS[series.quantity],
            markerfacecolor="white" if series.style else None,
            linestyle="--" if series.style else "-",
            linewidth=1.5,
            markersize=5.5,
            label=series.label + order,
        )
    if not panel.descending:
        _count_ticks(axes, panel)
    else:
        axes.invert_xaxis()
        axes.xaxis.set_major_formatter(lambda length, _: f"{length:g}")
    if panel.series:
        axes.legend(loc="lower left", frameon=False, fontsize=_SMALL, borderaxespad=0.2, labelspacing=0.3)
    else:
        axes.text(0.5, 0.5, "exact to rounding", transform=axes.transAxes, ha="center", color=QUIET)


def _count_ticks(axes: Axes, panel: Panel) -> None:
    """Ticks at the counts themselves."""
    from matplotlib.ticker import NullLocator

    counts = sorted({step for series in panel.series for step in series.steps})
    if counts:
        axes.set_xticks(counts, [f"{count:g}" for count in counts])
    axes.xaxis.set_minor_locator(NullLocator())


def _leave_room(axes: Axes, panels: Sequence[Panel]) -> None:
    """Widens the common error axis downwards, so that the longest legend lies below all curves."""
    share = 0.057 * max(len(panel.series) for panel in panels)
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom * (bottom / top) ** (share / (1.0 - share)), top)


def _show_slopes(axes: Axes) -> None:
    """What falls with order 1 and with order 2, in the upper right corner, where errors that fall leave room."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    height = bottom * (top / bottom) ** 0.95
    width = abs(np.log(right / left))
    reach = min(0.055 * np.log(top / bottom), 0.4 * width)
    start, end = (left * (right / left) ** share for share in (0.8 - reach / width, 0.8))
    for order in (1, 2):
        low = height * np.exp(-order * reach)
        axes.plot([start, end], [height, low], color=QUIET, linewidth=1.0)
        axes.annotate(
            f"order {order}", (end, low), xytext=(4.0, 0.0), textcoords="offset points",
            color=QUIET, fontsize=_SMALL, va="center",
        )  # fmt: skip

"""Lines of contact on a developed flank, and the transmission error over two pitches: knows arrays, not gears."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Array
from .plot_file import GRID, INK, QUIET, write_plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SIZE = (13.6, 8.4)  # inches
_FILL, _EDGE, _TOUCH = "#e7eef7", "#1f5fa8", "#b5642d"
_RAMP = ("#0f3d73", "#2f7fc1", "#7fb8de")
"""A tooth's lines from its first touching to its last."""
_STYLES = (("#1f5fa8", "-"), ("#66707b", "--"), ("#b5642d", "-"))
_SMALL = 10.5  # points
_BEHIND = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
_MICRO = 1e6
_ARCSECONDS = float(np.degrees(3600.0))
_LEAST_RANGE = 0.5  # µrad: nothing smaller is worth enlarging
_NEVER = 1e-3  # µrad: below it there is only rounding


@dataclass(frozen=True, kw_only=True)
class Flank:
    """A flank developed: cone distance to the right, height above the pitch cone upwards.

    outline         (n, 2) of the flank from form to tip
    active          (2, 2) line below which it is not touched, if that is not its foot
    pitch           (2, 2) the pitch line
    lines           (n, 2) each, of contact, in the order in which the tooth passes through them
    turns           turn of the pinion at each, in pitches
    touched         (n, 2) where it is touched when the axes are askew
    touched_label   what that is called
    """

    outline: Array
    active: Array | None
    pitch: Array
    lines: Sequence[Array]
    turns: Sequence[float]
    touched: Array
    touched_label: str


@dataclass(frozen=True, kw_only=True)
class ErrorCurve:
    """Error (n,) of the driven gear over one pitch, about its mean, radians, the turns (n,) in pitches from 0 to 1."""

    label: str
    turns: Array
    error: Array

    @property
    def said(self) -> str:
        """The label with the range of the error."""
        ptp = float(np.ptp(self.error))
        size = "none" if _MICRO * ptp < _NEVER else f"{_MICRO * ptp:.3g} µrad = {_ARCSECONDS * ptp:.2g}″"
        return f"{self.label}: {size}"


@dataclass(frozen=True, kw_only=True)
class ContactDiagram:
    """All of it.

    micrometres       in the length unit
    radius            of the driven gear's pitch circle
    lengths, counts   (n,) of all lines of contact together, and of teeth that touch, at the turns (n,) in pitches
    notes             lines below the flank
    """

    title: str
    length_unit: str
    micrometres: float
    radius: float
    flank: Flank
    errors: Sequence[ErrorCurve]
    turns: Array
    lengths: Array
    counts: Array
    notes: Sequence[str]


def contact_diagram(diagram: ContactDiagram, path: str | os.PathLike[str]) -> None:
    """Draws it into a PNG or SVG file. Raises FileError, MachineError."""
    write_plot(path, lambda: _drawn(diagram))


def _drawn(diagram: ContactDiagram) -> Figure:
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE, dpi=150.0)
    figure.suptitle(diagram.title, fontsize=15.0, fontweight="bold", x=0.055, ha="left", y=0.975)
    _draw_flank(figure, figure.add_axes((0.055, 0.315, 0.425, 0.55)), diagram)
    figure.text(0.055, 0.17, "\n".join(diagram.notes), va="top", fontsize=_SMALL, linespacing=1.45)
    errors, lengths = figure.add_axes((0.565, 0.485, 0.36, 0.325)), figure.add_axes((0.565, 0.075, 0.36, 0.27))
    _draw_errors(errors, diagram)
    _draw_lengths(lengths, diagram)
    figure.align_ylabels([errors, lengths])
    return figure


def _draw_flank(figure: Figure, axes: Axes, diagram: ContactDiagram) -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    flank = diagram.flank
    ramp = LinearSegmentedColormap.from_list("turn", _RAMP)
    scale = Normalize(min(flank.turns), max(flank.turns))
    axes.set_aspect("equal", adjustable="datalim")
    axes.fill(*flank.outline.T, facecolor=_FILL, edgecolor=_EDGE, linewidth=1.6, zorder=1)
    axes.plot(*flank.pitch.T, color=QUIET, linewidth=0.9, dashes=(9, 2, 2, 2), zorder=2, label="pitch line")
    if flank.active is not None:
        axes.plot(*flank.active.T, color=QUIET, linewidth=1.1, linestyle=":", zorder=2, label="end of active flank")
    for line, turn in zip(flank.lines, flank.turns, strict=True):
        axes.plot(*line.T, color=ramp(scale(turn)), linewidth=1.7, zorder=3)
    axes.plot(*flank.touched.T, "o", markersize=3.6, color=_TOUCH, zorder=4, label=flank.touched_label)
    axes.set_title("lines of contact on the pinion's driving flank", loc="left", fontsize=12.0, pad=34.0)
    axes.legend(
        loc="lower left", bbox_to_anchor=(-0.015, 1.0), ncols=3, frameon=False, fontsize=_SMALL, columnspacing=1.3,
        borderaxespad=0.2, handletextpad=0.5,
    )  # fmt: skip
    bar = figure.add_axes((0.055, 0.228, 0.425, 0.012))
    figure.colorbar(ScalarMappable(norm=scale, cmap=ramp), cax=bar, orientation="horizontal")
    bar.set_xlabel("turn of the pinion, pitches; 0: the tooth is on the pitch line", fontsize=_SMALL, labelpad=2.0)
    bar.tick_params(labelsize=_SMALL)
    axes.set_xlabel(f"cone distance, {diagram.length_unit}", fontsize=11.0)
    axes.set_ylabel(f"height above the pitch cone, {diagram.length_unit}", fontsize=11.0)
    axes.margins(0.04)
    _plain(axes)


def _draw_errors(axes: Axes, diagram: ContactDiagram) -> None:
    """The curves over two pitches, of which the second repeats the first: the step from tooth to tooth is inside."""
    most = _LEAST_RANGE
    for curve, (colour, style) in zip(diagram.errors, _STYLES, strict=False):
        values = _MICRO * curve.error
        values = np.where(np.abs(values) < _NEVER, 0.0, values)
        axes.plot(*_twice(curve.turns, values), color=colour, linestyle=style, linewidth=1.9, label=curve.said)
        most = max(most, float(np.abs(values).max()))
    axes.set_ylim(-1.15 * most, 1.15 * most)
    axes.set_ylabel("error of the gear, µrad", fontsize=11.0)
    micrometres = diagram.radius * diagram.micrometres

    def to_micrometres(values: Any) -> Any:
        return values * micrometres / _MICRO

    def to_microradians(values: Any) -> Any:
        return values * _MICRO / micrometres

    length = axes.secondary_yaxis("right", functions=(to_micrometres, to_microradians))
    length.set_ylabel("at its pitch circle, µm", fontsize=11.0)
    length.tick_params(labelsize=_SMALL)
    length.spines["right"].set_color(QUIET)
    axes.set_title("transmission error, peak to peak", loc="left", fontsize=12.0, pad=67.0)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.015, 1.0), frameon=False, fontsize=_SMALL, borderaxespad=0.2)
    _over_turns(axes)


def _draw_lengths(axes: Axes, diagram: ContactDiagram) -> None:
    turns, twice = _twice(diagram.turns, diagram.lengths)
    axes.fill_between(turns, twice, color=_FILL, linewidth=0.0)
    axes.plot(turns, twice, color=_EDGE, linewidth=1.9)
    axes.set_ylim(0.0, 1.25 * float(diagram.lengths.max()))
    axes.set_ylabel(f"length, {diagram.length_unit}", fontsize=11.0)
    axes.set_title("all lines of contact together", loc="left", fontsize=12.0, pad=8.0)
    axes.set_xlabel("turn of the pinion, pitches", fontsize=11.0)
    _name_counts(axes, diagram)
    _over_turns(axes)


def _name_counts(axes: Axes, diagram: ContactDiagram) -> None:
    """How many teeth touch, above each stretch of the first pitch where that number stays the same."""
    changes = np.flatnonzero(np.diff(diagram.counts)) + 1
    bounds = [0, *changes, len(diagram.counts)]
    for start, stop in pairwise(bounds):
        if stop - start < 0.08 * len(diagram.counts):
            continue
        middle = (diagram.turns[start] + diagram.turns[stop - 1]) / 2.0
        height = float(diagram.lengths[start:stop].max()) + 0.04 * float(diagram.lengths.max())
        count = int(diagram.counts[start])
        said = f"{count} tooth" if count == 1 else f"{count} teeth"
        axes.text(middle, height, said, ha="center", va="bottom", fontsize=_SMALL, color=INK, bbox=_BEHIND)


def _twice(turns: Array, values: Array) -> tuple[Array, Array]:
    """Values over one pitch as values over two, and a little more at either end."""
    places = np.concatenate([turns[-1:] - 1.0, turns, turns + 1.0, turns[:1] + 2.0])
    return places, np.concatenate([values[-1:], values, values, values[:1]])


def _over_turns(axes: Axes) -> None:
    axes.set_xlim(0.0, 2.0)
    axes.axvline(1.0, color=QUIET, linewidth=0.8, linestyle=":")
    _plain(axes)


def _plain(axes: Axes) -> None:
    axes.tick_params(labelsize=_SMALL)
    axes.grid(color=GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    for spine in ("top", "right"):
        axes.spines[spine].set_visible(False)

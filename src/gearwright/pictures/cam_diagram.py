"""A cam's disk with its follower, and the follower's motion over one turn: knows arrays, not cams."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from .plot_file import GRID, INK, QUIET, write_plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SIZE = (13.6, 8.4)  # inches
_CAM, _FOLLOWER, _OTHER = "#1f5fa8", "#b5642d", "#8a929b"
_FILL, _MOVE = "#e7eef7", "#f6efe6"
_SMALL = 10.5  # points
_NARROW = 24.0  # degrees of a span above which there is no room for more than its angle
_ROOM = 0.12  # of a diagram's height, above and below its curve


@dataclass(frozen=True, kw_only=True)
class Disk:
    """What is drawn of the disk and the follower, in the cam's frame.

    outline   (n, 2) the profile, closed
    other     (m, 2) the one it is compared with, if any
    pitch     (m, 2) the pitch curve of a roller, if any
    circles   radii about the axis by what they are called
    bore      radius, 0 for none
    face      (k, 2) ends of a flat face, or nothing; used (k, 2) the part of it that is touched
    rollers   centres and radii
    links     (2, 2) lines of the stem or arm
    pivot     where a swinging follower turns, if anywhere
    contact   (2,) where it touches at the moment drawn, and normal (2,) there
    """

    outline: Array
    circles: Mapping[str, float]
    contact: Array
    normal: Array
    other: Array | None = None
    pitch: Array | None = None
    bore: float = 0.0
    face: Array | None = None
    used: Array | None = None
    rollers: Sequence[tuple[Array, float]] = ()
    links: Sequence[Array] = ()
    pivot: Array | None = None


@dataclass(frozen=True, kw_only=True)
class Curve:
    """A quantity over the cam angle. other   the same of what it is compared with; limit   a line it keeps below"""

    label: str
    values: Array
    other: Array | None = None
    limit: float | None = None


@dataclass(frozen=True, kw_only=True)
class Diagram:
    """All of it: angle (n,) in degrees, spans of the programme (start, end, what), notes below the disk."""

    title: str
    length_unit: str
    disk: Disk
    angle: Array
    curves: Sequence[Curve]
    spans: Sequence[tuple[float, float, str]]
    moment: float
    other: str = ""
    notes: Sequence[str] = field(default_factory=tuple)


def cam_diagram(diagram: Diagram, path: str | os.PathLike[str]) -> None:
    """Draws it into a PNG or SVG file. Raises FileError, MachineError."""
    write_plot(path, lambda: _drawn(diagram))


def _drawn(diagram: Diagram) -> Figure:
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE, dpi=150.0)
    figure.suptitle(diagram.title, fontsize=15.0, fontweight="bold", x=0.055, ha="left", y=0.975)
    disk = figure.add_axes((0.055, 0.215, 0.455, 0.655))
    _draw_disk(disk, diagram)
    figure.text(0.055, 0.13, "\n".join(diagram.notes), va="top", fontsize=_SMALL, linespacing=1.4)
    grid = figure.add_gridspec(len(diagram.curves), 1, left=0.6, right=0.985, top=0.885, bottom=0.075, hspace=0.16)
    axes = [figure.add_subplot(grid[i]) for i in range(len(diagram.curves))]
    for one, curve in zip(axes, diagram.curves, strict=True):
        _draw_curve(one, curve, diagram)
    for one in axes[:-1]:
        one.tick_params(labelbottom=False)
    _name_spans(axes[0], diagram)
    axes[-1].set_xlabel("cam angle ψ, degrees")
    figure.align_ylabels(axes)
    return figure


def _draw_disk(axes: Axes, diagram: Diagram) -> None:
    from matplotlib.patches import Circle

    disk = diagram.disk
    axes.set_aspect("equal", adjustable="datalim")
    axes.fill(*disk.outline.T, facecolor=_FILL, edgecolor=_CAM, linewidth=2.0, label="profile", zorder=2)
    if disk.bore:
        axes.add_patch(Circle((0.0, 0.0), disk.bore, facecolor="white", edgecolor=_CAM, linewidth=1.5, zorder=3))
    if disk.pitch is not None:
        axes.plot(*disk.pitch.T, color=_FOLLOWER, linewidth=0.9, dashes=(9, 2, 2, 2), label="pitch curve", zorder=2)
    turn = np.linspace(0.0, 2.0 * np.pi, 361)
    for name, radius in disk.circles.items():
        circle = radius * np.stack([np.cos(turn), np.sin(turn)])
        axes.plot(*circle, color=QUIET, linewidth=1.1, linestyle=":", label=name, zorder=3)
    if disk.other is not None:
        axes.plot(*disk.other.T, color=_OTHER, linewidth=1.3, dashes=(5.0, 2.5), label=diagram.other, zorder=2.5)
    reach = float(np.abs(disk.outline).max())
    for x, y in ((0.07, 0.0), (0.0, 0.07)):
        axes.plot([-x * reach, x * reach], [-y * reach, y * reach], color=INK, linewidth=1.0, zorder=4)
    _draw_follower(axes, disk, reach)
    _draw_contact(axes, disk, reach, diagram.moment)
    axes.grid(color=GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    for spine in ("top", "right"):
        axes.spines[spine].set_visible(False)
    axes.set_xlabel(f"x, {diagram.length_unit}")
    axes.set_ylabel(f"y, {diagram.length_unit}", labelpad=2.0)
    axes.margins(0.05)
    axes.legend(
        loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncols=3, frameon=False, fontsize=_SMALL, columnspacing=1.4,
        borderaxespad=0.2,
    )  # fmt: skip


def _draw_follower(axes: Axes, disk: Disk, reach: float) -> None:
    """Face or roller, stem or arm with its pivot."""
    from matplotlib.patches import Circle

    for link in disk.links:
        axes.plot(*link.T, color=_FOLLOWER, linewidth=5.0, alpha=0.45, solid_capstyle="round", zorder=4.5)
    if disk.face is not None and disk.used is not None:
        axes.plot(*disk.face.T, color=_FOLLOWER, linewidth=2.6, solid_capstyle="butt", zorder=5)
        axes.plot(*disk.used.T, color=_FOLLOWER, linewidth=6.5, alpha=0.4, solid_capstyle="butt", zorder=4.8)
    for (x, y), radius in disk.rollers:
        axes.add_patch(Circle((x, y), radius, facecolor="#fbf3ea", edgecolor=_FOLLOWER, linewidth=2.2, zorder=5))
        axes.plot(x, y, marker="o", markersize=4.0, color=_FOLLOWER, zorder=6)
    if disk.pivot is not None:
        x, y = disk.pivot
        axes.plot(x, y, "o", markersize=9.0, color="white", markeredgecolor=_FOLLOWER, markeredgewidth=2.2, zorder=6)
        plain = {"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.8}
        axes.text(x + 0.05 * reach, y, "pivot", fontsize=_SMALL, color=_FOLLOWER, va="center", zorder=5.2, bbox=plain)


def _draw_contact(axes: Axes, disk: Disk, reach: float, moment: float) -> None:
    """Where they touch, and the common normal."""
    ends = np.array([disk.contact - 0.42 * reach * disk.normal, disk.contact + 0.22 * reach * disk.normal])
    axes.plot(*ends.T, color=INK, linewidth=0.9, linestyle="--", zorder=5.5)
    label = f"contact at ψ = {moment:.4g}°"
    axes.plot(*disk.contact, "o", markersize=6.5, color=INK, zorder=7, label=label)


def _draw_curve(axes: Axes, curve: Curve, diagram: Diagram) -> None:
    for start, end, what in diagram.spans:
        if what != "dwell":
            axes.axvspan(start, end, color=_MOVE, linewidth=0.0, zorder=0)
    axes.axhline(0.0, color=QUIET, linewidth=0.8, zorder=1)
    if curve.limit is not None:
        axes.axhline(curve.limit, color=_FOLLOWER, linewidth=1.0, linestyle="--", zorder=1.5)
        axes.text(359.0, curve.limit, "limit ", color=_FOLLOWER, fontsize=_SMALL, ha="right", va="bottom")
    if curve.other is not None:
        axes.plot(diagram.angle, curve.other, color=_OTHER, linewidth=1.2, dashes=(5.0, 2.5), zorder=2)
    axes.plot(diagram.angle, curve.values, color=_CAM, linewidth=1.8, zorder=3)
    axes.axvline(diagram.moment, color=INK, linewidth=0.8, linestyle=":", zorder=2)
    axes.set_ylabel(curve.label, fontsize=11.0)
    axes.set_xlim(0.0, 360.0)
    axes.set_xticks(np.arange(0, 361, 45))
    axes.tick_params(labelsize=_SMALL)
    axes.grid(color=GRID, linewidth=0.6)
    low, high = axes.get_ylim() if np.ptp(curve.values) or np.any(curve.values) else (-1.0, 1.0)
    axes.set_ylim(low - _ROOM * (high - low) / 2.0, high + _ROOM * (high - low) / 2.0)
    for spine in ("top", "right"):
        axes.spines[spine].set_visible(False)


def _name_spans(axes: Axes, diagram: Diagram) -> None:
    """What the follower does, above the uppermost diagram."""
    place = axes.get_xaxis_transform()
    for start, end, what in diagram.spans:
        said = f"{what}\n{end - start:.4g}°" if end - start >= _NARROW else f"{end - start:.3g}°"
        middle = (start + end) / 2.0
        axes.text(middle, 1.04, said, transform=place, ha="center", va="bottom", fontsize=_SMALL, color=QUIET)

"""Views of a cam, and the table of its follower's lift."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...sheets.content import Row, Table
from ...sheets.line_kinds import CENTRE
from ...sheets.marks import circle
from ...sheets.numbers import decimal, length
from ...sheets.views import Span, View
from ..data_rows import all_rows
from ..drafting import axis, drawn, outlines, points_on
from ..prismatic_views import cut_at_axis

if TYPE_CHECKING:
    from .cam import Cam

_STEP = 10  # degrees of the cam angle from row to row
_COLUMNS = 3  # pairs of angle and lift beside each other


def cam_views(cam: Cam) -> tuple[View, ...]:
    """The disk seen from +z, the follower starting on the right, and the section through its axis."""
    chains = outlines(cam.profile)
    base = cam.traced.follower.base_radius
    points = points_on(chains[0])
    (left, low), (right, high) = points.min(axis=0), points.max(axis=0)
    front = View(
        title="Seen from +z; the follower starts on the right",
        strokes=(
            *drawn(chains),
            circle(base, CENTRE),
            axis(left, right),
            axis(low, high, vertical=True),
        ),
        dimensions=(
            Span(start=(left, 0.0), end=(right, 0.0), side="below"),
            Span(start=(0.0, low), end=(0.0, high), side="left"),
            Span(start=(-base, 0.0), end=(base, 0.0), side="above", prefix="Ø"),
        ),
    )
    return front, cut_at_axis(chains, cam.thickness, bore=cam.bore)


def cam_rows(cam: Cam) -> tuple[Row, ...]:
    """What the follower is, and all sizes."""
    movement = (
        f"{decimal(cam.amount, 4)}°" if cam.kind.swings else f"{length(cam.amount, cam.length_unit)} {cam.length_unit}"
    )
    law = (cam.optimum.law if cam.optimum else None) or cam.law or "cycloidal"
    return (
        Row(name="Follower", symbol="", value=cam.follower.replace("-", " ")),
        Row(name="Swing" if cam.kind.swings else "Lift", symbol="s", value=movement),
        Row(name="Motion law", symbol="", value=law),
        *all_rows({name: size for name, size in cam.sizes().items() if name != "polygon_area"}, cam.length_unit),
        Row(name="Thickness", symbol="", value=f"{length(cam.thickness, cam.length_unit)} {cam.length_unit}"),
    )


def lift_table(cam: Cam) -> Table:
    """The follower's position by the cam angle, every ten degrees."""
    angles = np.arange(0, 360, _STEP)
    lifts = cam.displacement.derivatives(np.radians(angles))[0]
    if cam.kind.swings:
        lifts = np.degrees(lifts)
    decimals = 4 if cam.kind.swings or cam.length_unit == "in" else 3
    per_column = -(-len(angles) // _COLUMNS)
    unit = "°" if cam.kind.swings else cam.length_unit
    rows = [["ψ in °", f"s in {unit}"] * _COLUMNS]
    for k in range(per_column):
        cells: list[str] = []
        for j in range(k, len(angles), per_column):
            cells += [f"{angles[j]}", f"{lifts[j] + 0.0:.{decimals}f}"]
        rows.append(cells)
    return Table(title=f"Follower: {cam.programme}"[:60], rows=rows)

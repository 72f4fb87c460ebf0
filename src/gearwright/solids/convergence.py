"""How the errors of an approximation fall as it is refined: rows, orders, table and plot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..arrays import Array
from ..pictures.convergence import Panel, Series, convergence_plot

Refined = Literal["tolerance", "segments", "layers"]
QUANTITIES = ("volume", "centroid", "inertia")

_TITLES: dict[Refined, str] = {
    "tolerance": "whole polyhedron",
    "segments": "section alone",
    "layers": "layers alone",
}
_LABELS = {"volume": "volume", "centroid": "centroid / diagonal", "inertia": "inertia"}
_FALLING = 0.25  # an order up to that: nothing is gained by refining
_STRAY = 1.5  # from a power of the step, as a factor: more is not an order


@dataclass(frozen=True, kw_only=True)
class ErrorRow:
    """Errors of one approximation.

    step       chord tolerance (length), segments a section curve, or layers
    triangles  of the polyhedron; None where the approximation is none
    volume     relative, negative where volume is missing
    centroid   distance between the centroids / bounding diagonal
    inertia    Frobenius norm of the difference of the central inertia tensors / that of the tensor
    """

    step: float
    triangles: int | None
    volume: float
    centroid: float
    inertia: float


@dataclass(frozen=True, kw_only=True)
class ApproximationError:
    """Errors against exact moments as an approximation is refined.

    refined    what is varied: the chord tolerance, the segments of every section curve, or the layers
    against    what the errors are measured from, in words
    rows       from the coarsest to the finest
    rounding   errors up to this say nothing: rounding, and the error bounds of both sides
    diagonals  how quads are cut: "alternating" or "fixed"; empty where none are
    """

    refined: Refined
    against: str
    rows: tuple[ErrorRow, ...]
    rounding: float
    diagonals: str = ""

    @property
    def orders(self) -> dict[str, float | None]:
        """Measured order of each quantity: the slope of log error over log step, least squares.

        For counts it is over the inverse of the count. None where there is none to measure; `remarks` say why.
        """
        return {name: self._order(name) for name in QUANTITIES}

    @property
    def remarks(self) -> tuple[str, ...]:
        """Where an order is missing, or the errors do not fall, and what that means."""
        return tuple(f"{name}: {remark}" for name in QUANTITIES if (remark := self._remark(name)))

    def to_dict(self) -> dict[str, Any]:
        """Everything by name as plain numbers, for JSON."""
        return {
            "refined": self.refined,
            "against": self.against,
            "diagonals": self.diagonals or None,
            "rows": [asdict(row) for row in self.rows],
            "orders": self.orders,
            "rounding": self.rounding,
            "remarks": list(self.remarks),
        }

    def __str__(self) -> str:
        cells = self.table()
        widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
        lines = ["  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)) for row in cells]
        return "\n".join([f"Errors against {self.against}", *lines, *self.remarks])

    def table(self) -> list[list[str]]:
        """Cells of the table: a row of headings, the rows, and the orders."""
        counted = any(row.triangles is not None for row in self.rows)
        cells = [[self.refined, *(["triangles"] if counted else []), *QUANTITIES]]
        for row in self.rows:
            count = [str(row.triangles)] if counted else []
            cells.append([f"{row.step:.4g}", *count, *(self._cell(name, getattr(row, name)) for name in QUANTITIES)])
        orders = ["–" if order is None else f"{order:.2f}" for order in self.orders.values()]
        return [*cells, ["order", *([""] if counted else []), *orders]]

    def _cell(self, name: str, error: float) -> str:
        if abs(error) <= self.rounding:
            return "rounding"
        return f"{error:+.2e}" if name == "volume" else f"{error:.2e}"

    def plot(self, path: str | Path, length_unit: str = "mm") -> None:
        """Draws the errors, log over log, into a PNG or SVG file. Raises FileError, MachineError."""
        plot_convergence([self], path, length_unit=length_unit)

    def measured(self, name: str) -> tuple[Array, Array]:
        """Steps and errors (n,) of a quantity, from the coarsest on, as long as they are more than rounding."""
        steps, errors = np.array([(row.step, getattr(row, name)) for row in self.rows]).T
        lost = np.flatnonzero(np.abs(errors) <= self.rounding)
        count = lost[0] if len(lost) else len(errors)
        return steps[:count], errors[:count]

    def _order(self, name: str) -> float | None:
        return None if self._without_order(name) else self._slope(name)[0]

    def _slope(self, name: str) -> tuple[float, float]:
        """Slope of the straight line through the logarithms, and by which factor the errors stray from it at most."""
        steps, errors = self.measured(name)
        finer = np.log(steps if self.refined == "tolerance" else 1.0 / steps)
        heights = np.log(np.abs(errors))
        line = np.polyfit(finer, heights, 1)
        return float(line[0]), float(np.exp(np.max(np.abs(heights - np.polyval(line, finer)))))

    def _without_order(self, name: str) -> str:
        """Why there is no order to measure; empty where there is one."""
        _, errors = self.measured(name)
        if all(abs(getattr(row, name)) <= self.rounding for row in self.rows):
            return "exact to rounding, so that it has no order"
        if len(errors) < 2:
            return "no order, since the error is no more than rounding at some steps, but more at others"
        if len(np.unique(np.sign(errors))) > 1:
            return "no order, since the error changes its sign"
        if self._slope(name)[1] > _STRAY:
            return f"no order, since the error does not follow a power of the step within a factor of {_STRAY:g}"
        return ""

    def _remark(self, name: str) -> str:
        reason = self._without_order(name)
        if reason or (order := self._slope(name)[0]) > _FALLING:
            return reason
        return f"the error does not fall: its order is {order:.2f}, measured from what it does not tend to"


def plot_convergence(
    studies: Sequence[ApproximationError],
    path: str | Path,
    title: str = "",
    length_unit: str = "mm",
    names: Sequence[str] = (),
) -> None:
    """Draws studies, log over log, into a PNG or SVG file, one panel for each quantity that they refine.

    names   what tells studies in one panel apart, one for each study; their diagonals if not given

    Raises FileError for another suffix or no folder, MachineError if the disk refuses, ValueError without studies,
    or for more or fewer names.
    """
    if names and len(names) != len(studies):
        raise ValueError(f"{len(names)} names for {len(studies)} studies: one for each is needed")
    known = names or [study.diagonals for study in studies]
    kinds: dict[Refined, list[tuple[str, ApproximationError]]] = {}
    for name, study in zip(known, studies, strict=True):
        kinds.setdefault(study.refined, []).append((name, study))
    panels = [_panel(kind, group, length_unit) for kind, group in kinds.items()]
    convergence_plot(panels, path, title)


def _panel(kind: Refined, studies: Sequence[tuple[str, ApproximationError]], length_unit: str) -> Panel:
    labels = {
        "tolerance": f"chord tolerance ({length_unit})",
        "segments": "segments a section curve",
        "layers": "layers",
    }
    several = len(studies) > 1
    series = [
        Series(
            label=f"{_LABELS[name]}, {which}" if several else _LABELS[name],
            quantity=QUANTITIES.index(name),
            style=number,
            steps=steps,
            errors=np.abs(errors),
            order=order,
        )
        for number, (which, study) in enumerate(studies)
        for name, order in study.orders.items()
        for steps, errors in [study.measured(name)]
        if len(steps)
    ]
    return Panel(title=_TITLES[kind], label=labels[kind], descending=kind == "tolerance", series=tuple(series))

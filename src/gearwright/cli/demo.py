"""`gearwright demo`: a bevel pair, straight and spiral; its exact properties beside those of its polyhedra."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from cyclopts import Parameter as Option
from rich.table import Table

from .. import catalog
from ..designs.built import Built, Part, built_from
from ..elements.assembly import draw_parts, save_parts
from ..parameters import from_mapping
from ..solids.properties import MassProperties
from .exits import DONE
from .outputs import progress
from .tables import number, plain_table, show

PAIR: Mapping[str, Any] = {
    "teeth": (16, 20),
    "diametral_pitch": 2.0,
    "face_width": 1.5,
    "working_depth": 0.8,
    "whole_depth": 0.85,
    "gear_addendum": 0.4,
    "pressure_angle": 20.0,
    "length_unit": "in",
}
"""The sizes of Al-Daccak 1989, Table 3.1; roots and ends as they are by default, which the thesis has otherwise."""

TRACES: Mapping[str, Mapping[str, Any]] = {
    "straight": {"trace": "straight"},
    "spiral": {"trace": "logarithmic", "spiral_angle": 35.0},
}

TOLERANCES = (2e-3, 5e-4, 1.25e-4)
"""Chord tolerances in the pair's length unit. A quarter of the tolerance is half the step."""

QUANTITIES: Mapping[str, Callable[[MassProperties], float]] = {
    "V in³": lambda found: float(found.volume),
    "z̄ in": lambda found: float(found.centroid[2]),
    "Izz in⁵": lambda found: float(found.inertia[2, 2]),
    "Ixx in⁵": lambda found: float(found.inertia[0, 0]),
}
"""What is compared: z is the gear's axis, the origin its apex, the density 1."""


NOTE = """V volume; z̄ centroid on the axis; Izz, Ixx inertia about and across it, at the apex; density 1.
order: of the errors in the tolerance; in step: in the step length, the root of the tolerance."""


def demo(
    *,
    output: Annotated[Path, Option(name=["--output", "-o"], metavar="FOLDER", help="Where files are written.")] = Path(
        "out/demo"
    ),
) -> int:
    """Build the pair 16/20, straight and spiral; write STL and PNG files; compare exact with polyhedral properties."""
    kind = next(one for one in catalog.ELEMENTS if one.name == "bevel pair")
    rows: dict[str, list[_Row]] = {"pinion": [], "gear": []}
    for trace, parameters in TRACES.items():
        built = built_from(kind, from_mapping(catalog.load(kind.source), {**PAIR, **parameters}), None)
        _write(built, output / trace)
        for name, part in built.parts.items():
            rows[name] += _compare(trace, part)
    show(_table(rows), NOTE)
    print(f"wrote {output}/{{{','.join(TRACES)}}}/{{pinion.stl,gear.stl,pair.png}}", file=sys.stderr)
    return DONE


def _write(built: Built, folder: Path) -> None:
    with progress(f"{built.title}: files"):
        parts = built.placed()
        save_parts(parts, folder, built.units.length)
        draw_parts(parts, folder / "pair.png", built.title, built.units.length)


@dataclass(frozen=True, kw_only=True)
class _Row:
    """One quantity of one part: its exact value and the values of its polyhedra."""

    quantity: str
    trace: str
    exact: float
    found: Sequence[float]

    @property
    def errors(self) -> list[float]:
        """Relative errors of the polyhedra."""
        return [(value - self.exact) / self.exact for value in self.found]

    @property
    def order(self) -> float:
        """Slope of log error over log tolerance."""
        return float(np.polyfit(np.log(TOLERANCES), np.log(np.abs(self.errors)), 1)[0])


def _compare(trace: str, part: Part) -> list[_Row]:
    polyhedra = []
    for tolerance in TOLERANCES:
        with progress(f"{trace}: polyhedron to {tolerance:g} in"):
            polyhedra.append(part.gear.polyhedron(tolerance).properties())
    return [
        _Row(
            quantity=quantity,
            trace=trace,
            exact=value(part.properties),
            found=[value(polyhedron) for polyhedron in polyhedra],
        )
        for quantity, value in QUANTITIES.items()
    ]


def _table(rows: Mapping[str, Sequence[_Row]]) -> Table:
    table = plain_table("Exact properties, and the relative errors of polyhedra to a tolerance in inches")
    for heading in ("part", "", "trace"):
        table.add_column(heading, no_wrap=True)
    for heading in ("exact", *(f"{tolerance:g}" for tolerance in TOLERANCES), "order", "in step"):
        table.add_column(heading, justify="right", no_wrap=True)
    for part, found in rows.items():
        for quantity in QUANTITIES:
            for row in (row for row in found if row.quantity == quantity):
                table.add_row(part, quantity, row.trace, number(row.exact, digits=12), *_errors(row))
        table.add_section()
    return table


def _errors(row: _Row) -> list[str]:
    return [*(f"{error:+.1e}" for error in row.errors), f"{row.order:.2f}", f"{2.0 * row.order:.2f}"]

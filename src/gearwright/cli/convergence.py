"""`--convergence`: how far the polyhedra of a part are from its exact properties, and how fast they approach."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from rich.console import RenderableType

from ..designs.built import Built, Part
from ..disk import folder
from ..solids.approximation import approximation_error, layer_refinement, section_refinement
from ..solids.convergence import plot_convergence
from .outputs import progress
from .tables import plain_table, show

_NOTE = """Volume: relative. Centroid: over the bounding diagonal. Inertia: about the centroid, norm of the
difference over the norm. Order: slope of log error over log tolerance, or over log 1/number."""


def with_convergence(built: Built) -> Built:
    """The same with the errors of every part's polyhedra."""
    return replace(built, parts={name: _measured(name, part) for name, part in built.parts.items()})


def _measured(name: str, part: Part) -> Part:
    studies = []
    for study in (approximation_error, section_refinement, layer_refinement):
        with progress(f"errors of polyhedra of the {name}"):
            studies.append(study(part.gear))
    return replace(part, convergence={one.refined: one for one in studies})


def show_convergence(built: Built) -> None:
    """Tables of the errors of all parts."""
    tables: list[RenderableType] = []
    for name, part in built.parts.items():
        for refined, study in part.convergence.items():
            unit = f" in {built.units.length}" if refined == "tolerance" else ""
            table = plain_table(f"{name}: errors by {refined}{unit}")
            headings, *rows, orders = study.table()
            for heading in headings:
                table.add_column(heading, justify="right")
            for row in rows:
                table.add_row(*row)
            table.add_section()
            table.add_row(*orders)
            tables += [table, "\n".join([f"Against {study.against}.", *study.remarks, ""])]
    show(*tables, _NOTE)


def plot_parts(built: Built, path: Path) -> None:
    """Draws the errors of all parts into a PNG or SVG file. Raises FileError, MachineError."""
    studies = [(name, study) for name, part in built.parts.items() for study in part.convergence.values()]
    folder(path.parent)
    plot_convergence(
        [study for _, study in studies],
        path,
        title=f"Errors of polyhedra, {built.title}",
        length_unit=built.units.length,
        names=[name for name, _ in studies],
    )

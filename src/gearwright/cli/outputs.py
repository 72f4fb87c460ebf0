"""Files that a command writes: polyhedra and pictures."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..compiled import telling
from ..designs.built import Built
from ..designs.file_problems import PAPERS
from ..disk import folder
from ..elements.assembly import draw_parts, save_parts
from ..elements.element import Element
from ..elements.pair import Pair
from ..elements.sheets import SheetLabels
from ..solids.robots import save_mechanism
from .common_options import Outputs


def write(built: Built, outputs: Outputs, written: list[Path]) -> None:
    """Writes polyhedra and pictures as asked for, and adds the path of each to those written."""
    if outputs.output is None and outputs.picture is None:
        return
    parts = built.placed(outputs.tolerance, outputs.clearance or 0.0)
    if outputs.output is not None:
        with progress(f"{outputs.output}"):
            if outputs.mechanism is not None:
                written += _save_mechanism(built, outputs)
            else:
                written += save_parts(
                    parts,
                    outputs.output,
                    built.units.length,
                    suffix=outputs.suffix,
                    placed=outputs.placed,
                    step_schema=outputs.step_schema,
                )
    if outputs.picture is not None:
        with progress("picture"):
            draw_parts(parts, outputs.picture, built.title, built.units.length)
        written.append(outputs.picture)


def _save_mechanism(built: Built, outputs: Outputs) -> list[Path]:
    """Writes the parts as bodies on joints, and gives the paths."""
    path, density = outputs.output or Path(), outputs.kilograms or 0.0
    folder(path.parent)
    (first, *_) = built.parts.values()
    if built.pair is None:
        return save_mechanism(path, first.gear.mechanism(path.stem, density, outputs.tolerance))
    turn = outputs.turn or 0.0
    return save_mechanism(path, built.pair.mechanism(path.stem, density, outputs.tolerance, turn))


def draw(element: Element, path: Path) -> Path:
    """Writes the plane section of an element as a drawing and gives its path."""
    folder(path.parent)
    with progress("drawing"):
        element.save_drawing(path)
    return path


def draw_sheet(element: Element | Pair, path: Path, outputs: Outputs) -> Path:
    """Writes the drawing sheet of an element or a pair and gives its path."""
    labels = SheetLabels(paper=outputs.paper or PAPERS[0], material=outputs.material, density=outputs.density)
    folder(path.parent)
    with progress("sheet"):
        element.save_sheet(path, labels)
    return path


@contextmanager
def progress(doing: str) -> Iterator[None]:
    """Says on a terminal's stderr what takes its time, and wipes it when done; and when it is that code is compiled."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(doing + " …") as status:

        def compiling(begins: bool) -> None:
            status.update(f"{doing} … (compiling for this machine, once)" if begins else f"{doing} …")

        with telling(compiling):
            yield

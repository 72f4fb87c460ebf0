"""What every command that builds an element does with it: results to stdout, files written, remarks noted."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from .. import catalog
from ..designs.built import Built, built_from
from ..designs.document import built_document
from ..disk import folder
from ..errors import GearwrightError
from .common_options import Outputs
from .convergence import plot_parts, show_convergence, with_convergence
from .exits import DONE
from .json_output import json_line
from .outputs import draw, draw_sheet, progress, write
from .report import show_built


def deliver(kind: catalog.Element, element: Any, outputs: Outputs, wording: Callable[[str], str]) -> int:
    """Writes the files asked for and prints the element's sizes and properties; gives the exit code.

    wording   turns a remark into the words of the user's input
    """
    built = built_from(kind, element, outputs.kilograms, outputs.turn or 0.0)
    if outputs.convergence is not None:
        built = with_convergence(built)
    if outputs.running and kind.running is not None:
        with progress("running"):
            built = replace(built, running=catalog.load(kind.running)(element))
    written: list[Path] = []
    try:
        _write_all(kind, built, element, outputs, written)
    except GearwrightError:
        _announce(written)  # what is there already stays, and is no secret
        raise
    print(json_line(built_document(built), indent=2)) if outputs.json else show_built(built)
    if outputs.convergence is not None and not outputs.json:
        show_convergence(built)
    for remark in element.remarks:
        print(f"note: {wording(remark)}", file=sys.stderr)
    _announce(written)
    return DONE


def _write_all(kind: catalog.Element, built: Built, element: Any, outputs: Outputs, written: list[Path]) -> None:
    """Writes the files asked for, and adds the path of each to those written."""
    write(built, outputs, written)
    if outputs.drawing is not None:
        written.append(draw(element, outputs.drawing))
    if outputs.sheet is not None:
        written.append(draw_sheet(element, outputs.sheet, outputs))
    if outputs.plot is not None:
        plot_parts(built, outputs.plot)
        written.append(outputs.plot)
    if outputs.diagram is not None and kind.diagram is not None:
        folder(outputs.diagram.parent)
        with progress("diagram"):
            catalog.load(kind.diagram)(element, outputs.diagram)
        written.append(outputs.diagram)


def _announce(written: Sequence[Path]) -> None:
    for path in written:
        print(f"wrote {path}", file=sys.stderr)

"""`gearwright build design.toml`: an element of the catalog from a file of its parameters."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter as Option

from .. import catalog
from ..designs.design_file import read_design
from ..designs.kinds import article, said
from ..errors import Problem, ProblemsError
from .common_options import DEFAULT, FLATTENED, Outputs
from .deliver import deliver
from .output_problems import output_problems

DESIGN = Option(metavar="DESIGN.toml", help="The element and its parameters by their Python names.")


def build(
    design: Annotated[Path, DESIGN],
    /,
    *,
    outputs: FLATTENED = DEFAULT,
) -> int:
    """Build the element that a TOML file describes: sizes, properties, files.

    Names of files in it are relative to it. `gearwright schema` says what it may hold.
    """
    kind, element = designed(design, outputs)
    return deliver(kind, element, outputs, str)


def design_in(design: Path) -> Any:
    """The element that a design file describes. Raises GearwrightError."""
    return _element(design, lambda _: [])[1]


def designed(design: Path, outputs: Outputs) -> tuple[catalog.Element, Any]:
    """The kind of element in a design file, and the element. Raises GearwrightError, for these outputs, too."""
    return _element(design, partial(output_problems, outputs))


def _element(design: Path, more: Callable[[catalog.Element], list[Problem]]) -> tuple[catalog.Element, Any]:
    found = read_design(design)
    element, problems = found.element()
    problems = problems + more(found.kind)
    if problems:
        raise ProblemsError(
            f"{design}: {article(found.kind.name)} {said(found.kind, found.kinds, str)} cannot be built so", problems
        )
    return found.kind, element

"""`gearwright check FILE…`: whether polyhedra in files bound solids and pass through themselves nowhere."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from ..errors import GearwrightError
from ..solids.polyhedron import Polyhedron
from ..solids.self_intersections import SelfIntersections
from ..solids.validity.report import PolyhedronValidity
from .exits import CHECK_FAILED, DONE, report
from .json_output import json_line
from .outputs import progress


def check(
    *files: Annotated[Path, Option(metavar="FILE", required=True, help="STL files, binary or text.")],
    json: Annotated[
        bool, Option(help="Print one line of JSON for each file.", negative=(), show_default=False)
    ] = False,
) -> int:
    """Holes, flipped and repeated faces, inward and buried bodies, faces that pass through each other.

    Exit code 1 if a check failed. A file that cannot be used is named on stderr; the others are still done.
    """
    worst = DONE
    for file in files:
        try:
            with progress(f"checking {file}"):
                polyhedron = Polyhedron.load(file)
                validity, crossings = polyhedron.validity(), polyhedron.self_intersections()
        except (GearwrightError, OSError) as error:
            worst = max(worst, report(error, "gearwright check", subject=str(file)))
            continue
        passed = validity.valid and not crossings
        worst = max(worst, DONE if passed else CHECK_FAILED)
        write = _json if json else _text
        sys.stdout.write(write(file, len(polyhedron.offsets) - 1, passed, validity, crossings) + "\n")
    return worst


def _json(file: Path, faces: int, passed: bool, validity: PolyhedronValidity, crossings: SelfIntersections) -> str:
    head = {"file": str(file), "passed": passed, "faces": faces}
    return json_line({**head, **validity.to_dict(), "self_intersections": crossings.to_dict()})


def _text(file: Path, faces: int, passed: bool, validity: PolyhedronValidity, crossings: SelfIntersections) -> str:
    components = "1 component" if validity.components == 1 else f"{validity.components} components"
    verdict = "all is well" if passed else "a check failed"
    lines = [f"{file}: {verdict} ({faces} faces, {components})", *str(validity).splitlines()]
    return "\n  ".join([*lines, *str(crossings).splitlines()])

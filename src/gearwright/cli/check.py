"""`gearwright check FILE…`: whether polyhedra in files bound solids and pass through themselves nowhere."""

from __future__ import annotations

import sys
from math import inf
from pathlib import Path
from typing import Annotated, NamedTuple

from cyclopts import Parameter as Option

from ..elements.element import Element
from ..elements.pair import Pair
from ..errors import GeometryError, Problem, ProblemsError
from ..files.formats import format_of
from ..solids.conversion import with_z_up
from ..solids.model import Model
from ..solids.self_intersections import SelfIntersections
from ..solids.validity.report import PolyhedronValidity
from ..studies.agreement import Agreement, compare
from .build import design_in
from .exits import CHECK_FAILED, DONE, report
from .json_output import json_line
from .outputs import progress


def check(
    *files: Annotated[
        Path,
        Option(metavar="FILE", required=True, json_list=False, help="Files of bodies, of any format that is read."),
    ],
    json: Annotated[
        bool, Option(help="Print one line of JSON for each file.", negative=(), show_default=False)
    ] = False,
    against: Annotated[
        Path | None,
        Option(metavar="DESIGN.toml", help="A design whose part or pair the files should be.", show_default=False),
    ] = None,
    within: Annotated[
        float | None,
        Option(
            metavar="LENGTH",
            help="Largest deviation from the design that passes, in its unit; 1e-4 × the diagonal and rounding if not"
            " given.",
            show_default=False,
        ),
    ] = None,
) -> int:
    """Holes, flipped and repeated faces, inward and buried bodies, warped faces, faces that pass through each other.

    With --against also how far surface, volume, centroid and inertia are from a design's exact ones.

    Exit code 1 if a check failed. A file that cannot be used is named on stderr; the others are still done.
    """
    design = wanted(against, within)
    worst = DONE
    for file in files:
        try:
            with progress(f"checking {file}"):
                model = Model.load(file)
                polyhedron = model.polyhedron
                findings = Findings.of(model)
                agreement = None if design is None else _against(file, model, design, within)
        except Exception as error:  # noqa: BLE001  whatever one file brings about, the others are still done
            worst = max(worst, report(error, f"gearwright check {file}", subject=str(file)))
            continue
        passed = findings.passed and (agreement is None or agreement.passed)
        worst = max(worst, DONE if passed else CHECK_FAILED)
        write = _json if json else _text
        sys.stdout.write(write(file, len(polyhedron.offsets) - 1, findings, agreement) + "\n")
    return worst


def wanted(against: Path | None, within: float | None) -> Element | Pair | None:
    """The design that files are compared with. Raises ProblemsError for a limit without one, and what reading does."""
    if against is None:
        if within is not None:
            given = Problem(f"--within {within:g}", "it is a limit for --against DESIGN.toml, which is not given")
            raise ProblemsError("This option cannot be used", [given])
        return None
    if within is not None and not 0.0 < within < inf:
        given = Problem(f"--within {within:g}", "a positive length is needed, in the design's unit")
        raise ProblemsError("This option cannot be used", [given])
    return design_in(against)


def _against(file: Path, model: Model, design: Element | Pair, within: float | None) -> Agreement:
    return compare(with_z_up(model, format_of(file, "read")), design, within=within)


class Findings(NamedTuple):
    """What was found of one polyhedron.

    inertia   why no body can have its moments; empty where other problems leave it without any
    sound     how its bodies bound solids all the same, in words, where `properties` takes them so
    """

    validity: PolyhedronValidity
    crossings: SelfIntersections
    inertia: tuple[Problem, ...]
    sound: tuple[str, ...]

    @classmethod
    def of(cls, model: Model) -> Findings:
        polyhedron = model.polyhedron
        inertia: tuple[Problem, ...] = ()
        if polyhedron.validity().valid:
            try:
                polyhedron.properties()
            except GeometryError as error:
                inertia = error.problems
        mended = () if polyhedron.validity().valid else model.sound.remarks[len(model.remarks) :]
        return cls(polyhedron.validity(), polyhedron.self_intersections(), inertia, mended)

    @property
    def passed(self) -> bool:
        return self.validity.valid and not self.crossings and not self.inertia


def _json(file: Path, faces: int, findings: Findings, agreement: Agreement | None) -> str:
    passed = findings.passed and (agreement is None or agreement.passed)
    head = {"file": str(file), "passed": passed, "faces": faces}
    inertia = {"inertia_problems": [str(problem) for problem in findings.inertia], "sound": list(findings.sound)}
    crossings = {"self_intersections": findings.crossings.to_dict()}
    against = {} if agreement is None else {"against": agreement.to_dict()}
    return json_line({**head, **findings.validity.to_dict(), **inertia, **crossings, **against})


def _text(file: Path, faces: int, findings: Findings, agreement: Agreement | None) -> str:
    validity = findings.validity
    components = "1 component" if validity.components == 1 else f"{validity.components} components"
    passed = findings.passed and (agreement is None or agreement.passed)
    verdict = "all is well" if passed else "a check failed"
    lines = [f"{file}: {verdict} ({faces} faces, {components})", *str(validity).splitlines()]
    lines += [f"problem: {problem}" for problem in findings.inertia]
    lines += [f"remark: {words}, as `properties` takes it" for words in findings.sound]
    compared = [] if agreement is None else str(agreement).splitlines()
    return "\n  ".join([*lines, *str(findings.crossings).splitlines(), *compared])

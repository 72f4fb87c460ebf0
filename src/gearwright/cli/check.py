"""`gearwright check FILE…`: whether polyhedra in files bound solids and pass through themselves nowhere."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, NamedTuple

from cyclopts import Parameter as Option

from ..errors import GeometryError, Problem
from ..solids.model import Model
from ..solids.self_intersections import SelfIntersections
from ..solids.validity.report import PolyhedronValidity
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
) -> int:
    """Holes, flipped and repeated faces, inward and buried bodies, warped faces, faces that pass through each other.

    Exit code 1 if a check failed. A file that cannot be used is named on stderr; the others are still done.
    """
    worst = DONE
    for file in files:
        try:
            with progress(f"checking {file}"):
                model = Model.load(file)
                polyhedron = model.polyhedron
                findings = Findings.of(model)
        except Exception as error:  # noqa: BLE001  whatever one file brings about, the others are still done
            worst = max(worst, report(error, f"gearwright check {file}", subject=str(file)))
            continue
        worst = max(worst, DONE if findings.passed else CHECK_FAILED)
        write = _json if json else _text
        sys.stdout.write(write(file, len(polyhedron.offsets) - 1, findings) + "\n")
    return worst


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


def _json(file: Path, faces: int, findings: Findings) -> str:
    head = {"file": str(file), "passed": findings.passed, "faces": faces}
    inertia = {"inertia_problems": [str(problem) for problem in findings.inertia], "sound": list(findings.sound)}
    crossings = {"self_intersections": findings.crossings.to_dict()}
    return json_line({**head, **findings.validity.to_dict(), **inertia, **crossings})


def _text(file: Path, faces: int, findings: Findings) -> str:
    validity = findings.validity
    components = "1 component" if validity.components == 1 else f"{validity.components} components"
    verdict = "all is well" if findings.passed else "a check failed"
    lines = [f"{file}: {verdict} ({faces} faces, {components})", *str(validity).splitlines()]
    lines += [f"problem: {problem}" for problem in findings.inertia]
    lines += [f"remark: {words}, as `properties` takes it" for words in findings.sound]
    return "\n  ".join([*lines, *str(findings.crossings).splitlines()])

"""What is wrong with a request for a file: suffixes, and choices that its format knows nothing of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .. import catalog
from ..errors import Problem
from ..files.formats import written_suffixes
from ..parameters import Parameter

DRAWINGS = (".dxf", ".svg")
SHEETS = (".pdf", ".dxf", ".svg")
PAPERS = ("A3", "A4")
STEP_SCHEMAS = ("AP214", "AP242")
WHATS = ("body", "drawing", "sheet", "design")

TOLERANCE = Parameter(meaning="largest distance of written faces from the part's", unit="length", above=0)
CLEARANCE = Parameter(meaning="gap between printed surfaces that would touch", unit="length", minimum=0)
PLAY = "give the parts their play by backlash, tip clearance and bores; or take polygons, as .3mf or .stl"


def suffixes_of(what: str) -> tuple[str, ...]:
    """Of the files that show a design so."""
    return {"body": tuple(written_suffixes()), "drawing": DRAWINGS, "sheet": SHEETS, "design": (".toml",)}[what]


def file_problems(request: Mapping[str, Any], kind: catalog.Element) -> list[Problem]:
    """What is wrong with a request as of `writing.written`, besides its design and its density."""
    what, suffix = request["what"], request["suffix"]
    if what not in WHATS:
        return [Problem(f"what = {what!r}", f"choose one of {', '.join(WHATS)}")]
    known = suffixes_of(what)
    if suffix not in known:
        return [Problem(f"suffix = {suffix!r}", f"no {what} is written so, but as {', '.join(known)}")]
    if what == "drawing" and not kind.plane:
        return [Problem("what = 'drawing'", f"a {kind.name} has no plane section, which is what is drawn")]
    return [*_number_problems(request), *_body_problems(request, kind), *_paper_problems(request)]


def _number_problems(request: Mapping[str, Any]) -> list[Problem]:
    limited = {"tolerance": TOLERANCE, "clearance": CLEARANCE}
    return [
        Problem(f"{name} = {request[name]!r}", problem)
        for name, parameter in limited.items()
        if request.get(name) is not None and (problem := parameter.problem(request[name]))
    ]


def _body_problems(request: Mapping[str, Any], kind: catalog.Element) -> list[Problem]:
    suffix, body = request["suffix"], request["what"] == "body"
    problems = []
    if body and suffix in written_suffixes("mechanism"):
        if request.get("density") is None and request.get("material") is None:
            problems.append(Problem("density", f"a {suffix} file holds masses; give a material or a density in kg/m³"))
        if request.get("separate"):
            problems.append(Problem("separate", f"a {suffix} file holds the members on their joints, not apart"))
    if request.get("clearance") and not (body and suffix in written_suffixes("polygons")):
        given = f"clearance = {request['clearance']!r}"
        problems.append(Problem(given, f"moves faces of polyhedra, and this {suffix} file holds others; {PLAY}"))
    if request.get("separate") and kind.members == 1:
        problems.append(Problem("separate", "applies to a pair"))
    schema = request.get("step_schema")
    if schema is not None and schema not in STEP_SCHEMAS:
        problems.append(Problem(f"step_schema = {schema!r}", f"choose {' or '.join(STEP_SCHEMAS)}"))
    elif schema is not None and not (body and suffix in written_suffixes("smooth faces")):
        problems.append(Problem(f"step_schema = {schema!r}", "applies to STEP files"))
    return problems


def _paper_problems(request: Mapping[str, Any]) -> list[Problem]:
    paper = request.get("paper")
    if paper is None or paper in PAPERS:
        return []
    return [Problem(f"paper = {paper!r}", f"choose {' or '.join(PAPERS)}")]

"""What is wrong with the options that say what is written: suffixes, options for other parts, names given twice."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from .. import catalog
from ..designs.file_problems import CLEARANCE, DRAWINGS, PAPERS, PLAY, SHEETS, STEP_SCHEMAS, TOLERANCE
from ..designs.kinds import option_name
from ..errors import Problem
from ..files.formats import written_suffixes
from ..materials import DENSITY
from ..parameters import Parameter
from .common_options import Outputs
from .densities import material_problems

TURN = Parameter(meaning="angle by which the pinion is turned", unit="angle")

_NOT_PLANE = "has no plane section, which is what is drawn; --picture shows it, and -o writes its polyhedron"


def output_problems(outputs: Outputs, kind: catalog.Element) -> list[Problem]:
    """What is wrong with these options, for an element of a kind."""
    limited = {"density": DENSITY, "tolerance": TOLERANCE, "turn": TURN, "clearance": CLEARANCE}
    return [
        *unsound({name: (getattr(outputs, name), parameter) for name, parameter in limited.items()}),
        *_material_problems(outputs),
        *_mechanism_problems(outputs),
        *_name_problems(outputs),
        *([Problem("--drawing", f"a {kind.name} {_NOT_PLANE}")] if outputs.drawing and not kind.plane else []),
        *_folder_problems(outputs),
        *_format_problems(outputs),
        *_sheet_problems(outputs),
        *_diagram_problems(outputs, kind),
        *_running_problems(outputs, kind),
        *_idle_problems(outputs, kind),
    ]


def _name_problems(outputs: Outputs) -> list[Problem]:
    """Files that no such file can be, or that are named twice."""
    accepted = {
        "output": (outputs.output, written_suffixes()),
        "picture": (outputs.picture, (".png",)),
        "drawing": (outputs.drawing, DRAWINGS),
        "sheet": (outputs.sheet, SHEETS),
        "convergence": (outputs.plot, (".png", ".svg")),
    }
    files = {name: path for name, (path, _) in accepted.items()}
    named = {name: path for name, path in files.items() if path is not None and path != Path()}
    return [
        *(Problem(option_name(name), "a name is needed") for name, path in files.items() if path == Path()),
        *_one_file_twice({**named, "diagram": outputs.diagram}),
        *(
            problem
            for name, path in named.items()
            if name != "output" or path.suffix  # without one it is a folder
            for problem in _wrong_suffix(name, path, accepted[name][1])
        ),
    ]


def _idle_problems(outputs: Outputs, kind: catalog.Element) -> list[Problem]:
    """Options that nothing is done with."""
    pairs_only = {"placed": outputs.placed, "turn": outputs.turn is not None}
    files_only = {"placed": outputs.placed}
    files_only |= {name: getattr(outputs, name) is not None for name in ("tolerance", "clearance")}
    writes = outputs.output is not None or outputs.picture is not None
    alone = [name for name, given in pairs_only.items() if given and kind.members == 1]
    idle = [name for name, given in files_only.items() if given and not writes]
    return [
        *(Problem(option_name(name), "applies to a pair") for name in alone),
        *(Problem(option_name(name), "applies to files and pictures; none is asked for") for name in idle),
    ]


def unsound(values: Mapping[str, tuple[float | None, Parameter]]) -> list[Problem]:
    """Common options outside their limits."""
    return [
        Problem(f"{option_name(name)} = {value:g}", problem)
        for name, (value, parameter) in values.items()
        if value is not None and (problem := parameter.problem(value))
    ]


def _wrong_suffix(name: str, path: Path, suffixes: Sequence[str]) -> list[Problem]:
    """A file whose suffix is not one of those."""
    if path.suffix.lower() in suffixes:
        return []
    return [Problem(f"{option_name(name)} {path}", f"no such files are written here, but {', '.join(suffixes)}")]


def _applies_to(kinds: Sequence[catalog.Element]) -> str:
    """What an option is for, in words."""
    return "applies to " + " or ".join(f"a {kind.name}" for kind in kinds)


def _one_file_twice(files: Mapping[str, Path | None]) -> list[Problem]:
    """Outputs that would overwrite each other."""
    seen: dict[Path, str] = {}
    problems = []
    for name, path in files.items():
        if path is None or path == Path():
            continue
        if path.resolve() in seen:
            other = option_name(seen[path.resolve()])
            problems.append(Problem(f"{option_name(name)} {path}", f"the file of {other}, too; name another one"))
        seen[path.resolve()] = name
    return problems


def _mechanism_problems(outputs: Outputs) -> list[Problem]:
    """That a density is missing where masses are written."""
    if outputs.mechanism is None or outputs.density is not None or outputs.material is not None:
        return []
    needed = f"{outputs.mechanism.name} holds masses; give a --material NAME, or a --density in kg/m³"
    return [Problem(f"{option_name('output')} {outputs.output}", needed)]


def _material_problems(outputs: Outputs) -> list[Problem]:
    """What is wrong with the material, alone or beside a density."""
    if outputs.material is not None and outputs.density is not None:
        return [Problem(f"--material {outputs.material}", "give either a material or a --density, not both")]
    return material_problems(outputs.material)


def _diagram_problems(outputs: Outputs, kind: catalog.Element) -> list[Problem]:
    """What is wrong with the diagram asked for, of an element that draws one or does not."""
    if outputs.diagram is None:
        return []
    if kind.diagram is None:
        return [Problem(option_name("diagram"), _applies_to([one for one in catalog.ELEMENTS if one.diagram]))]
    return _wrong_suffix("diagram", outputs.diagram, [".png", ".svg"])


def _folder_problems(outputs: Outputs) -> list[Problem]:
    """What is wrong with the format of files in a folder."""
    if outputs.format is None:
        return []
    given, problems = f"--format {outputs.format}", []
    known = [suffix for holds in ("polygons", "smooth faces") for suffix in written_suffixes(holds)]
    if outputs.suffix not in known:
        problems.append(Problem(given, f"one of {', '.join(suffix[1:] for suffix in known)} is needed"))
    if not outputs.in_folder:
        output = outputs.output
        named = f"--output {output} names a file, whose suffix is its format" if output else "none is named"
        problems.append(Problem(given, f"applies to the files in a folder (-o FOLDER); {named}"))
    return problems


def _format_problems(outputs: Outputs) -> list[Problem]:
    """Options that the format of what is written knows nothing of."""
    suffix = outputs.suffix if outputs.in_folder else outputs.output.suffix.lower() if outputs.output else ""
    problems = []
    if outputs.clearance and suffix in written_suffixes() and suffix not in written_suffixes("polygons"):
        given = f"--clearance {outputs.clearance:g}"
        problems.append(Problem(given, f"moves faces of polyhedra, and a {suffix} file holds others; {PLAY}"))
    if outputs.step_schema is not None:
        given = f"--step-schema {outputs.step_schema}"
        if outputs.step_schema.upper() not in STEP_SCHEMAS:
            problems.append(Problem(given, f"choose {' or '.join(STEP_SCHEMAS)}"))
        if suffix not in written_suffixes("smooth faces"):
            problems.append(Problem(given, "applies to STEP files; none is asked for (-o FILE.step)"))
    return problems


def _sheet_problems(outputs: Outputs) -> list[Problem]:
    """What is wrong with the sheet asked for."""
    if outputs.sheet is None:
        return [] if outputs.paper is None else [Problem("--paper", "applies to a --sheet; none is asked for")]
    if outputs.paper not in (None, *PAPERS):
        return [Problem(f"--paper {outputs.paper}", f"choose {' or '.join(PAPERS)}")]
    return []


def _running_problems(outputs: Outputs, kind: catalog.Element) -> list[Problem]:
    if not outputs.running or kind.running is not None:
        return []
    return [Problem(option_name("running"), _applies_to([one for one in catalog.ELEMENTS if one.running]))]

"""Options of `gearwright properties` as they are typed, and what is asked by them, checked all together."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from cyclopts import Parameter as Option

from ..errors import GeometryError, ParameterError, Problem, ProblemsError
from ..materials import DENSITY, material
from ..parameters import LENGTH_UNITS, MOST, Parameter, did_you_mean
from ..solids.validity.kinds import ProblemKind
from .densities import DENSITY_HELP, MATERIAL_HELP
from .measuring import Question
from .output_problems import unsound
from .views import FILE_AXES, View, axes_in

Format = Literal["table", "json", "csv", "urdf", "sdf", "mjcf"]

INERTIAL: tuple[Format, ...] = ("urdf", "sdf", "mjcf")
"""Formats that are in SI units and need a mass."""

_THICKNESS = Parameter(meaning="thickness of a shell", unit="length", above=0)
_JOBS = Parameter(meaning="number of processes", kind="integer", minimum=1, maximum=256)

_OF_ONE = " For one body of a file: name=…; may be repeated."


@dataclass(frozen=True, kw_only=True)
class Wanted:
    """Options of `properties`; whether they can be used is the question of `question` and `view`."""

    json: Annotated[bool, Option(help="The same as --format json.", negative=(), show_default=False)] = False
    format: Annotated[
        Format | None,
        Option(
            help="Tables, a line of JSON a file, CSV with a row a body, or inertial elements of robot descriptions.",
            show_default="table",
        ),
    ] = None
    density: Annotated[
        list[str] | None, Option(help=DENSITY_HELP + _OF_ONE, metavar="[NAME=]KG/M³", negative_iterable=())
    ] = None
    material: Annotated[
        list[str] | None, Option(help=MATERIAL_HELP + _OF_ONE, metavar="[NAME=]MATERIAL", negative_iterable=())
    ] = None
    length_unit: Annotated[
        str | None,
        Option(help="Unit of the lengths in files that state none.", metavar="|".join(LENGTH_UNITS), show_default="mm"),
    ] = None
    about: Annotated[
        tuple[float, float, float] | None,
        Option(
            help="Inertia about this point, too, in the files' lengths and frame.",
            metavar="X Y Z",
            negative_iterable=(),
        ),
    ] = None
    axes: Annotated[
        str,
        Option(
            help="Axes of tensors: file, principal, a quaternion w,x,y,z, or nine numbers of a rotation whose columns"
            " they are, row by row.",
            metavar="AXES",
        ),
    ] = FILE_AXES
    sum: Annotated[bool, Option(help="All files together, too.", negative=(), show_default=False)] = False
    subtract: Annotated[
        list[Path] | None,
        Option(
            help="Takes a part of each file away; may be repeated.",
            metavar="FILE",
            negative_iterable=(),
            json_list=False,
        ),
    ] = None
    shell: Annotated[
        float | None,
        Option(help="Thin sheets of this thickness along the faces, which need not close.", metavar="THICKNESS"),
    ] = None
    surface_density: Annotated[
        float | None, Option(help="Thin sheets of this mass per area, instead of a thickness.", metavar="KG/M²")
    ] = None
    allow: Annotated[
        list[ProblemKind] | None,
        Option(
            help="Answer in spite of a problem, with a warning; may be repeated.", metavar="KIND", negative_iterable=()
        ),
    ] = None
    jobs: Annotated[
        int | None, Option(help="Processes that share the files.", metavar="N", show_default="by their sizes")
    ] = None

    @property
    def written(self) -> Format:
        """The format of the results."""
        return "json" if self.json else self.format or "table"


DEFAULT = Wanted()
FLATTENED = Annotated[Wanted, Option(name="*")]
"""The options as a command's parameter: each on its own, not as one."""


def asked(wanted: Wanted) -> tuple[Question, View]:
    """What is asked of every file, and how its answer is shown. Raises ProblemsError, all problems together."""
    problems = unsound(
        {
            "shell": (wanted.shell, _THICKNESS),
            "surface_density": (wanted.surface_density, DENSITY),
            "jobs": (wanted.jobs, _JOBS),
        }
    )
    densities = _densities(wanted, problems)
    view = _view(wanted, problems)
    problems += [*_unit_problems(wanted), *_shell_problems(wanted), *_format_problems(wanted, view)]
    if problems:
        raise ProblemsError("These options cannot be used", problems)
    question = Question(
        length_unit=wanted.length_unit,
        densities=densities,
        thickness=wanted.shell,
        surface_density=wanted.surface_density,
        subtracted=tuple(wanted.subtract or ()),
        allow=tuple(wanted.allow or ()),
    )
    return question, view


def _densities(wanted: Wanted, problems: list[Problem]) -> dict[str, float]:
    """kg/m³ by the name of a body, from all densities and materials; adds what is wrong with them to the problems."""
    found: dict[str, float] = {}
    for option, words, value_of in (
        ("--density", wanted.density, _number),
        ("--material", wanted.material, lambda name: material(name).density),
    ):
        for word in words or ():
            body, _, value = word.rpartition("=")
            try:
                number = value_of(value)
            except ParameterError as error:
                problems += [Problem(f"{option} {word}", problem.message) for problem in error.problems]
                continue
            if body in found:
                whose = f"the density of {body}" if body else "the density"
                problems.append(Problem(f"{option} {word}", f"{whose} is given already; leave one out"))
            found[body] = number
    return found


def _number(word: str) -> float:
    """A density that is typed. Raises ParameterError where it is none."""
    try:
        number = float(word)
    except ValueError:
        problem: str | None = "a number in kg/m³ is needed; the name of a material goes with --material"
    else:
        problem = DENSITY.problem(number)
    if problem:
        raise ParameterError("A density", [Problem(word, problem)])
    return number


def _view(wanted: Wanted, problems: list[Problem]) -> View:
    about = None if wanted.about is None else np.array(wanted.about)
    if about is not None and not np.all(np.abs(about) <= MOST):
        words = " ".join(map(str, wanted.about or ()))
        problems.append(Problem(f"--about {words}", f"three numbers of at most {MOST:g} are needed"))
    try:
        return View(about=about, axes=axes_in(wanted.axes))
    except GeometryError as error:
        problems += [Problem(f"--axes {wanted.axes}", problem.message) for problem in error.problems]
        return View(about=about)


def _unit_problems(wanted: Wanted) -> list[Problem]:
    unit = wanted.length_unit
    if unit is None or unit in LENGTH_UNITS:
        return []
    return [
        Problem(f"--length-unit {unit}", f"choose one of {', '.join(LENGTH_UNITS)}{did_you_mean(unit, LENGTH_UNITS)}")
    ]


def _shell_problems(wanted: Wanted) -> list[Problem]:
    """Options that contradict each other where shells are measured."""
    shell = {"--shell": wanted.shell, "--surface-density": wanted.surface_density}
    (name, *others) = [option for option, value in shell.items() if value is not None] or [""]
    if not name:
        return []
    problems = []
    if others:
        problems.append(Problem("--surface-density", "leave it out, or --shell; with that, give a --density"))
    elif wanted.surface_density is not None and (wanted.density or wanted.material):
        problems.append(Problem("--surface-density", "it takes the place of a density; with --shell, give a --density"))
    if wanted.subtract:
        problems.append(Problem("--subtract", f"applies to solids; leave out {name}"))
    if wanted.allow:
        problems.append(Problem("--allow", f"{name} takes faces that do not close as they are"))
    return problems


def _format_problems(wanted: Wanted, view: View) -> list[Problem]:
    problems = []
    if wanted.json and wanted.format not in (None, "json"):
        problems.append(Problem(f"--format {wanted.format}", "--json asks for another; leave one out"))
    heavy = wanted.density or wanted.material or wanted.surface_density is not None
    if wanted.written in INERTIAL and not heavy:
        problems.append(Problem(f"--format {wanted.written}", "it is in kg; a --density or --material is needed"))
    if wanted.written == "mjcf" and view.name == "given":
        problems.append(Problem(f"--axes {wanted.axes}", "MJCF takes tensors along the axes file or principal only"))
    if wanted.written == "csv" and view.about is not None:
        problems.append(Problem("--about", "CSV has no columns for it; take --format json"))
    if wanted.written in INERTIAL and view.about is not None:
        problems.append(Problem("--about", f"{wanted.written} takes inertia about the centre of mass only"))
    return problems

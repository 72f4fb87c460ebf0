"""Options common to several commands: what is written where, in which units, how finely."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from .. import catalog
from ..errors import FileError, Problem, ProblemsError
from ..parameters import Parameter
from .options import OUTPUT, option_name

DENSITY = Parameter(meaning="density in kg/m³", above=0)
TOLERANCE = Parameter(meaning="largest chord distance of the polyhedron", unit="length", above=0)
TURN = Parameter(meaning="angle by which the pinion is turned", unit="angle")

DENSITY_HELP = "Density ρ in kg/m³; mass is then in kg. Without it, density is 1 per cubed length unit."


def require_sound(values: Mapping[str, tuple[float | None, Parameter]]) -> None:
    """Refuses common options outside their limits, all together. Raises ProblemsError."""
    problems = [
        Problem(f"{option_name(name)} = {value:g}", problem)
        for name, (value, parameter) in values.items()
        if value is not None and (problem := parameter.problem(value))
    ]
    if problems:
        raise ProblemsError("These options cannot be used", problems)


def require_suffix(path: Path, suffixes: Sequence[str]) -> None:
    """Refuses a file whose suffix is not one of those. Raises FileError."""
    if path.suffix.lower() not in suffixes:
        kinds = ", ".join(suffixes)
        raise FileError(f"{path}: a file of this kind is not written here; name one that ends in {kinds}")


@dataclass(frozen=True, kw_only=True)
class Outputs:
    """Options common to all elements. Raises ProblemsError and FileError."""

    json: Annotated[bool, Option(help="Print JSON instead of tables.", negative=(), show_default=False)] = False
    output: Annotated[
        Path | None,
        Option(
            name=["--output", "-o"],
            help="Write polyhedra: a file.stl (a pair: both members in mesh), or a folder for one file a member.",
            metavar="PATH",
        ),
    ] = None
    placed: Annotated[
        bool, Option(help="Write each member of a pair where it meshes.", negative=(), show_default=False)
    ] = False
    turn: Annotated[
        float | None, Option(help="Angle by which a placed pinion is turned; its mate follows.", metavar="DEG")
    ] = None
    picture: Annotated[Path | None, Option(help="Draw a picture.", metavar="FILE.png")] = None
    tolerance: Annotated[
        float | None,
        Option(
            help="Largest chord distance of the polyhedron, of its files and pictures only (> 0).",
            metavar="LENGTH",
            show_default="1e-4 × bounding diagonal",
        ),
    ] = None
    density: Annotated[float | None, Option(help=DENSITY_HELP, metavar="KG/M³")] = None

    def __post_init__(self) -> None:
        require_sound(
            {"density": (self.density, DENSITY), "tolerance": (self.tolerance, TOLERANCE), "turn": (self.turn, TURN)}
        )
        if self.output is not None and self.output.suffix:
            require_suffix(self.output, [f.suffix for f in catalog.FILE_FORMATS if f.writer])
        if self.picture is not None:
            require_suffix(self.picture, [".png"])

    def require_no_pair_options(self, kind: str) -> None:
        """Refuses what only a pair has. Raises ProblemsError."""
        given = {"placed": self.placed, "turn": self.turn is not None}
        found = [Problem(option_name(name), "applies to a pair") for name, present in given.items() if present]
        if found:
            raise ProblemsError(f"A single {kind} cannot be built with these options", found)


DEFAULT = Outputs()
FLATTENED = Annotated[Outputs, Option(name="*", group=OUTPUT)]
"""The options as a command's parameter: each on its own, not as one."""

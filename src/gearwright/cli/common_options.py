"""Options common to several commands: what is written where, in which units, how finely."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from .. import catalog
from ..errors import ParameterError, Problem
from ..materials import DENSITY, material
from ..parameters import Parameter
from .options import OUTPUT, option_name

TOLERANCE = Parameter(meaning="largest chord distance of the polyhedron", unit="length", above=0)
TURN = Parameter(meaning="angle by which the pinion is turned", unit="angle")

SHEETS, PAPERS = (".dxf", ".svg", ".pdf"), ("A3", "A4")
"""What `gearwright.sheets` writes, which is not loaded for the help."""

_NOT_PLANE = "has no plane section, which is what is drawn; --picture shows it, and -o writes its polyhedron"

DENSITY_HELP = "Density ρ in kg/m³; mass is then in kg. Without it, density is 1 per cubed length unit."
MATERIAL_HELP = "Density of a material; `gearwright materials` lists them."


def unsound(values: Mapping[str, tuple[float | None, Parameter]]) -> list[Problem]:
    """Common options outside their limits."""
    return [
        Problem(f"{option_name(name)} = {value:g}", problem)
        for name, (value, parameter) in values.items()
        if value is not None and (problem := parameter.problem(value))
    ]


def kilograms(density: float | None, name: str | None) -> float | None:
    """Density in kg/m³, given as such or by the name of a material; None where neither is given."""
    return material(name).density if name is not None else density


def material_problems(name: str | None) -> list[Problem]:
    """What is wrong with the name of a material."""
    try:
        kilograms(None, name)
    except ParameterError as error:
        return [Problem(f"--material {name}", problem.message) for problem in error.problems]
    return []


def _wrong_suffix(name: str, path: Path | None, suffixes: Sequence[str]) -> list[Problem]:
    """A file whose suffix is not one of those."""
    if path is None or path.suffix.lower() in suffixes:
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
        if path.absolute() in seen:
            other = option_name(seen[path.absolute()])
            problems.append(Problem(f"{option_name(name)} {path}", f"the file of {other}, too; name another one"))
        seen[path.absolute()] = name
    return problems


@dataclass(frozen=True, kw_only=True)
class Outputs:
    """Options common to all elements; whether they can be used is the question of `problems`."""

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
    drawing: Annotated[
        Path | None,
        Option(help="Draw the plane section, with true arcs and splines.", metavar="FILE.dxf|svg"),
    ] = None
    sheet: Annotated[
        Path | None,
        Option(
            help="Draw a sheet for the shop: views, dimensions, gear data, title block; one for each member of a pair.",
            metavar="FILE.dxf|svg|pdf",
        ),
    ] = None
    paper: Annotated[str | None, Option(help="Paper of the sheet.", metavar="A3|A4", show_default="A3")] = None
    tolerance: Annotated[
        float | None,
        Option(
            help="Largest chord distance of the polyhedron, of its files and pictures only (> 0).",
            metavar="LENGTH",
            show_default="1e-4 × bounding diagonal",
        ),
    ] = None
    density: Annotated[float | None, Option(help=DENSITY_HELP, metavar="KG/M³")] = None
    material: Annotated[str | None, Option(help=MATERIAL_HELP, metavar="NAME")] = None
    convergence: Annotated[
        list[Path] | None,
        Option(
            help="Errors of polyhedra against the exact properties, and their order; drawn, if a file is named.",
            consume_multiple=(0, 1),
            negative_iterable=(),
            metavar="[FILE.png]",
        ),
    ] = None

    diagram: Annotated[
        Path | None,
        Option(help="Draw how it moves: a cam's disk and follower, a bevel pair's contact.", metavar="FILE.png|svg"),
    ] = None

    running: Annotated[
        bool,
        Option(
            help="Transmission error of a pair, as designed and with errors of mounting.",
            negative=(),
            show_default=False,
        ),
    ] = False

    @property
    def kilograms(self) -> float | None:
        """Density in kg/m³, None where none is given."""
        return kilograms(self.density, self.material)

    @property
    def plot(self) -> Path | None:
        """The file that the errors are drawn into."""
        return self.convergence[0] if self.convergence else None

    def _material_problems(self) -> list[Problem]:
        """What is wrong with the material, alone or beside a density."""
        if self.material is not None and self.density is not None:
            return [Problem(f"--material {self.material}", "give either a material or a --density, not both")]
        return material_problems(self.material)

    def _diagram_problems(self, kind: catalog.Element) -> list[Problem]:
        """What is wrong with the diagram asked for, of an element that draws one or does not."""
        if self.diagram is None:
            return []
        if kind.diagram is None:
            return [Problem(option_name("diagram"), _applies_to([one for one in catalog.ELEMENTS if one.diagram]))]
        return _wrong_suffix("diagram", self.diagram, [".png", ".svg"])

    def _sheet_problems(self) -> list[Problem]:
        """What is wrong with the sheet asked for."""
        if self.sheet is None:
            return [] if self.paper is None else [Problem("--paper", "applies to a --sheet; none is asked for")]
        if self.paper not in (None, *PAPERS):
            return [Problem(f"--paper {self.paper}", f"choose {' or '.join(PAPERS)}")]
        return [] if self.sheet == Path() else _wrong_suffix("sheet", self.sheet, SHEETS)

    def _running_problems(self, kind: catalog.Element) -> list[Problem]:
        if not self.running or kind.running is not None:
            return []
        return [Problem(option_name("running"), _applies_to([one for one in catalog.ELEMENTS if one.running]))]

    def problems(self, kind: catalog.Element) -> list[Problem]:
        """What is wrong with these options, for an element of a kind."""
        written = [suffix for f in catalog.FILE_FORMATS if f.writer for suffix in f.suffixes]
        file = self.output if self.output is not None and self.output.suffix else None
        files = {
            "output": self.output,
            "picture": self.picture,
            "drawing": self.drawing,
            "sheet": self.sheet,
            "convergence": self.plot,
        }
        nameless = [name for name, path in files.items() if path == Path()]
        limited = {"density": DENSITY, "tolerance": TOLERANCE, "turn": TURN}
        pairs_only = {"placed": self.placed, "turn": self.turn is not None}
        files_only = {"placed": self.placed, "tolerance": self.tolerance is not None}
        writes = self.output is not None or self.picture is not None
        return [
            *unsound({name: (getattr(self, name), parameter) for name, parameter in limited.items()}),
            *self._material_problems(),
            *(Problem(option_name(name), "a name is needed") for name in nameless),
            *_wrong_suffix("output", file, written),
            *_one_file_twice({**files, "diagram": self.diagram}),
            *(_wrong_suffix("picture", self.picture, [".png"]) if "picture" not in nameless else []),
            *(_wrong_suffix("drawing", self.drawing, [".dxf", ".svg"]) if "drawing" not in nameless else []),
            *(
                [Problem("--drawing", f"a {kind.name} {_NOT_PLANE}")]
                if self.drawing is not None and not kind.plane
                else []
            ),
            *(_wrong_suffix("convergence", self.plot, [".png", ".svg"]) if "convergence" not in nameless else []),
            *self._sheet_problems(),
            *self._diagram_problems(kind),
            *self._running_problems(kind),
            *(
                Problem(option_name(name), "applies to a pair")
                for name, given in pairs_only.items()
                if given and kind.members == 1
            ),
            *(
                Problem(option_name(name), "applies to files and pictures; none is asked for")
                for name, given in files_only.items()
                if given and not writes
            ),
        ]


DEFAULT = Outputs()
FLATTENED = Annotated[Outputs, Option(name="*", group=OUTPUT)]
"""The options as a command's parameter: each on its own, not as one."""

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
CLEARANCE = Parameter(meaning="gap between printed surfaces that would touch", unit="length", minimum=0)
TURN = Parameter(meaning="angle by which the pinion is turned", unit="angle")

_PLAY = "give the parts their play by backlash, tip clearance and bores; or write polygons, as .3mf or .stl"
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


def written_suffixes(holds: str = "") -> list[str]:
    """Of files of bodies that can be written, of all or of those that hold "polygons" or "smooth faces"."""
    formats = (one for one in catalog.FILE_FORMATS if one.writer and holds in ("", one.holds))
    return [suffix for one in formats for suffix in one.suffixes]


@dataclass(frozen=True, kw_only=True)
class Outputs:
    """Options common to all elements; whether they can be used is the question of `problems`."""

    json: Annotated[bool, Option(help="Print JSON instead of tables.", negative=(), show_default=False)] = False
    output: Annotated[
        Path | None,
        Option(
            name=["--output", "-o"],
            help="Write a file in the format of its suffix (a pair: both members in mesh), or a folder for one file a"
            f" member ({', '.join(written_suffixes())}). Those for simulators need a density.",
            metavar="PATH",
        ),
    ] = None
    format: Annotated[
        str | None,
        Option(help="Format of the files in a folder, as a suffix.", metavar="SUFFIX", show_default="stl"),
    ] = None
    clearance: Annotated[
        float | None,
        Option(
            help="Gap between printed surfaces that would touch: faces of polyhedra lie half of it deeper (≥ 0).",
            metavar="LENGTH",
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

    @property
    def mechanism(self) -> catalog.FileFormat | None:
        """The format of the output that holds masses on joints; None of others."""
        suffix = self.output.suffix.lower() if self.output is not None else ""
        return next((one for one in catalog.FILE_FORMATS if one.holds == "mechanism" and suffix in one.suffixes), None)

    def _mechanism_problems(self) -> list[Problem]:
        """That a density is missing where masses are written."""
        if self.mechanism is None or self.density is not None or self.material is not None:
            return []
        needed = f"{self.mechanism.name} holds masses; give a --material NAME, or a --density in kg/m³"
        return [Problem(f"{option_name('output')} {self.output}", needed)]

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

    @property
    def suffix(self) -> str:
        """Of the files in a folder."""
        return "." + (self.format or "stl").lower().removeprefix(".")

    def _format_problems(self) -> list[Problem]:
        """What is wrong with the format of files in a folder, and with a clearance in formats of smooth faces."""
        problems = []
        in_folder = self.output is not None and self.output != Path() and not self.output.suffix
        if self.format is not None and self.suffix not in written_suffixes():
            known = ", ".join(suffix[1:] for suffix in written_suffixes())
            problems.append(Problem(f"--format {self.format}", f"one of {known} is needed"))
        if self.format is not None and not in_folder:
            named = (
                f"--output {self.output} names a file, whose suffix is its format" if self.output else "none is named"
            )
            problems.append(
                Problem(f"--format {self.format}", f"applies to the files in a folder (-o FOLDER); {named}")
            )
        suffix = self.suffix if in_folder else self.output.suffix.lower() if self.output else ""
        if self.clearance and suffix in written_suffixes("smooth faces"):
            given = f"--clearance {self.clearance:g}"
            problems.append(Problem(given, f"moves faces of polyhedra, and a {suffix} file holds smooth ones; {_PLAY}"))
        return problems

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
        file = self.output if self.output is not None and self.output.suffix else None
        files = {
            "output": self.output,
            "picture": self.picture,
            "drawing": self.drawing,
            "sheet": self.sheet,
            "convergence": self.plot,
        }
        nameless = [name for name, path in files.items() if path == Path()]
        limited = {"density": DENSITY, "tolerance": TOLERANCE, "turn": TURN, "clearance": CLEARANCE}
        pairs_only = {"placed": self.placed, "turn": self.turn is not None}
        given = {name: getattr(self, name) is not None for name in ("tolerance", "clearance")}
        files_only = {"placed": self.placed, **given}
        writes = self.output is not None or self.picture is not None
        return [
            *unsound({name: (getattr(self, name), parameter) for name, parameter in limited.items()}),
            *self._material_problems(),
            *self._mechanism_problems(),
            *(Problem(option_name(name), "a name is needed") for name in nameless),
            *_wrong_suffix("output", file, written_suffixes()),
            *_one_file_twice({**files, "diagram": self.diagram}),
            *(_wrong_suffix("picture", self.picture, [".png"]) if "picture" not in nameless else []),
            *(_wrong_suffix("drawing", self.drawing, [".dxf", ".svg"]) if "drawing" not in nameless else []),
            *(
                [Problem("--drawing", f"a {kind.name} {_NOT_PLANE}")]
                if self.drawing is not None and not kind.plane
                else []
            ),
            *(_wrong_suffix("convergence", self.plot, [".png", ".svg"]) if "convergence" not in nameless else []),
            *self._format_problems(),
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

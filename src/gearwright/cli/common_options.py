"""Options common to several commands: what is written where, in which units, how finely."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from .. import catalog
from ..files.formats import written_suffixes
from .densities import DENSITY_HELP, MATERIAL_HELP, kilograms
from .options import OUTPUT


@dataclass(frozen=True, kw_only=True)
class Outputs:
    """Options common to all elements; whether they can be used is the question of `output_problems`."""

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
    step_schema: Annotated[
        str | None,
        Option(help="Schema of STEP files; some programs ask for AP242.", metavar="AP214|AP242", show_default="AP214"),
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
            help="How far written faces, and chords of pictures, may lie from the exact surface (> 0).",
            metavar="LENGTH",
            show_default="1e-4 × bounding diagonal; of STEP 5e-6 × module",
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

    @property
    def in_folder(self) -> bool:
        """Whether files are written to a folder."""
        return self.output is not None and self.output != Path() and not self.output.suffix

    @property
    def suffix(self) -> str:
        """Of the files in a folder."""
        return "." + (self.format or "stl").lower().removeprefix(".")


DEFAULT = Outputs()
FLATTENED = Annotated[Outputs, Option(name="*", group=OUTPUT)]
"""The options as a command's parameter: each on its own, not as one."""

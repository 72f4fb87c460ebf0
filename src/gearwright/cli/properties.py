"""`gearwright properties FILE…`: volumetric properties of closed polyhedra in files."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter as Option

from ..errors import FileError, GearwrightError
from ..solids.model import Model
from ..solids.properties import MassProperties
from .built import Units, units_and_density
from .common_options import DENSITY, DENSITY_HELP, require_sound
from .exits import DONE, report
from .json_output import json_line, properties_json
from .report import properties_note, properties_table, show


def properties(
    *files: Annotated[Path, Option(metavar="FILE", required=True, help="STL files, binary or text.")],
    json: Annotated[
        bool, Option(help="Print one line of JSON for each file.", negative=(), show_default=False)
    ] = False,
    density: Annotated[float | None, Option(help=DENSITY_HELP, metavar="KG/M³")] = None,
    length_unit: Annotated[
        Literal["mm", "in"] | None, Option(help="Unit of the lengths in files that state none.", show_default="mm")
    ] = None,
) -> int:
    """Volume, centroid and inertia of closed polyhedra.

    A file that cannot be used is named on stderr; the others are still done.
    """
    require_sound({"density": (density, DENSITY)})
    worst = DONE
    for file in files:
        try:
            model = Model.load(file)
            polyhedron = model.polyhedron
            units, kernel_density = units_and_density(_unit(file, model.length_unit, length_unit), density)
            found = polyhedron.properties(kernel_density)
            for remark in polyhedron.validity().remarks:
                print(f"note: {file}: {remark}", file=sys.stderr)
        except (GearwrightError, OSError) as error:
            worst = max(worst, report(error, "gearwright properties", subject=str(file)))
        else:
            _show(file, found, units, json)
    return worst


def _unit(file: Path, stated: str | None, asked: str | None) -> str:
    """The unit that the file states, else the one asked for, else mm. Raises FileError where they differ."""
    if stated and asked and stated != asked:
        raise FileError(f"{file}: it says itself that lengths are in {stated}, not {asked}; leave out --length-unit")
    return stated or asked or "mm"


def _show(file: Path, found: MassProperties, units: Units, json: bool) -> None:
    if json:
        sys.stdout.write(json_line({"file": str(file), **properties_json(found, units)}) + "\n")
    else:
        show(properties_table(str(file), [""], [found], units), properties_note(units))

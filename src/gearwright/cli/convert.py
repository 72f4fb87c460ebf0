"""`gearwright convert IN OUT`: bodies, drawings and designs into files of other formats."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter as Option

from ..designs.built import built_from
from ..errors import FileError, Problem, ProblemsError
from ..files.formats import FILE_FORMATS, written_suffixes
from ..parameters import LENGTH_UNITS, did_you_mean
from .build import designed
from .common_options import Outputs
from .exits import DONE
from .outputs import draw, progress, write

DESIGN, DRAWINGS, DRAWN = ".toml", (".dxf", ".svg", ".csv"), (".dxf", ".svg")
_PICTURES = (".png", ".jpg", ".jpeg", ".pdf")


def convert(
    source: Annotated[
        Path, Option(metavar="IN", help="A file of bodies, a drawing (.dxf, .svg, .csv) or a design (.toml).")
    ],
    target: Annotated[
        Path,
        Option(metavar="OUT", help="The file to write; its suffix is its format. It may be IN itself."),
    ],
    /,
    *,
    length_unit: Annotated[
        str | None,
        Option(help="Unit of the lengths in a file that states none.", metavar="|".join(LENGTH_UNITS)),
    ] = None,
) -> int:
    """Convert bodies, drawings and designs into files of other formats.

    Bodies become bodies, drawings drawings, and a design either, as by `gearwright build -o` or `--drawing`.
    Names, places and units are kept where the format has them; nothing is repaired, what is wrong is said.
    """
    if length_unit is not None and length_unit not in LENGTH_UNITS:
        wanted = f"choose one of {', '.join(LENGTH_UNITS)}{did_you_mean(length_unit, LENGTH_UNITS)}"
        raise ProblemsError("This cannot be converted", [Problem(f"--length-unit {length_unit}", wanted)])
    suffix = source.suffix.lower()
    if suffix == DESIGN:
        _from_design(source, target, length_unit)
    elif suffix in DRAWINGS:
        _from_drawing(source, target, length_unit)
    else:
        _from_bodies(source, target, length_unit)
    print(f"wrote {target}", file=sys.stderr)
    return DONE


def _from_bodies(source: Path, target: Path, length_unit: str | None) -> None:
    readable = [suffix for one in FILE_FORMATS if one.parser for suffix in one.suffixes]
    if source.suffix and source.suffix.lower() not in readable:
        known = f"bodies as {', '.join(readable)}, drawings as {', '.join(DRAWINGS)}, designs as {DESIGN}"
        raise FileError(f"{source}: a file whose name ends in {source.suffix} cannot be read; read are {known}")
    polygons = written_suffixes("polygons")
    _require(target, polygons, f"{source} is of bodies, which are converted to {', '.join(polygons)}")
    from ..solids import conversion

    with progress(f"converting {source}"):
        remarks = conversion.convert(source, target, length_unit=length_unit)
    for remark in remarks:
        print(f"note: {remark}", file=sys.stderr)


def _from_drawing(source: Path, target: Path, length_unit: str | None) -> None:
    way_out = "; `gearwright sweep --section` makes bodies of sections"
    _require(target, DRAWN, f"{source} is a drawing, which is converted to {', '.join(DRAWN)}{way_out}")
    from ..sections.drawings import Profile, read
    from ..sections.drawings import write as write_drawing
    from ..sections.plane import Section

    with progress(f"converting {source}"):
        drawing = read(source)
        stated = drawing.length_unit
        if stated and length_unit and stated != length_unit:
            raise FileError(f"{source}: it says itself that lengths are in {stated}, not {length_unit}")
        profiles = [Profile(section=Section(loops=region)) for region in drawing.regions]
        write_drawing(target, profiles, length_unit=stated or length_unit or "mm")
    if not (stated or length_unit):
        print(f"note: {source} states no unit of length; mm is taken", file=sys.stderr)
    for kind, count in drawing.passed_over.items():
        print(f"note: left out: {count} {kind}", file=sys.stderr)


def _from_design(source: Path, target: Path, length_unit: str | None) -> None:
    if length_unit is not None:
        problem = Problem(f"--length-unit {length_unit}", "a design states its own; set length_unit in it")
        raise ProblemsError(f"{source}: this cannot be converted", [problem])
    known = [*written_suffixes("polygons"), *written_suffixes("smooth faces"), *DRAWN]
    if target.suffix.lower() in written_suffixes("mechanism"):
        raise FileError(
            f"{target}: such files hold masses; gearwright build {source} -o {target} --material NAME writes them"
        )
    _require(target, known, f"{source} is a design, of which are made bodies and drawings: {', '.join(known)}")
    drawn = target.suffix.lower() in DRAWN
    outputs = Outputs(drawing=target) if drawn else Outputs(output=target)
    kind, element = designed(source, outputs)
    if drawn:
        draw(element, target)
    else:
        write(built_from(kind, element, None, 0.0), outputs, [])
    for remark in element.remarks:
        print(f"note: {remark}", file=sys.stderr)


def _require(target: Path, suffixes: list[str] | tuple[str, ...], known: str) -> None:
    """Raises FileError unless the target's name ends in one of these."""
    suffix = target.suffix.lower()
    if suffix in suffixes:
        return
    if target.is_dir():
        raise FileError(f"{target}: this is a folder; name a file in it, with a suffix; {known}")
    holds = next((form.holds for form in FILE_FORMATS if suffix in form.suffixes), "polygons")
    if holds == "smooth faces":
        why = "it holds smooth faces, and bodies are read as polygons, those of STEP files, too"
    elif holds == "mechanism":
        why = "it knows nothing of masses and joints; such files are written from a design, with a --material"
    elif suffix in _PICTURES:
        why = "pictures are drawn by --picture of the commands that build"
    else:
        why = f"a file whose name ends in {suffix or 'no suffix'} cannot be written from it"
    raise FileError(f"{target}: {why}; {known}")

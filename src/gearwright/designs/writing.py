"""Files of a design: written into a folder as a request asks, with what is done told as it goes."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from ..elements.assembly import PlacedPart, placed_parts, save_parts
from ..elements.sheets import SheetLabels
from ..files.formats import written_suffixes
from .design import Design, design_of
from .file_problems import file_problems
from .members import members, placements
from .requested import Requested, requested
from .texts import texts

_SHOWING = {"drawing": "-section", "sheet": "-sheet"}
"""What names of files say, where the suffix does not."""


def written(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """{"stage"} again and again, at last {"file", "name"}: where it is, and what it is to be called.

    request   "design" and "suffix", "what" ("body", "drawing", "sheet", "design"), "folder" (an empty one); optional
              "tolerance", "clearance", "placed", "separate" (one file a member), "density", "material",
              "step_schema", "paper"

    Several files become one zip. Raises ProblemsError, GeometryError, FileError, MachineError.
    """
    yield {"stage": "building"}
    suffix, what, folder = request["suffix"], request["what"], Path(request["folder"])
    design = design_of(request["design"])
    found = requested(request, file_problems(request, design.kind))
    name = f"{stem(design)}{_SHOWING.get(what, '')}{suffix}"
    yield {"stage": f"writing {name}"}
    home = folder / "files"
    home.mkdir()
    match what:
        case "body":
            _write_body(found, request, home / name)
        case "drawing":
            found.element.save_drawing(home / name)
        case "sheet":
            _write_sheet(found, request, home / name)
        case "design":
            (home / name).write_text(texts(design)["toml"], encoding="utf-8")
    files = sorted(path for path in home.rglob("*") if path.is_file())
    if len(files) == 1:
        yield {"file": str(files[0]), "name": files[0].name}
        return
    yield {"stage": f"packing {len(files)} files"}
    packed = folder / f"{stem(design)}-{suffix[1:]}.zip"
    with zipfile.ZipFile(packed, "w", compression=zipfile.ZIP_DEFLATED) as archive:
        for path in files:
            archive.write(path, path.relative_to(home))
            path.unlink()
    yield {"file": str(packed), "name": packed.name}


def stem(design: Design) -> str:
    """What files of a design are called: "spur-16-40"."""
    teeth = design.values.get("teeth")
    numbers = teeth if isinstance(teeth, list | tuple) else [teeth]
    return "-".join([design.kind.command, *(str(z) for z in numbers if isinstance(z, int))])


def _write_body(found: Requested, request: Mapping[str, Any], path: Path) -> None:
    """Faces, smooth or plane, or bodies on joints."""
    tolerance, clearance = request.get("tolerance"), request.get("clearance") or 0.0
    schema = request.get("step_schema")
    if request.get("separate"):
        parts = _parts(found, tolerance, clearance)
        placed = bool(request.get("placed"))
        save_parts(parts, path.parent, found.element.length_unit, suffix=path.suffix, placed=placed, step_schema=schema)
        return
    if path.suffix in written_suffixes("mechanism"):
        found.element.save(path, tolerance, density=found.kilograms)
    else:
        save_parts(_parts(found, tolerance, clearance), path, found.element.length_unit, step_schema=schema)


def _parts(found: Requested, tolerance: float | None, clearance: float) -> list[PlacedPart]:
    kind, element = found.design.kind, found.element
    return placed_parts(members(kind, element), placements(kind, element), tolerance, clearance)


def _write_sheet(found: Requested, request: Mapping[str, Any], path: Path) -> None:
    labels = SheetLabels(
        paper=request.get("paper") or "A3", material=request.get("material"), density=request.get("density")
    )
    found.element.save_sheet(path, labels)

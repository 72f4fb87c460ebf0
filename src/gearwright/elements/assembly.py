"""Parts where they stand: written together or apart, and drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from ..arrays import Array
from ..disk import folder
from ..solids.polyhedron import Polyhedron


@dataclass(frozen=True, kw_only=True)
class PlacedPart:
    """A part's polyhedron in its own frame, and the rigid motion (4, 4) that puts it in place.

    name    what its file is called
    label   what stands beside it in a picture
    upward  which way the axis, z, points when the part is drawn alone, so that its teeth are seen
    """

    name: str
    label: str
    polyhedron: Polyhedron
    placement: Array
    upward: Literal[1, -1] = 1

    @property
    def placed(self) -> Polyhedron:
        return self.polyhedron.transformed(self.placement)


def save_parts(parts: Sequence[PlacedPart], path: Path, length_unit: str, *, placed: bool = False) -> list[Path]:
    """Writes all parts in place to one file, if the path has a suffix, else each to a file in a folder.

    placed   in a folder, too, each part is written where it stands, and not in its own frame

    Gives the files written. Raises FileError, MachineError.
    """
    if path.suffix:
        folder(path.parent)
        _together([part.placed for part in parts]).save(path, length_unit=length_unit)
        return [path]
    files = [folder(path) / f"{part.name.replace(' ', '-')}.stl" for part in parts]
    for part, file in zip(parts, files, strict=True):
        (part.placed if placed else part.polyhedron).save(file, length_unit=length_unit)
    return files


def draw_parts(parts: Sequence[PlacedPart], path: Path, title: str, length_unit: str) -> None:
    """Draws all parts in place into a PNG file. Raises FileError, MachineError."""
    from ..pictures import BRASS, STEEL, Body, View, picture  # matplotlib and numba load only to draw

    bodies = [
        Body(vertices=body.vertices, triangles=body.triangles(), colour=(BRASS, STEEL)[i % 2], label=part.label)
        for i, part in enumerate(parts)
        for body in [part.placed]
    ]
    folder(path.parent)
    up = float(parts[0].upward)
    alone = View(direction=(0.35, 0.8, 0.75 * up), up=(0.0, 0.0, up)) if len(parts) == 1 else None
    picture(bodies, path, title=title, view=alone, length_unit=length_unit)


def _together(polyhedra: Sequence[Polyhedron]) -> Polyhedron:
    """Several polyhedra of triangles as one of several components."""
    if len(polyhedra) == 1:
        return polyhedra[0]
    starts = np.cumsum([0, *(len(one.vertices) for one in polyhedra[:-1])])
    triangles = [one.triangles() + start for one, start in zip(polyhedra, starts, strict=True)]
    return Polyhedron(np.concatenate([one.vertices for one in polyhedra]), np.concatenate(triangles))

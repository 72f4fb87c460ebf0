"""Drawings of sections written: profiles on a sheet become a DXF or SVG file, whole or not at all."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from ... import disk
from ...arrays import Array
from ...errors import FileError, GeometryError, Problem
from ...parameters import LENGTH_UNITS, MILLIMETRES
from . import dxf_writing, svg_writing
from .contours import Contour, Profile, contours
from .strokes import Hand

TOLERANCE = 1e-7
"""Distance of splines from the curves they stand for, where the format does not hold these; of the section's size."""

FINEST, COARSEST = 1e-9, 1e-2
"""Tolerances, of the section's size. Next to the cusp of an involute, pieces of a spline to a finer one are shorter
than the gaps that programs close (5e-6 of the drawing), and would be lost where it is read."""

_Encoder = Callable[[str, Mapping[str, Sequence[Contour]], Array, str], bytes]

_WRITERS: Mapping[str, tuple[Hand, _Encoder]] = {
    ".dxf": (dxf_writing.HAND, dxf_writing.encoded),
    ".svg": (svg_writing.HAND, svg_writing.encoded),
}

WRITTEN = tuple(_WRITERS)
"""Suffixes of the drawings that are written."""


def write(
    path: str | Path, profiles: Sequence[Profile], *, length_unit: str = "mm", tolerance: float | None = None
) -> None:
    """Writes profiles, each on its own layer, into a DXF or SVG file, as the suffix says.

    length_unit   of all coordinates; the file states mm or inches, to which others are converted
    tolerance     largest distance (a length) of splines from curves that are no lines, arcs, ellipses or splines
                  themselves; default 1e-7 × the size of the section

    Raises FileError where the name is not such a file's; GeometryError for a unit or a tolerance that cannot be, or
    loops that cross; MachineError where the disk does not take it or the writer is not installed.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in _WRITERS:
        raise FileError(f"{path}: sections are drawn as {', '.join(_WRITERS)}; end the name in one of these")
    _require(profiles, length_unit, tolerance)
    hand, encoded = _WRITERS[suffix]
    layers: dict[str, list[Contour]] = {}
    for profile in profiles:
        profile.section.require_simple()
        within = TOLERANCE * profile.section.size if tolerance is None else tolerance
        layers.setdefault(profile.layer, []).extend(contours(profile, within, hand))
    stated = {"ft": "in"}.get(length_unit, length_unit if length_unit in MILLIMETRES else "mm")
    if stated != length_unit:
        factor = LENGTH_UNITS[length_unit] / LENGTH_UNITS[stated]
        layers = {
            layer: [tuple(one.scaled(factor) for one in contour) for contour in drawn]
            for layer, drawn in layers.items()
        }
    points = np.concatenate([one.samples() for drawn in layers.values() for contour in drawn for one in contour])
    data = encoded(f"{path}", layers, np.array([points.min(axis=0), points.max(axis=0)]), stated)
    with disk.written_whole(path) as stream:
        stream.write(data)


def _require(profiles: Sequence[Profile], length_unit: str, tolerance: float | None) -> None:
    problems = [] if profiles else [Problem("0 profiles", "at least one is needed")]
    if length_unit not in LENGTH_UNITS:
        problems.append(Problem(f"length_unit = {length_unit!r}", f"choose one of {', '.join(LENGTH_UNITS)}"))
    sizes = [profile.section.size for profile in profiles] if tolerance is not None else []
    least, most = FINEST * max(sizes, default=0.0), COARSEST * min(sizes, default=math.inf)
    if sizes and not least <= float(tolerance or 0.0) <= most:
        wanted = (
            f"a length from {least:.2g} to {most:.2g} {length_unit} is needed, {FINEST:g} to {COARSEST:g} of the size"
        )
        problems.append(Problem(f"tolerance = {tolerance!r}", wanted))
    if problems:
        raise GeometryError("The section cannot be drawn", problems)

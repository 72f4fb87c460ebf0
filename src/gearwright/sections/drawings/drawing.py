"""Drawings of sections: files in, closed loops out, outer ones told from holes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ... import disk
from ...arrays import Array, ArrayLike
from ...errors import FileError, GeometryError, Problem
from ..loop import Loop
from . import csv_points, dxf, svg
from .chains import closed_chains, joint_tolerance, long_enough
from .joints import fitted
from .listing import first_few, place
from .nesting import Chain, described, innermost, regions
from .sheet import Sheet

LARGEST_FILE = 32 << 20
"""Bytes: fifty times a large drawing of a section, and half a minute's reading."""

_READERS: Mapping[str, Callable[[str, bytes, str | None], Sheet]] = {
    ".dxf": dxf.read,
    ".svg": svg.read,
    ".csv": csv_points.read,
}


@dataclass(frozen=True, kw_only=True)
class Drawing:
    """What a drawing's file holds.

    source        the file's name, for messages
    regions       loops of each region: the outer one first and counter-clockwise, its holes clockwise
    passed_over   how many things of each kind are no outline and were not read: texts, dimensions, points
    length_unit   of the coordinates, such as "mm" or "in"; None where the file states none
    layers        names of the layers that hold curves
    """

    source: str
    regions: tuple[tuple[Loop, ...], ...]
    passed_over: Mapping[str, int]
    length_unit: str | None
    layers: tuple[str, ...] = ()

    def region(self, around: ArrayLike | None = None) -> tuple[Loop, ...]:
        """The loops of the one region, or of the smallest whose outer loop goes around a point (x, y).

        Raises GeometryError naming all regions, where there are several and none or a wrong point is given.
        """
        if around is None:
            if len(self.regions) == 1:
                return self.regions[0]
            layers = f", or one layer as layer= ({', '.join(self.layers)})" if len(self.layers) > 1 else ""
            way_out = f"; to take one, give a point in it as around=(x, y){layers}"
            raise self._refusal(f"{self.source} holds {len(self.regions)} regions; a section is one{way_out}")
        point = _point(around)
        number = innermost(self._chains, point)
        if number is None:
            raise self._refusal(f"{self.source} has no region around {place(point)}")
        return self.regions[number]

    @property
    def _chains(self) -> list[tuple[Chain, ...]]:
        return [tuple(loop.curves for loop in region) for region in self.regions]

    def _refusal(self, headline: str) -> GeometryError:
        listed = [Problem(f"region {i + 1}", described(chains)) for i, chains in enumerate(self._chains)]
        return GeometryError(headline, first_few(listed))


def read(path: str | Path, *, layer: str | None = None) -> Drawing:
    """The regions of a drawing: DXF (.dxf), SVG (.svg) or points (.csv).

    layer   the one layer to read, where the format has any; None reads all that are not hidden

    Coordinates are the drawing's own; in SVG, of the unit its width states, and y points up.
    Raises FileError where the file is not what its name says, has no such layer or no curves;
    GeometryError naming every place where the curves do not form closed loops, or the loops no region;
    MachineError where the disk does not give the file or a reader is not installed.
    """
    source, suffix = f"{path}", Path(path).suffix.lower()
    if suffix not in _READERS:
        raise FileError(f"{source}: sections are read from {', '.join(_READERS)}; end the name in one of these")
    with np.errstate(all="ignore"):  # what overflows is no number, which the joining of curves refuses
        sheet = _READERS[suffix](source, _contents(path), layer)
    passed = ", ".join(f"{count} {kind}" for kind, count in sheet.passed_over.items())
    if not sheet.curves:
        raise FileError(f"{source}: there are no curves in it" + (f"; passed over: {passed}" if passed else ""))
    try:
        found, dropped = _regions(sheet)
    except GeometryError as error:
        raise GeometryError(f"{source}: {error.headline}", error.problems) from None
    except ValueError as error:
        raise FileError(f"{source}: {error}; draw the section again, or check what exported it") from None
    return Drawing(
        source=source,
        regions=tuple(tuple(Loop(curves=chain) for chain in region) for region in found),
        passed_over=dict(sheet.passed_over) | ({"curve shorter than a joint": dropped} if dropped else {}),
        length_unit=sheet.length_unit,
        layers=sheet.layers,
    )


def _point(around: ArrayLike) -> Array:
    try:
        point = np.asarray(around, float)
    except (TypeError, ValueError):
        point = np.empty(0)
    if point.shape != (2,) or not np.all(np.isfinite(point)):
        problem = Problem(f"around = {around!r}", "two finite coordinates x, y are needed")
        raise GeometryError("This is no place in a drawing", [problem])
    return point


def _regions(sheet: Sheet) -> tuple[tuple[tuple[Chain, ...], ...], int]:
    """The regions, and how many curves are too short to be told from a point."""
    tolerance = joint_tolerance(sheet.curves)
    curves = long_enough(sheet.curves, tolerance)
    if not curves:
        raise ValueError("all its curves end where they start")
    chains = [fitted(chain) for chain in closed_chains(curves, tolerance)]
    return regions(chains, tolerance), len(sheet.curves) - len(curves)


def _contents(path: str | Path) -> bytes:
    with disk.opened(path) as stream:
        data = stream.read(LARGEST_FILE + 1)
    if len(data) > LARGEST_FILE:
        raise FileError(f"{path}: larger than {LARGEST_FILE >> 20} MB, which no section's outline is; export it alone")
    if not data.strip(b"\0\t\r\n "):
        raise FileError(f"{path}: the file is empty; write it again")
    return data

"""Polygons as text: a line of x and y a corner, an empty line between loops."""

from __future__ import annotations

from ...curves.curve import Curve
from ...curves.line import lines_through
from ...errors import FileError
from ...point_lists import point_runs
from .sheet import MOST_CURVES, Sheet


def read(source: str, data: bytes, layer: str | None) -> Sheet:
    """The sides of the polygons, one a run of lines; the last corner may repeat the first one. Raises FileError."""
    if layer is not None:
        raise FileError(f"{source}: a list of points has no layers; leave out layer={layer!r}")
    curves: list[Curve] = []
    for first_line, corners in point_runs(source, data, what="a corner", names="x, y", most=MOST_CURVES):
        closed = corners if corners[0] == corners[-1] else [*corners, corners[0]]
        if len(set(closed)) < 3:
            raise FileError(
                f"{source}: line {first_line}: a loop of {len(set(closed))} different corners; at least 3 are needed, "
                "and an empty line ends a loop"
            )
        curves += lines_through(closed)
    return Sheet(curves=tuple(curves), passed_over={})

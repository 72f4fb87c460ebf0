"""Paths in space from files of points."""

from __future__ import annotations

from pathlib import Path as FilePath

from ..disk import contents
from ..errors import FileError, GeometryError
from ..point_lists import point_runs
from .path import Path, path_through

_MOST_LINES = 100_000


def path_from_file(path: str | FilePath) -> Path:
    """The cubic spline through the points of a CSV file; closed where the last point is the first again.

    A point is a line "x, y, z" (`point_lists`). Raises FileError naming the lines that are not so; GeometryError where
    there is no smooth path through the points; MachineError where the file cannot be read.
    """
    if FilePath(path).suffix.lower() != ".csv":
        raise FileError(f"{path}: a path is read from a .csv file of lines x, y, z")
    runs = point_runs(str(path), contents(path), what="a point of the path", names="x, y, z", most=_MOST_LINES)
    points = [point for _, run in runs for point in run]
    if len(points) < 2:
        raise FileError(f"{path}: it holds {len(points)} points; a path needs at least two, a line x, y, z for each")
    try:
        return path_through(points)
    except GeometryError as error:
        raise GeometryError(f"{path}: no path leads through these points", error.problems) from None

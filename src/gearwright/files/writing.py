"""Assemblies to files, each in the format of its name's suffix."""

from __future__ import annotations

from pathlib import Path

from ..errors import FileError
from ..sources import load
from .assembly import Assembly, Faceted
from .formats import FILE_FORMATS, format_of


def save_polygons(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes bodies bounded by polygons, whole or not at all.

    Raises FileError, also for a format of smooth faces; MachineError; GeometryError where the format needs triangles
    that a face cannot be cut into.
    """
    format_ = format_of(path, "written")
    if format_.holds == "mechanism":
        raise FileError(
            f"{path}: {format_.name} holds bodies with masses on joints, and polygons alone are given; elements, pairs"
            f' and solids are written so with a density: save("{Path(path).name}", density="steel")'
        )
    if format_.holds != "polygons":
        others = [suffix for one in FILE_FORMATS if one.writer and one.holds == "polygons" for suffix in one.suffixes]
        raise FileError(
            f"{path}: {format_.name} holds smooth faces, and polygons are given; a solid that was built here can be"
            f" written so, polygons as {', '.join(others)}"
        )
    load(format_.writer or "")(path, assembly)

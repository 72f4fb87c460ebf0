"""Assemblies to files, each in the format of its name's suffix."""

from __future__ import annotations

from pathlib import Path

from ..errors import FileError, GeometryError
from ..sources import load
from .assembly import Assembly, Faceted
from .formats import format_of, written_suffixes


def save_polygons(path: str | Path, assembly: Assembly[Faceted]) -> None:
    """Writes bodies bounded by polygons, whole or not at all.

    Raises FileError, also for a format of smooth faces and a part without faces; MachineError; GeometryError where the
    format needs triangles that a face cannot be cut into.
    """
    format_ = format_of(path, "written")
    if format_.holds == "mechanism":
        raise FileError(
            f"{path}: {format_.name} holds bodies with masses on joints, and polygons alone are given; elements, pairs"
            f' and solids are written so with a density: save("{Path(path).name}", density="steel")'
        )
    if format_.holds != "polygons":
        raise FileError(
            f"{path}: {format_.name} holds smooth faces, and polygons are given; a solid that was built here can be"
            f" written so, polygons as {', '.join(written_suffixes('polygons'))}"
        )
    bare = [part.name for part in assembly.parts if len(part.shape.offsets) < 2]
    if bare:
        raise FileError(f"{path}: a file of bodies holds faces, and {', '.join(bare)} has none; leave it out")
    try:
        load(format_.writer or "")(path, assembly)
    except GeometryError as error:
        headline = f"{path}: {format_.name} holds triangles; .obj, .off and .ply hold any polygons"
        raise GeometryError(headline, error.problems) from error

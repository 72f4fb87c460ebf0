"""Files of bodies converted into other formats."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from ..errors import FileError
from ..files.formats import FileFormat, format_of, written_suffixes
from .model import Model

_UPRIGHT = np.array([[1.0, 0, 0, 0], [0, 0, -1.0, 0], [0, 1.0, 0, 0], [0, 0, 0, 1.0]])
"""What turns a body with y up so that z is: y becomes z, z becomes −y."""


def convert(source: str | Path, target: str | Path, *, length_unit: str | None = None) -> tuple[str, ...]:
    """Writes the bodies of a file into another, each in the format of its suffix; the target whole or not at all.

    length_unit   a key of LENGTH_UNITS for a source that states none; None for mm, where the target states one

    Names and places of bodies stay; lengths are converted where the target has a unit of its own. Bodies with y up
    (glTF) are turned, so that z is up where that is usual, and the other way round. Nothing is repaired.
    Gives remarks: what was not kept, and what is wrong with the bodies. Raises FileError, also for a target of smooth
    faces, and for a unit where the source states another; MachineError; GeometryError where the target holds
    triangles and a face cannot be cut into such.
    """
    wanted = format_of(target, "written")
    if wanted.holds == "mechanism":
        raise FileError(
            f"{target}: {wanted.name} holds masses on joints, and {source} knows of none; write it from a design or"
            " by the command that builds the part, with a --material"
        )
    if wanted.holds != "polygons":
        raise FileError(
            f"{target}: {wanted.name} holds smooth faces, and {source} is read as polygons, which are none; convert it"
            f" to {', '.join(written_suffixes('polygons'))}, or build the part anew, from its design or by its command"
        )
    model = Model.load(source)
    given = format_of(source, "read")
    if length_unit and model.length_unit and length_unit != model.length_unit:
        raise FileError(f"{source}: it says itself that lengths are in {model.length_unit}, not {length_unit}")
    remarks = [*model.remarks, *_problems(model)]
    unit = model.length_unit or length_unit
    if unit is None and wanted.has_unit:
        unit = "mm"
        remarks.append(f"{source} states no unit of length; mm is taken")
    if given.up != wanted.up and given.up == "y":
        remarks.append(f"{source} has y up; turned, so that z is up")
    if len(model.bodies) > 1 and not wanted.bodies:
        remarks.append(f"its {len(model.bodies)} bodies are one in {target}: {wanted.name} has no names for them")
    with_z_up(model, given).save(target, length_unit=unit)
    return tuple(remarks)


def with_z_up(model: Model, given: FileFormat) -> Model:
    """The bodies of a file of some format, turned so that z is up."""
    if given.up == "z":
        return model
    return replace(model, bodies={name: body.transformed(_UPRIGHT) for name, body in model.bodies.items()}, smooth={})


def _problems(model: Model) -> list[str]:
    """What keeps the bodies from bounding solids, in words."""
    sound = model.sound
    found = [problem for body in sound.bodies.values() for problem in body.validity().problems]
    return [*sound.remarks[len(model.remarks) :], *(f"as it was given, unmended: {problem}" for problem in found)]

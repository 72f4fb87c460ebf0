"""Solids to files for simulators: as links with their true mass and inertia, on joints or free."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..errors import FileError
from ..files.formats import format_of, written_suffixes
from ..files.robots.mechanism import Joint, Link, Mechanism
from ..materials import density as kernel_density
from ..parameters import LENGTH_UNITS
from ..sources import load
from .inertial import inertial_of
from .saving import PlacedSolid, refuse_clearance, refuse_schema

LONE = "part"
"""A link that is alone: simulators keep some names to themselves, and file names are free."""


def mechanism_of(
    name: str, solids: Sequence[PlacedSolid], density: str | float, length_unit: str, joints: Sequence[Joint] = ()
) -> Mechanism:
    """Solids where they stand, all of one material.

    density   the name of a material, or kg/m³
    joints    in SI, by the names of the solids; their values are 0 where the solids stand

    A single one is called LONE, whatever its own name. Raises ParameterError for a density or unit that is none;
    GeometryError where a tolerance cannot be met or no body can have such properties.
    """
    own_density = kernel_density(density, length_unit=length_unit)
    names = [LONE] if len(solids) == 1 else [solid.name for solid in solids]
    links = tuple(_link(link, solid, own_density, length_unit) for link, solid in zip(names, solids, strict=True))
    return Mechanism(name=name, links=links, joints=tuple(joints))


def save_mechanism(path: str | Path, mechanism: Mechanism) -> list[Path]:
    """Writes the file and the meshes beside it, all or none, and gives their paths. Raises FileError, MachineError."""
    files: list[Path] = load(format_of(path, "written").writer or "")(path, mechanism)
    return files


def density_for(
    path: str | Path, density: str | float | None, *, clearance: float, step_schema: str | None
) -> str | float | None:
    """The density where a file of this name holds masses, else None.

    Raises FileError unless one is given just where it is needed, and for what such files have no place for.
    """
    format_ = format_of(path, "written")
    if format_.holds != "mechanism":
        refuse_density(path, density)
        return None
    if density is None:
        raise FileError(
            f'{path}: {format_.name} holds masses; give a density: the name of a material, as "steel", or kg/m³'
        )
    refuse_clearance(path, clearance)
    refuse_schema(path, step_schema)
    return density


def refuse_density(path: str | Path, density: object) -> None:
    """Raises FileError where a density is given, for files that hold no masses."""
    if density is not None:
        raise FileError(
            f"{path}: density = {density!r} has no place in such files, which hold shapes alone; leave it out, or write"
            f" {', '.join(written_suffixes('mechanism'))}"
        )


def _link(name: str, solid: PlacedSolid, density: float, length_unit: str) -> Link:
    metres = LENGTH_UNITS[length_unit] / 1e3
    placement = np.array(solid.placement)
    placement[:3, 3] *= metres
    return Link(
        name=name,
        inertial=inertial_of(name, solid.solid.properties(density), length_unit),
        shape=solid.polyhedron.transformed(np.diag([metres, metres, metres, 1.0])),
        placement=placement,
        colour=solid.colour,
    )

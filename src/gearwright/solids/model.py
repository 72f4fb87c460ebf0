"""The bodies of a file, apart and together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from ..files import formats
from ..files.contents import Body, Contents
from ..moments.faces import Corners
from .polyhedron import Polyhedron


@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """Bodies by name, in the order of their file, and the unit of its lengths.

    bodies        names are made different by a number where several have one, "body 1" where they have none
    length_unit   a key of LENGTH_UNITS; None where the file states none
    remarks       what was read in some way a reader should know of, in words
    """

    bodies: Mapping[str, Polyhedron]
    length_unit: str | None = None
    remarks: tuple[str, ...] = ()

    @classmethod
    def load(cls, path: str | Path) -> Model:
        """From a file in the format of its suffix. Raises FileError, MachineError."""
        return cls._of(formats.read(path))

    @classmethod
    def _of(cls, contents: Contents) -> Model:
        bodies = {name: _polyhedron(body) for name, body in _named(contents.bodies).items()}
        return cls(bodies=bodies, length_unit=contents.length_unit, remarks=contents.remarks)

    @cached_property
    def polyhedron(self) -> Polyhedron:
        """All bodies as one."""
        return Polyhedron.united(self.bodies.values())


def _named(bodies: tuple[Body, ...]) -> dict[str, Body]:
    result: dict[str, Body] = {}
    for number, body in enumerate(bodies, start=1):
        name = body.name or f"body {number}"
        while name in result:
            name = f"{name} ({number})"
        result[name] = body
    return result


def _polyhedron(body: Body) -> Polyhedron:
    return Polyhedron(body.vertices, Corners(body.indices, body.offsets), rounding=body.rounding)

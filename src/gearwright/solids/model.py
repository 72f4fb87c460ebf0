"""The bodies of a file, apart and together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from ..files import reading
from ..files.assembly import Assembly, Part
from ..files.contents import Body, Contents, SmoothProperties
from ..files.welding import welded
from ..files.writing import save_polygons
from ..moments.faces import Corners
from .polyhedron import Polyhedron


@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """Bodies by name, in the order of their file, and the unit of its lengths.

    bodies        names are made different by a number where several have one, "body 1" where they have none
    smooth        properties of the smooth shapes of which some bodies are polyhedra, by name: of a STEP file's
    length_unit   a key of LENGTH_UNITS; None where the file states none
    remarks       what was read in some way a reader should know of, in words
    """

    bodies: Mapping[str, Polyhedron]
    smooth: Mapping[str, SmoothProperties] = field(default_factory=dict)
    length_unit: str | None = None
    remarks: tuple[str, ...] = ()

    @classmethod
    def load(cls, path: str | Path) -> Model:
        """From a file in the format of its suffix. Raises FileError, MachineError."""
        return cls.of(reading.read(path))

    @classmethod
    def of(cls, contents: Contents) -> Model:
        """From what a file holds. Raises GeometryError if its faces are none."""
        named = _named(contents.bodies)
        return cls(
            bodies={name: _polyhedron(body) for name, body in named.items()},
            smooth={name: body.smooth for name, body in named.items() if body.smooth is not None},
            length_unit=contents.length_unit,
            remarks=contents.remarks,
        )

    def save(self, path: str | Path, *, length_unit: str | None = None) -> None:
        """Writes the bodies by their names to a file in the format of its suffix, whole or not at all.

        length_unit   of files that state none; None for that of the model

        Raises FileError, also where the format holds smooth faces, or a unit that nobody knows; MachineError;
        GeometryError if a face cannot be cut into triangles where the format needs it.
        """
        parts = tuple(Part(name=name, shape=body) for name, body in self.bodies.items())
        unit = self.length_unit or length_unit
        save_polygons(path, Assembly(name=Path(path).stem, parts=parts, length_unit=unit))

    @cached_property
    def polyhedron(self) -> Polyhedron:
        """All bodies as one."""
        return Polyhedron.united(self.bodies.values())

    @cached_property
    def sound(self) -> Model:
        """The bodies as they bound solids: pieces of one boundary as one body, with remarks.

        Where a body does not close, its corners at equal coordinates are joined, if that closes it: programs write
        corners anew for every face. Where some still bound no solid, but all together do, as patches and voids that
        are bodies of their own, they are one body. What bounds no solid even so stays as it stands.
        """
        amiss = {name: body for name, body in self.bodies.items() if not body.validity().valid}
        joined = {name: _joined(body) for name, body in amiss.items() if not body.validity().closed}
        mended = {name: body for name, body in joined.items() if body.validity().valid}
        if len(mended) < len(amiss) and len(self.bodies) > 1:
            for whole in (self.polyhedron, _joined(self.polyhedron)):
                if whole.validity().valid:
                    remark = f"its {len(self.bodies)} bodies bound a solid only together and are taken as one"
                    one = {", ".join(self.bodies): whole}
                    return replace(self, bodies=one, smooth={}, remarks=(*self.remarks, remark))
        remarks = (f"{name} closes only with its corners at equal coordinates joined" for name in mended)
        return replace(self, bodies={**self.bodies, **mended}, remarks=(*self.remarks, *remarks)) if mended else self


def _joined(body: Polyhedron) -> Polyhedron:
    points, numbers = welded(body.vertices)
    return Polyhedron(points, Corners(numbers[body.indices], body.offsets), rounding=body.rounding)


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

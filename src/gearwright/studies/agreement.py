"""Whether a file still is the design it was made from: every body against the part it is meant for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ..arrays import Array, numbers_in
from ..elements.element import Element
from ..elements.face_words import face_names
from ..elements.pair import Pair
from ..errors import ParameterError, Problem
from ..files.formats import format_of
from ..parameters import LENGTH_UNITS
from ..solids.comparison import Comparison, Given, Wanted, compared
from ..solids.conversion import with_z_up
from ..solids.model import Model
from ..solids.polyhedron import Polyhedron

_SAME_VOLUME = 0.01  # relative: with another unit the volume would be the design's
_ALIKE = 1e-6  # of the diagonal: places that a body fits as well as each other


@dataclass(frozen=True, kw_only=True, eq=False)
class PartAgreement:
    """One body and the part it was compared with.

    body         its name
    member       "pinion" or "gear" of a pair, "" of a single part
    in_mesh      whether it stands where the pair meshes at turn 0; else in the part's own frame
    comparison   lengths in the design's unit, points where they are in the file
    """

    body: str
    member: str
    in_mesh: bool
    comparison: Comparison

    @property
    def place(self) -> str:
        """As what it was taken, in words."""
        return f"the {self.member}, {'in mesh' if self.in_mesh else 'in its own frame'}" if self.member else "the part"


@dataclass(frozen=True, kw_only=True, eq=False)
class Agreement:
    """Whether bodies are a design's parts.

    parts         what was compared
    others        problems of the whole, in words: bodies too many, a unit that looks wrong
    remarks       what was assumed
    length_unit   of the design
    """

    parts: tuple[PartAgreement, ...]
    others: tuple[str, ...]
    remarks: tuple[str, ...]
    length_unit: str

    @cached_property
    def problems(self) -> tuple[str, ...]:
        """What is beyond the limits, in words."""
        several = len(self.parts) > 1
        found = (
            f"{part.body}: {problem}" if several else problem
            for part in self.parts
            for problem in part.comparison.problems(self.length_unit)
        )
        return (*self.others, *found)

    @property
    def passed(self) -> bool:
        return not self.problems

    def to_dict(self) -> dict[str, Any]:
        """Plain values by name."""
        parts = [
            {"body": part.body, "member": part.member or None, "in_mesh": part.in_mesh, **part.comparison.to_dict()}
            for part in self.parts
        ]
        head = {"passed": self.passed, "length_unit": self.length_unit, "problems": list(self.problems)}
        return {**head, "remarks": list(self.remarks), "parts": parts}

    def __str__(self) -> str:
        lines = [line for part in self.parts for line in _lines(part, self.length_unit)]
        lines += [f"problem: {problem}" for problem in self.problems]
        return "\n".join([*lines, *(f"remark: {remark}" for remark in self.remarks)])


def _lines(part: PartAgreement, unit: str) -> Iterator[str]:
    found = part.comparison
    far = found.deviation
    verdict = "the design" if found.passed else "not the design"
    yield f"against {part.place}: {verdict} to within {found.within:.3g} {unit}"
    yield (
        f"surface {far.inward.distance:+.3g} to {far.outward.distance:+.3g} {unit} off the design's, rms {far.rms:.3g},"
        f" at {far.points} points; the design's up to {far.lacking.distance:.3g} {unit} away from it"
    )
    if found.volume is not None and found.centroid_difference is not None and found.inertia_difference is not None:
        volume = found.volume / found.exact_volume - 1.0
        centroid = float(np.linalg.norm(found.centroid_difference))
        inertia = float(np.max(np.abs(found.inertia_difference))) / found.inertia_scale
        yield f"volume {volume:+.3g}, centroid off by {centroid:.3g} {unit}, central inertia off by {inertia:.3g}"


def compare(body: str | Path | Model | Polyhedron, design: Element | Pair, *, within: float | None = None) -> Agreement:
    """Compares a file's bodies, or a polyhedron, with the exact surface, volume, centroid and inertia of a design.

    body     a file of any format that is read; lengths are converted from its unit, and are the design's where it
             states none, as those of a polyhedron
    within   (length, the design's unit) the largest deviation that passes, by default 1e-4 × the part's bounding
             diagonal, as polyhedra are made with, and half a last digit of the file's coordinates

    A part is expected in its own frame; bodies of a pair there or in mesh at turn 0, each as the member it fits best.
    Nothing is moved or mended: a design that stands elsewhere does not pass, and is told by which motion.
    Raises FileError, MachineError; GeometryError if a face cannot be cut into triangles; ParameterError for a limit
    that is no positive length.
    """
    if within is not None:
        (number,) = numbers_in(within) or [np.nan]
        if not number > 0.0:
            wanted = f"a positive length is needed, in {design.length_unit}"
            raise ParameterError("Comparison", [Problem(f"within = {within!r}", wanted)])
    model, remarks, others = _in_unit(_model(body), design.length_unit)
    places = _places(design)
    bodies = _bodies(model, len({place.member for place in places}))
    parts = []
    chosen = _assigned(bodies, places)
    for (name, given), place in zip(bodies.items(), chosen, strict=True):
        if place is None:
            others.append(f"{name} is one body too many: the design has no part for it")
            continue
        parts.append(_compared(name, given, place, within))
    others += [problem for part in parts for problem in _wrong_unit(part, model.length_unit, design.length_unit)]
    missing = {place.member for place in places} - {place.member for place in chosen if place}
    remarks += [f"the file has no {member}; only its mate was compared" for member in sorted(missing)]
    return Agreement(parts=tuple(parts), others=tuple(others), remarks=tuple(remarks), length_unit=design.length_unit)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Place:
    """Where a part may stand. matrix (4, 4) from its own frame."""

    member: str
    in_mesh: bool
    wanted: Wanted
    matrix: Array

    @property
    def back(self) -> Array:
        return np.asarray(np.linalg.inv(self.matrix))


def _places(design: Element | Pair) -> list[_Place]:
    if isinstance(design, Element):
        return [_Place(member="", in_mesh=False, wanted=Wanted(solid=design), matrix=np.eye(4))]
    found = []
    for (member, element), placement in zip(design.members.items(), design.placements(), strict=True):
        wanted = Wanted(solid=element)
        found += [
            _Place(member=member, in_mesh=in_mesh, wanted=wanted, matrix=matrix)
            for in_mesh, matrix in ((True, placement), (False, np.eye(4)))
        ]
    return found


def _model(body: str | Path | Model | Polyhedron) -> Model:
    if isinstance(body, Model):
        return body
    if isinstance(body, Polyhedron):
        return Model(bodies={"body": body})
    return with_z_up(Model.load(body), format_of(body, "read"))


def _in_unit(model: Model, unit: str) -> tuple[Model, list[str], list[str]]:
    """The model with lengths in the design's unit, remarks, and no problems yet."""
    remarks = [] if model.length_unit else [f"the file states no unit of length; {unit} is taken, the design's"]
    scale = LENGTH_UNITS[model.length_unit or unit] / LENGTH_UNITS[unit]
    if scale == 1.0:
        return model.sound, remarks, []
    matrix = np.diag([scale, scale, scale, 1.0])
    bodies = {name: body.transformed(matrix) for name, body in model.bodies.items()}
    smooth = {name: one.mapped(matrix[:3, :3], matrix[:3, 3]) for name, one in model.smooth.items()}
    converted = Model(bodies=bodies, smooth=smooth, length_unit=model.length_unit, remarks=model.remarks)
    remarks.append(f"lengths are converted from {model.length_unit} to {unit}, the design's")
    return converted.sound, remarks, []


def _bodies(model: Model, members: int) -> dict[str, Given]:
    """What is compared: for a single part all together, for a pair every body for itself."""
    if len(model.bodies) > 1 and members == 1:
        return {", ".join(model.bodies): Given(polyhedron=model.polyhedron)}
    if len(model.bodies) == 1 and members > 1:
        (whole,) = model.bodies.values()
        if len(pieces := whole.bodies()) > 1:
            return {f"body {k}": Given(polyhedron=piece) for k, piece in enumerate(pieces, start=1)}
    return {name: Given(polyhedron=body, smooth=model.smooth.get(name)) for name, body in model.bodies.items()}


def _assigned(bodies: dict[str, Given], places: Sequence[_Place]) -> list[_Place | None]:
    """For each body the place it fits best, each member once; None for bodies too many."""
    if len(bodies) == len(places) == 1:
        return list(places)
    unlike = [
        # of equals the earlier one counts
        (round(place.wanted.unlikeness(given.moved(place.back)) / _ALIKE), row, column)
        for row, given in enumerate(bodies.values())
        for column, place in enumerate(places)
    ]
    found: list[_Place | None] = [None] * len(bodies)
    for _, row, column in sorted(unlike):
        taken = {place.member for place in found if place}
        if found[row] is None and places[column].member not in taken:
            found[row] = places[column]
    return found


def _compared(name: str, given: Given, place: _Place, within: float | None) -> PartAgreement:
    names = face_names(place.wanted.solid.boundary)
    body = given.moved(place.back) if place.in_mesh else given
    comparison = compared(body, place.wanted, within, names)
    if place.in_mesh:
        comparison = comparison.moved(place.matrix)
    return PartAgreement(body=name, member=place.member, in_mesh=place.in_mesh, comparison=comparison)


def _wrong_unit(part: PartAgreement, taken: str | None, unit: str) -> Iterator[str]:
    """What the unit of the file should be, if with another the volume would be the design's."""
    found = part.comparison
    if found.volume is None or found.passed or found.volume <= 0.0:
        return
    used = taken or unit
    for other, size in LENGTH_UNITS.items():
        ratio = found.volume / found.exact_volume * (size / LENGTH_UNITS[used]) ** 3
        if other != used and abs(ratio - 1.0) < _SAME_VOLUME:
            yield (
                f"the unit looks wrong: the volume is {found.volume / found.exact_volume:.6g} times the design's, and"
                f' would be the design\'s if its lengths were in "{other}", not "{used}"'
            )

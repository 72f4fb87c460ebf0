"""The bodies of one file measured: what every worker does with a file, and what it answers."""

from __future__ import annotations

import sys
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from functools import partial, reduce
from pathlib import Path

from ..designs.built import Units, units_and_density
from ..errors import FileError, GearwrightError, GeometryError, Problem, ProblemsError
from ..files import reading
from ..parameters import LENGTH_UNITS, did_you_mean
from ..solids.close_bodies import close_bodies
from ..solids.extent import Extent
from ..solids.model import Model
from ..solids.polyhedron import Polyhedron
from ..solids.properties import MassProperties
from ..solids.validity.kinds import ProblemKind
from .exits import explained

STANDARD_INPUT = Path("-")
"""Stands for what is piped in."""

STREAMED = 100_000_000
"""Bytes of a binary STL file, two million triangles, from which on it is measured in passing."""

_SMOOTH_ERROR = 1e-8
"""Up to which two quadratures of smooth shapes agree, or the better one is taken: see `files.step.quadrature`."""

ALL_BODIES = ""
"""Stands for every body that is not named, where densities are given by name."""


@dataclass(frozen=True, kw_only=True)
class Question:
    """What is asked of every file.

    length_unit      of files that state none; None for mm
    densities        kg/m³ by the name of a body, ALL_BODIES for the others
    thickness        of a shell in the file's lengths; None for solids, or where a surface density is given
    surface_density  kg/m² of a shell
    subtracted       files whose bodies are taken away
    allow            defects that are let pass
    """

    length_unit: str | None = None
    densities: Mapping[str, float] = field(default_factory=dict)
    thickness: float | None = None
    surface_density: float | None = None
    subtracted: tuple[Path, ...] = ()
    allow: tuple[ProblemKind, ...] = ()

    @property
    def of_shells(self) -> bool:
        return self.thickness is not None or self.surface_density is not None


@dataclass(frozen=True, kw_only=True)
class Measured:
    """The properties of a file's bodies.

    file      its name; None for several files together
    together  all bodies as one
    bodies    each by its name; of one body only itself
    remarks   what a reader should know of, in words
    """

    file: str | None
    units: Units
    together: MassProperties
    bodies: Mapping[str, MassProperties]
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Failure:
    """Why a file has no properties: the exit code and the message."""

    code: int
    message: str


Answer = Measured | Failure


def answer(file: Path, question: Question) -> Answer:
    """A file's properties, or why there are none: never an exception but an interrupt."""
    try:
        return measured(file, question)
    except Exception as error:  # noqa: BLE001  it must travel between processes, as its code and message
        subject = "standard input" if file == STANDARD_INPUT else str(file)
        code, message = explained(error, f"gearwright properties {file}", subject=subject)
        return Failure(code=code, message=message)


def measured(file: Path, question: Question) -> Measured:
    """A file's properties. Raises GearwrightError where it cannot be read or measured as asked."""
    streamed = _streamed(file, question)
    if streamed is not None:
        return streamed
    model = _model(file)
    unit = _unit(file, model.length_unit, question.length_unit)
    densities = densities_by_body(model.bodies, question.densities)
    if not question.of_shells:
        model = model.sound
        densities = _of_sound(model, densities)
    bodies, together, remarks = _apart_and_together(model, densities, unit, question)
    units = _units(unit, densities, question)
    for other in question.subtracted:
        together = _without(together, other, unit, densities, question)
    return Measured(file=str(file), units=units, together=together, bodies=bodies, remarks=(*model.remarks, *remarks))


def _streamed(file: Path, question: Question) -> Measured | None:
    """Properties of a large binary STL file, in passing; None of any other."""
    plain = not (question.of_shells or question.allow or question.subtracted)
    if not plain or file.suffix.lower() != ".stl" or not file.is_file() or file.stat().st_size < STREAMED:
        return None
    from ..files.stl.records import records
    from ..solids.streamed import stream_properties

    try:
        unit = _unit(file, records(file).length_unit, question.length_unit)
    except FileError:
        return None  # a text file, or a broken one: reading it whole says what is wrong
    density = densities_by_body(["body 1"], question.densities)["body 1"]
    units, kernel_density = units_and_density(unit, density)
    found = stream_properties(file, kernel_density)
    found = replace(found, find_extent=partial(Extent, *found.extent))
    remark = "read in passing, for its size: whether bodies lie in one another, or some turn inward, `check` would say"
    return Measured(file=str(file), units=units, together=found, bodies={"body 1": found}, remarks=(remark,))


def _of_sound(model: Model, densities: dict[str, float | None]) -> dict[str, float | None]:
    """Densities of bodies that may have become one."""
    if set(model.bodies) == set(densities):
        return densities
    if len(set(densities.values())) > 1:
        (name,) = model.bodies
        problem = Problem(name, "these bound a solid only together, as one body; give one density")
        raise ProblemsError("Bodies of different densities must bound solids by themselves", [problem])
    return dict.fromkeys(model.bodies, next(iter(densities.values())))


def densities_by_body(bodies: Collection[str], given: Mapping[str, float]) -> dict[str, float | None]:
    """Density in kg/m³ of every body, None where no density is given at all.

    Raises ProblemsError where a name is no body's, or a body is left without a density.
    """
    there_are = f"there are {_named(bodies)}"
    problems = [
        Problem(f"{name} = {given[name]:g} kg/m³", f"no body has this name{did_you_mean(name, bodies)}; {there_are}")
        for name in given
        if name != ALL_BODIES and name not in bodies
    ]
    found = {name: given.get(name, given.get(ALL_BODIES)) for name in bodies}
    bare = [name for name, value in found.items() if value is None]
    if given and bare and not problems:
        problems = [Problem(_named(bare), "no density is given; one without a name goes for all other bodies")]
    if problems:
        raise ProblemsError("These densities do not go with the bodies", problems)
    return found


def _model(file: Path) -> Model:
    if file != STANDARD_INPUT:
        return Model.load(file)
    if sys.stdin is None:
        raise FileError("standard input is closed; nothing is piped in")
    return Model.of(reading.read_stream(sys.stdin.buffer))


def _unit(file: Path, stated: str | None, asked: str | None) -> str:
    """The unit that the file states, else the one asked for, else mm. Raises FileError where they differ."""
    if stated and asked and stated != asked:
        raise FileError(f"{file}: it says itself that lengths are in {stated}, not {asked}; leave out --length-unit")
    return stated or asked or "mm"


def _units(unit: str, densities: Mapping[str, float | None], question: Question) -> Units:
    if question.surface_density is not None:
        return Units(length=unit, mass="kg", has_volume=False)
    units, _ = units_and_density(unit, next(iter(densities.values()), None))
    return units


def _apart_and_together(
    model: Model, densities: Mapping[str, float | None], unit: str, question: Question
) -> tuple[dict[str, MassProperties], MassProperties, list[str]]:
    """Every body, all as one, and remarks."""
    bodies, problems = {}, []
    for name in model.bodies:
        try:
            bodies[name] = _body(model, name, densities[name], unit, question)
        except GeometryError as error:
            if len(model.bodies) == 1:
                raise
            problems += [Problem(f"{name}: {one.subject}", one.message) for one in error.problems]
    if problems:
        raise GeometryError(f"{len(model.bodies)} bodies, of which some bound no solid", problems)
    remarks = [] if question.of_shells else _remarks(model.polyhedron)
    if len(bodies) == 1:
        together = next(iter(bodies.values()))
        return bodies, together, remarks + list(together.warnings)
    if not model.smooth and len(set(densities.values())) == 1:
        # as one, so that bodies in one another are seen
        summed = _properties(model.polyhedron, next(iter(densities.values())), unit, question)
    else:
        if not question.of_shells:
            model.polyhedron.validity().raise_any(question.allow)
        summed = reduce(MassProperties.__add__, bodies.values())
    extents = [one.extent for one in bodies.values()]
    whole = reduce(Extent.joined, extents)._replace(area=sum(one.area or 0.0 for one in extents))
    together = replace(summed, find_extent=partial(Extent, *whole))
    return bodies, together, remarks + list(together.warnings)


def _remarks(whole: Polyhedron) -> list[str]:
    validity = whole.validity()
    close = len(close_bodies(validity)) if validity.valid else 0
    pairs = "1 pair" if close == 1 else f"{close} pairs"
    may = f"the boxes of {pairs} of bodies overlap: if they do, which `check` would say, what lies in both counts twice"
    return [*(str(one) for one in validity.remarks), *([may] if close else [])]


def _body(model: Model, name: str, density: float | None, unit: str, question: Question) -> MassProperties:
    """Of one body: of its smooth shape, where the file has one, with area and box of the polyhedron."""
    found = _properties(model.bodies[name], density, unit, question)
    smooth = model.smooth.get(name)
    if smooth is None or question.of_shells or found.warnings:
        return found
    return replace(
        found,
        volume=smooth.volume,
        centroid=smooth.centroid,
        central_second=smooth.second_moment,
        method="quadrature",
        error_bound=_SMOOTH_ERROR,
    )


def _properties(polyhedron: Polyhedron, density: float | None, unit: str, question: Question) -> MassProperties:
    """Of a solid or a shell; its density in kg/m³ or None. What is found late is found here, to travel light."""
    if question.surface_density is not None:
        per_area = question.surface_density / (1e3 / LENGTH_UNITS[unit]) ** 2
        found = polyhedron.shell_properties(1.0, per_area)
    elif question.thickness is not None:
        found = polyhedron.shell_properties(question.thickness, units_and_density(unit, density)[1])
    else:
        found = polyhedron.properties(units_and_density(unit, density)[1], allow=question.allow)
    return replace(found, find_extent=partial(Extent, *found.extent))


def _without(
    whole: MassProperties, part: Path, unit: str, densities: Mapping[str, float | None], question: Question
) -> MassProperties:
    """A body without the bodies of another file, which are of its density and unit."""
    if len(set(densities.values())) > 1:
        problem = Problem(f"--subtract {part}", "its density is not known where the bodies have several")
        raise ProblemsError("This cannot be taken away", [problem])
    try:
        model = Model.load(part)
        own = model.length_unit or unit
        if own != unit:
            raise FileError(f"{part}: its lengths are in {own}, not {unit}; files of one unit are needed")
        model = model if question.of_shells else model.sound
        taken = _properties(model.polyhedron, next(iter(densities.values())), unit, question)
    except GearwrightError as error:
        if str(error).startswith(str(part)):
            raise
        raise FileError(f"--subtract {part}: {error}") from error
    return whole - taken


def _named(names: Collection[str]) -> str:
    shown = list(names)[:20]
    more = f" and {len(names) - len(shown)} more" if len(names) > len(shown) else ""
    return ", ".join(shown) + more

"""How far polyhedra are from the solids they approximate, in volume, centroid and inertia.

Two things make the error of a polyhedron: its section is cut into chords, and its motion into layers.
Between the solid and the polyhedron stands the body that has the chords but no layers. Measured from it
the polyhedron shows the error of the layers alone; measured from the solid it shows that of the section.

The question is that of Al-Daccak 1989, where it stays open.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from numbers import Integral, Real
from typing import Protocol, get_args, runtime_checkable

import numpy as np

from ..boundary.boundary import Boundary
from ..boundary.chorded import chorded_moments, sagitta
from ..boundary.extent import rough_diagonal
from ..boundary.sampling import MOST_TRIANGLES, Sampling, fixed_sampling, sampling, section_edges
from ..boundary.tessellation import Diagonals, tessellate
from ..errors import GeometryError, Problem
from ..moments.body import BodyMoments
from ..moments.matrix import inertia_tensor
from .convergence import ApproximationError, ErrorRow
from .polyhedron import Polyhedron
from .properties import MassProperties
from .solid import DEFAULT_TOLERANCE

RELATIVE_TOLERANCES = (1e-3, 3e-4, 1e-4, 3e-5)
"""Chord tolerances taken where none are given, in bounding diagonals."""
SEGMENTS = (4, 8, 16)
_FEWEST_LAYERS, _COARSE = 4, 1e-2  # layers to start from, or more where this tolerance over the diagonal asks for them

_CAPS = 1.2  # tolerance of curved end faces over the depth of the chords that border them: below 1.1 it cannot be kept
_ROUNDING = 16.0 * float(np.finfo(float).eps)


@runtime_checkable
class Bounded(Protocol):
    """What has an exact boundary and exact properties: a solid, or an element that is one part."""

    @property
    def boundary(self) -> Boundary: ...
    def properties(self, density: float = 1.0) -> MassProperties: ...
    def polyhedron(self, tolerance: float | None = None) -> Polyhedron: ...


def approximation_error(solid: Bounded, tolerances: Sequence[float] | None = None) -> ApproximationError:
    """Errors of the polyhedra that the solid gives for chord tolerances (lengths), and their order in the tolerance.

    tolerances   at least two different ones; RELATIVE_TOLERANCES of the bounding diagonal if not given

    Raises GeometryError for tolerances that are not positive or too fine, and for a body without exact properties.
    """
    _refuse([*_no_solid(solid), *([] if tolerances is None else _unusable("tolerances", tolerances, _LENGTHS))])
    diagonal = rough_diagonal(solid.boundary)
    chosen = [one * diagonal for one in RELATIVE_TOLERANCES] if tolerances is None else tolerances
    exact = solid.properties()
    polyhedra = [(float(one), solid.polyhedron(float(one))) for one in sorted(chosen, reverse=True)]
    found = [(step, len(one.offsets) - 1, one.properties()) for step, one in polyhedra]
    return ApproximationError(
        refined="tolerance",
        against="the exact solid",
        rows=_rows(found, exact, diagonal),
        rounding=_rounding([one for _, _, one in found], exact, diagonal),
        diagonals="alternating",
    )


def section_refinement(solid: Bounded, segments: Sequence[int] = SEGMENTS) -> ApproximationError:
    """Errors of the solid with every section curve cut into so many chords, swept without layers; order in the number.

    End faces that are curved are triangulated as finely as the chords are.
    Raises GeometryError for fewer than two different numbers, too large ones, or a body without exact properties.
    """
    _refuse([*_no_solid(solid), *_unusable("segments", segments, _NUMBERS)])
    boundary = solid.boundary
    _refuse(_too_many(boundary, "segments", max(segments), 1))
    diagonal, exact = rough_diagonal(boundary), solid.properties()
    found = [
        (float(n), None, chorded_moments(boundary, _cut(boundary, n, 1, diagonal), exact.centroid))
        for n in sorted(segments)
    ]
    return ApproximationError(
        refined="segments",
        against="the exact solid",
        rows=_rows(found, exact, diagonal),
        rounding=_rounding([one for _, _, one in found], exact, diagonal),
    )


def layer_refinement(
    solid: Bounded, layers: Sequence[int] | None = None, segments: int = 8, diagonals: Diagonals = "alternating"
) -> ApproximationError:
    """Errors of polyhedra of so many layers a smooth span against the solid with the same chords and no layers.

    layers      at least two different numbers; some that suit the solid if not given, each twice the one before
    segments    chords of every section curve
    diagonals   "alternating", as polyhedra have them, or "fixed": one and the same in every quad

    Raises GeometryError for fewer than two different numbers, too large ones, or a body without exact properties.
    """
    problems = [*_no_solid(solid), *([] if layers is None else _unusable("layers", layers, _NUMBERS))]
    if not _is_number(segments):
        problems.append(Problem(f"segments = {segments!r}", "a whole number of at least 1 is needed"))
    if diagonals not in get_args(Diagonals):
        problems.append(Problem(f"diagonals = {diagonals!r}", f"choose one of {', '.join(get_args(Diagonals))}"))
    _refuse(problems)
    boundary = solid.boundary
    diagonal = rough_diagonal(boundary)
    chosen = _suitable_layers(boundary, diagonal) if layers is None else layers
    _refuse(_too_many(boundary, "layers", segments, max(chosen)))
    limit = chorded_moments(boundary, _cut(boundary, segments, 1, diagonal), solid.properties().centroid)
    found = []
    for n in sorted(chosen):
        polyhedron = Polyhedron(*tessellate(boundary, _cut(boundary, segments, n, diagonal), diagonals))
        found.append((float(n), len(polyhedron.offsets) - 1, _properties(polyhedron, n)))
    return ApproximationError(
        refined="layers",
        against=f"the solid with its section curves cut into {segments} chords each, swept without layers",
        rows=_rows(found, limit, diagonal),
        rounding=_rounding([one for _, _, one in found], limit, diagonal),
        diagonals=diagonals,
    )


_Moments = MassProperties | BodyMoments
_REFUSED = "The error of this approximation cannot be measured"
_LENGTHS, _NUMBERS = "finite lengths greater than 0", "whole numbers of at least 1"


def _rows(
    found: Sequence[tuple[float, int | None, _Moments]], exact: _Moments, diagonal: float
) -> tuple[ErrorRow, ...]:
    inertia = inertia_tensor(exact.central_second)
    return tuple(
        ErrorRow(
            step=step,
            triangles=triangles,
            volume=one.volume / exact.volume - 1.0,
            centroid=float(np.linalg.norm(one.centroid - exact.centroid)) / diagonal,
            inertia=float(np.linalg.norm(inertia_tensor(one.central_second) - inertia) / np.linalg.norm(inertia)),
        )
        for step, triangles, one in found
    )


def _rounding(found: Sequence[_Moments], exact: _Moments, diagonal: float) -> float:
    """What coordinates as large as these, and the error bounds of both sides, may leave."""
    away = float(np.linalg.norm(exact.centroid)) / diagonal
    return _ROUNDING * (1.0 + away) + 4.0 * (exact.error_bound + max(one.error_bound for one in found))


def _cut(boundary: Boundary, across: int, layers: int, diagonal: float) -> Sampling:
    """So many segments and layers, and curved caps as fine as the chords: plane ones have no inner points."""
    found = fixed_sampling(boundary, int(across), int(layers), DEFAULT_TOLERANCE * diagonal)
    fineness = _CAPS * sagitta(boundary, found)
    return found if fineness <= _ROUNDING * diagonal else replace(found, tolerance=fineness)


def _suitable_layers(boundary: Boundary, diagonal: float) -> list[int]:
    """Numbers of layers, the least of which follow the motion at least roughly."""
    found, section = sampling(boundary, _COARSE * diagonal).segments, section_edges(boundary)
    open_edges = [edge for edge in boundary.edges if edge not in section and not edge.closed]
    least = max([_FEWEST_LAYERS, *(found[edge] for edge in open_edges)])
    return [least, 2 * least, 4 * least, 8 * least]


def _properties(polyhedron: Polyhedron, layers: int) -> MassProperties:
    try:
        return polyhedron.properties()
    except GeometryError as error:
        reason = f"so few that the polyhedron is no solid ({error.problems[0].subject}); take more"
        raise GeometryError(_REFUSED, [Problem(f"layers = {layers}", reason)]) from None


def _no_solid(solid: object) -> list[Problem]:
    if isinstance(solid, Bounded):
        return []
    return [
        Problem(
            f"a {type(solid).__name__}",
            "a solid, or an element of one part, is needed: it has exact properties to measure from (of a pair, take"
            " .pinion or .gear)",
        )
    ]


def _unusable(name: str, steps: object, needed: str) -> list[Problem]:
    """What is wrong with the steps of a study."""
    if isinstance(steps, str) or not isinstance(steps, Sequence | np.ndarray):
        return [Problem(f"{name} = {steps!r}", f"several {needed} are needed")]
    fits = _is_length if needed is _LENGTHS else _is_number
    problems = [
        Problem(f"{name}[{i}] = {one!r}", f"{needed} are needed") for i, one in enumerate(steps) if not fits(one)
    ]
    if not problems and len(set(steps)) < max(len(steps), 2):
        problems.append(Problem(f"{name} = {list(steps)}", "at least two are needed for an order, all different"))
    return problems


def _is_length(value: object) -> bool:
    return isinstance(value, Real) and 0.0 < float(value) < math.inf


def _is_number(value: object) -> bool:
    return isinstance(value, Integral) and int(value) >= 1


def _too_many(boundary: Boundary, name: str, across: int, layers: int) -> list[Problem]:
    cut = fixed_sampling(boundary, int(across), int(layers), 1.0).segments
    triangles = sum(2 * p.pattern.order * cut[p.sides[0].edge] * cut[p.sides[1].edge] for p in boundary.patches)
    if triangles <= MOST_TRIANGLES:
        return []
    given = across if name == "segments" else layers
    most = given * MOST_TRIANGLES // triangles
    return [Problem(f"{name} = {given}", f"more than {MOST_TRIANGLES} triangles; at most {most} are possible here")]


def _refuse(problems: Sequence[Problem]) -> None:
    if problems:
        raise GeometryError(_REFUSED, problems)

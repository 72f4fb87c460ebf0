"""Lines along which the flanks of a bevel pair touch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from ..errors import GeometryError, Problem
from .mesh import Side, mesh_of
from .path import ContactPath
from .search import stretches

_DRAWN = 17  # points of a line that is drawn


@dataclass(frozen=True, kw_only=True)
class ContactLine:
    """A line along which one pinion tooth touches, from its inner to its outer end.

    tooth             of the pinion, 0 the one on the pitch line at turn 0 and the mean cone distance
    distance, polar   (n,) cone distance and polar angle on the pinion
    points            (n, 3) where they touch: pinion axis +z, gear axis towards +x, apex at the origin
    """

    tooth: int
    distance: Array
    polar: Array
    points: Array

    @property
    def length(self) -> float:
        """Of the polyline through the points."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())


@dataclass(frozen=True, kw_only=True)
class ContactRatios:
    """Teeth in contact: on the sphere at mid-face, by the lag of the teeth's ends, and all together on average."""

    transverse: float
    overlap: float
    total: float


def contact_lines(
    pair: BevelPair, turn: float = 0.0, *, side: Side = "drive", samples: int = 33
) -> tuple[ContactLine, ...]:
    """All lines of contact with the pinion turned by so many degrees, each with so many points, axes as designed.

    Raises GeometryError where the turn is none, or points are too few for a line.
    """
    if not (np.isfinite(turn) and samples >= 2):
        given = Problem(
            f"turn = {turn}, samples = {samples}", "a finite turn in degrees and at least 2 points are needed"
        )
        raise GeometryError("Lines of contact cannot be found", [given])
    return lines_at(ContactPath(mesh=mesh_of(pair), side=side), float(np.radians(turn)), samples)


def lines_over_a_pitch(pair: BevelPair, steps: int = 12) -> tuple[list[list[Array]], float]:
    """Points of the lines at so many turns over one pitch of the pinion, and that pitch in degrees."""
    path, pitch = ContactPath(mesh=mesh_of(pair), side="drive"), 360.0 / pair.teeth[0]
    turns = np.radians(pitch) * np.arange(steps) / steps
    return [[line.points for line in lines_at(path, float(turn), _DRAWN)] for turn in turns], pitch


def contact_ratios(pair: BevelPair, side: Side = "drive") -> ContactRatios:
    """Contact ratios from where the pinion's flank touches; of the forms, while they are conjugate.

    The total is the turn from a tooth's first touching, on whatever sphere, to its last, over the pitch.
    """
    path = ContactPath(mesh=mesh_of(pair), side=side)
    first, last = path.first_and_last
    least, most = path.mesh.pinion.turned
    return ContactRatios(
        transverse=path.transverse_ratio,
        overlap=(most - least) / path.mesh.pitch,
        total=(last - first) / path.mesh.pitch,
    )


def lines_at(path: ContactPath, turn: float, samples: int = 33) -> tuple[ContactLine, ...]:
    """Lines of contact of any conjugate flanks with the pinion turned by an angle, radians.

    One shorter than 1/128 of the face may be passed over.
    """
    pitch, trace = path.mesh.pitch, path.mesh.pinion.trace
    first, last = path.first_and_last
    teeth = np.arange(np.ceil((first - turn) / pitch - 1e-9), np.floor((last - turn) / pitch + 1e-9) + 1.0, dtype=int)
    grid = np.repeat(path.spheres[:, None], len(teeth), axis=1)
    columns, inner, outer = stretches(
        lambda at, r: path.room(turn + teeth[at] * pitch + trace.turn(r), r), grid
    )  # fmt: skip
    return tuple(
        _line(path, tooth, turn + tooth * pitch, np.linspace(r_i, r_e, samples))
        for tooth, r_i, r_e in zip(teeth[columns].tolist(), inner.tolist(), outer.tolist(), strict=True)
        if r_e > r_i
    )


def _line(path: ContactPath, tooth: int, turn: float, distance: Array) -> ContactLine:
    polar = path.polar(turn + path.mesh.pinion.trace.turn(distance))
    return ContactLine(tooth=tooth, distance=distance, polar=polar, points=distance[:, None] * path.point(polar))

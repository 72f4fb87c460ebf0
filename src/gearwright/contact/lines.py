"""Lines along which the flanks of a bevel pair touch."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from .mesh import Side, mesh_of
from .path import ContactPath
from .search import crossing


@dataclass(frozen=True, kw_only=True)
class ContactLine:
    """The line along which one pinion tooth touches, from the inner to the outer end.

    Where the trace turns back, as that of a zerol gear does, there is one line to either side of that place.

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
    """Teeth in contact: on one sphere, by the lag of the teeth's ends, and all together on average."""

    transverse: float
    overlap: float
    total: float


def contact_lines(
    pair: BevelPair, turn: float = 0.0, *, side: Side = "drive", samples: int = 33
) -> tuple[ContactLine, ...]:
    """All lines of contact with the pinion turned by so many degrees, each with so many points, axes as designed."""
    return lines_at(ContactPath(mesh=mesh_of(pair), side=side), float(np.radians(turn)), samples)


def contact_ratios(pair: BevelPair, side: Side = "drive") -> ContactRatios:
    """Contact ratios from where the pinion's flank touches; while the teeth are conjugate.

    The total is the turn from a tooth's first touching, on whatever sphere, to its last, over the pitch.
    """
    mesh = mesh_of(pair)
    path = ContactPath(mesh=mesh, side=side)
    first, last = _first_and_last(path)
    least, most = mesh.pinion.turned
    return ContactRatios(
        transverse=path.transverse_ratio, overlap=(most - least) / mesh.pitch, total=(last - first) / mesh.pitch
    )


def lines_at(path: ContactPath, turn: float, samples: int = 33) -> tuple[ContactLine, ...]:
    """Lines of contact of any conjugate flanks with the pinion turned by an angle, radians."""
    first, last = _first_and_last(path)
    pitch = path.mesh.pitch
    teeth = range(int(np.ceil((first - turn) / pitch)), int(np.floor((last - turn) / pitch)) + 1)
    bends = path.mesh.pinion.bends
    pieces = [
        (tooth, _touching_distances(path, turn + tooth * pitch, inner, outer))
        for tooth in teeth
        for inner, outer in pairwise(bends)
    ]
    return tuple(
        _line(path, tooth, turn + tooth * pitch, np.linspace(*piece, samples)) for tooth, piece in pieces if piece
    )


def _line(path: ContactPath, tooth: int, turn: float, distance: Array) -> ContactLine:
    polar = path.polar(np.clip(turn + path.mesh.pinion.trace.turn(distance), *path.ends))
    return ContactLine(tooth=tooth, distance=distance, polar=polar, points=distance[:, None] * path.point(polar))


def _touching_distances(path: ContactPath, turn: float, inner: float, outer: float) -> tuple[float, float] | None:
    """Cone distances between which a tooth touches, among those where its trace turns one way only."""
    trace = path.mesh.pinion.trace
    ends = np.array([inner, outer])
    at_ends = turn + trace.turn(ends)
    if at_ends.max() < path.ends[0] or at_ends.min() > path.ends[1]:
        return None
    if at_ends[0] == at_ends[1]:
        return inner, outer
    wanted = np.clip(at_ends, *path.ends)
    low, high = (np.full(2, one) for one in ends)
    found = crossing(lambda r: turn + trace.turn(r) - wanted, low, high)
    return float(found[0]), float(found[1])


def _first_and_last(path: ContactPath) -> tuple[float, float]:
    """Turns of the pinion between which a tooth touches anywhere."""
    least, most = path.mesh.pinion.turned
    return path.ends[0] - most, path.ends[1] - least

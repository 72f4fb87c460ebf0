"""Lines along which the flanks of a bevel pair touch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..elements.bevel.bevel_pair import BevelPair
from .mesh import Side, mesh_of
from .path import ContactPath
from .search import stretches

_LOOKED_AT = 129  # cone distances among which lines of contact are found


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
    """All lines of contact with the pinion turned by so many degrees, each with so many points, axes as designed."""
    return lines_at(ContactPath(mesh=mesh_of(pair), side=side), float(np.radians(turn)), samples)


def contact_ratios(pair: BevelPair, side: Side = "drive") -> ContactRatios:
    """Contact ratios from where the pinion's flank touches; of the forms, while they are conjugate.

    The total is the turn from a tooth's first touching, on whatever sphere, to its last, over the pitch.
    """
    path = ContactPath(mesh=mesh_of(pair), side=side)
    first, last = first_and_last(path)
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
    first, last = first_and_last(path)
    teeth = np.arange(np.ceil((first - turn) / pitch - 1e-9), np.floor((last - turn) / pitch + 1e-9) + 1.0, dtype=int)
    grid = np.repeat(_spheres(path)[:, None], len(teeth), axis=1)
    columns, inner, outer = stretches(
        lambda at, r: path.room(turn + teeth[at] * pitch + trace.turn(r), r), grid
    )  # fmt: skip
    return tuple(
        _line(path, tooth, turn + tooth * pitch, np.linspace(*ends, samples))
        for tooth, *ends in zip(teeth[columns].tolist(), inner.tolist(), outer.tolist(), strict=True)
        if ends[1] > ends[0]
    )


def _line(path: ContactPath, tooth: int, turn: float, distance: Array) -> ContactLine:
    polar = path.polar(turn + path.mesh.pinion.trace.turn(distance))
    return ContactLine(tooth=tooth, distance=distance, polar=polar, points=distance[:, None] * path.point(polar))


def _spheres(path: ContactPath) -> Array:
    """Cone distances from the least to the greatest that both members have, with those where a trace turns back."""
    reaches = np.array([path.mesh.pinion.reach, path.mesh.gear.reach])
    between = np.linspace(reaches[:, 0].max(), reaches[:, 1].min(), _LOOKED_AT)
    return np.union1d(between, path.mesh.pinion.bends)


def first_and_last(path: ContactPath) -> tuple[float, float]:
    """Turns of the pinion between which a tooth touches anywhere.

    It begins and ends at a tip or a foot, on the sphere whose part of the tooth is furthest ahead or behind.
    """
    spheres = _spheres(path)
    pinion, gear = path.mesh.pinion, path.mesh.gear
    found = []
    for which in (0, 1):

        def room(_: Array, r: Array, which: int = which) -> Array:
            """≥ 0 where both have their ends further out and further in."""
            polar = path.active(r)[which]
            levels = pinion.level(polar, r), gear.level(path.gear_polar(polar), r)
            ways = [way for one, v in zip((pinion, gear), levels, strict=True) for way in (v - one.inner, one.outer - v)]
            return np.min(ways, axis=0)

        _, inner, outer = stretches(room, spheres[:, None])
        r = np.concatenate([inner, outer, *(spheres[(spheres > a) & (spheres < b)] for a, b in zip(inner, outer, strict=True))])
        found.append(path.turn(path.active(r)[which]) - pinion.trace.turn(r))
    turns = np.concatenate(found)
    return float(turns.min()), float(turns.max())

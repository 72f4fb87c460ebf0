"""Which closed chains are outer ones and which are holes in them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...curves.curve import Curve, along, chain_quadrature
from ...curves.line import Line
from ...errors import GeometryError, Problem
from ..crossing import crossing_problems
from ..loop import Loop
from .listing import first_few, place

if TYPE_CHECKING:
    import shapely

Chain = tuple[Curve, ...]

_FINEST, _POINTS = 256, 20_000
"""Chords a curve, and about a loop, of the polygons that stand for the loops: 1e-4 of a circle's radius."""

_COARSE = 1e-3
"""What polygons of curves do not show, relative to the loop: by less do boxes of one loop differ, wherever its curves
start, and less of its square is enclosed by a line there and back."""


@dataclass(frozen=True)
class _Ring:
    """A closed chain and what is to be known of it."""

    chain: Chain

    @cached_property
    def area(self) -> float:
        """Signed: positive where the chain runs counter-clockwise."""
        points, tangents = chain_quadrature(self.chain, 20)
        x, y = (points - points[0]).T
        return float(np.sum(x * tangents[:, 1] - y * tangents[:, 0])) / 2.0

    @cached_property
    def centroid(self) -> Array:
        """∫ r dA = ½ ∮ (x² dy, −y² dx), over the area."""
        points, tangents = chain_quadrature(self.chain, 20)
        own = points - points[0]
        first = np.sum(own**2 * tangents[:, ::-1], axis=0) * np.array([0.5, -0.5])
        return points[0] + first / self.area

    @cached_property
    def polygon(self) -> Array:
        """Points (n, 2) along the chain, fine enough to tell inside from outside."""
        steps = max(4, min(_FINEST, _POINTS // len(self.chain)))
        fractions = np.arange(steps) / steps
        parts = [along([c], fractions[:1] if isinstance(c, Line) else fractions)[0][0] for c in self.chain]
        return np.concatenate(parts)

    @cached_property
    def filled(self) -> shapely.Polygon:
        """The polygon with its inside, prepared for many questions."""
        import shapely

        polygon = shapely.Polygon(self.polygon)
        shapely.prepare(polygon)
        return polygon

    @cached_property
    def outline(self) -> shapely.LinearRing:
        import shapely

        outline = shapely.LinearRing(self.polygon)
        shapely.prepare(outline)
        return outline

    def meets(self, other: _Ring) -> bool:
        """Whether the polygons' sides cross or touch."""
        few, many = sorted((self, other), key=lambda ring: len(ring.polygon))
        return bool(many.outline.intersects(few.outline))

    def goes_around(self, point: Array) -> bool:
        """Whether a point (2,) lies inside."""
        import shapely

        return bool(shapely.contains_xy(self.filled, point[0], point[1]))

    @cached_property
    def box(self) -> Array:
        return np.array([self.polygon.min(axis=0), self.polygon.max(axis=0)])

    @property
    def reach(self) -> float:
        return float(np.max(np.ptp(self.box, axis=0)))

    def __str__(self) -> str:
        width, height = self.box[1] - self.box[0]
        return f"loop about {place(self.box.mean(axis=0))}, {width:.6g} wide and {height:.6g} high"

    def turned(self, sense: int) -> Chain:
        """The chain so that it runs counter-clockwise (+1) or clockwise (−1)."""
        return self.chain if self.area * sense > 0.0 else tuple(c.reversed() for c in reversed(self.chain))


def regions(chains: Sequence[Chain], tolerance: float) -> tuple[tuple[Chain, ...], ...]:
    """Regions as chains: the outer one first and counter-clockwise, its holes clockwise; an island is a region.

    A loop inside an even number of others is an outer one. Raises GeometryError naming every loop that
    encloses nothing, is drawn twice or crosses another one.
    """
    rings = [_Ring(chain) for chain in chains]
    flat = [_flat(ring) for ring in rings if abs(ring.area) <= tolerance * ring.reach]
    _refuse(flat or _twins(rings, tolerance))
    inside, crossings = _containment(rings)
    _refuse(crossings)
    depth = inside.sum(axis=1)
    found = []
    for i in np.flatnonzero(depth % 2 == 0).tolist():
        holes = np.flatnonzero(inside[:, i] & (depth == depth[i] + 1))
        found.append((rings[i].turned(1), *(rings[j].turned(-1) for j in holes)))
    return tuple(found)


def described(region: Sequence[Chain]) -> str:
    """Where a region is and how large."""
    holes = len(region) - 1
    return f"{_Ring(region[0])}, with {holes or 'no'} hole{'s' if holes != 1 else ''}"


def innermost(found: Sequence[tuple[Chain, ...]], point: Array) -> int | None:
    """Number of the smallest region whose outer loop goes around a point."""
    rings = [_Ring(region[0]) for region in found]
    around = [i for i, ring in enumerate(rings) if ring.goes_around(point)]
    return min(around, key=lambda i: rings[i].area, default=None)


def _containment(rings: Sequence[_Ring]) -> tuple[Array, list[Problem]]:
    """Whether ring i lies within ring j (n, n), and a problem for each pair that crosses."""
    boxes = np.array([ring.box for ring in rings])
    inside, crossings = np.zeros((len(rings), len(rings)), bool), []
    for i, ring in enumerate(rings):
        meet = np.all((boxes[:, 0] <= ring.box[1]) & (ring.box[0] <= boxes[:, 1]), axis=1)
        for j in np.flatnonzero(meet).tolist():
            if i < j and ring.meets(rings[j]):
                crossings.append(_crossing(ring, rings[j]))
            inside[i, j] = i != j and rings[j].goes_around(ring.polygon[0])
    return inside, crossings


def _twins(rings: Sequence[_Ring], tolerance: float) -> list[Problem]:
    """Loops with the centroid, the area and the box of another one, whatever curves they are made of."""
    from scipy.spatial import cKDTree

    pairs = cKDTree(np.array([ring.centroid for ring in rings])).query_pairs(4.0 * tolerance)
    return [
        Problem(f"drawn twice: the {rings[i]}", "a loop bounds the section once; delete one of the two")
        for i, j in sorted(pairs)
        if _alike(rings[i], rings[j], tolerance)
    ]


def _alike(ring: _Ring, other: _Ring, tolerance: float) -> bool:
    sides = float(np.sum(np.ptp(ring.box, axis=0)))
    same_box = np.abs(ring.box - other.box).max() <= _COARSE * sides
    return bool(same_box) and abs(abs(ring.area) - abs(other.area)) <= 4.0 * tolerance * sides


def _flat(ring: _Ring) -> Problem:
    """Of a loop whose areas to the left and to the right add up to nothing, or that has none."""
    import shapely

    enclosed = float(shapely.make_valid(ring.filled).area)
    for crossing in crossing_problems([Loop(curves=ring.chain)]) if enclosed > _COARSE * ring.reach**2 else []:
        return Problem(f"{ring}, at {crossing.subject.partition(' at ')[2]}", crossing.message)
    return Problem(f"{ring}", "this encloses nothing: a line there and back; delete it")


def _crossing(ring: _Ring, other: _Ring) -> Problem:
    return Problem(
        f"{ring}, and {other}",
        "these two cross or touch, or lie too close to tell which is inside; a section's loops keep apart: unite "
        "or trim the shapes in the drawing",
    )


def _refuse(problems: list[Problem]) -> None:
    if problems:
        raise GeometryError("The loops do not bound a section", first_few(problems))

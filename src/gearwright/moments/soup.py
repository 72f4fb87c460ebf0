"""Triangles that stand alone, each with its three corners, as in STL files: a source of sums of any length.

They are asked for in chunks, so that files of any size take the same memory, and are never joined.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .indexed import middle_of
from .polyhedron import PolyhedronMoments, settled
from .summation import Sums, in_chunks, merged, nothing

Corners = NDArray[np.float32]
"""Corners (m, 3, 3) of triangles."""

NOUGHT = 2.0**-46
"""A coordinate this small relative to the largest one is a rounding error of 0 in the program that wrote it.

Single precision is fine enough to tell such errors apart only next to 0, where they tear holes: a corner
written once with 0, once with −2.7e-16. Anywhere else it has rounded them away.
"""

_SAMPLE = 64


class Look(NamedTuple):
    """What one look at some triangles shows.

    sums    about the origin that was asked for
    box     (2, 3) lowest and highest coordinates
    sides   0 if every side is walked as often one way as the other, see `kernels.records`; modulo 2⁶⁴
    """

    sums: Sums
    box: Array
    sides: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Soup:
    """Triangles by their numbers.

    corners   gives those from a first number to one before a last
    count     how many there are
    factor    by which their coordinates are multiplied, a power of two
    threads   None for as many as there are processors
    """

    corners: Callable[[int, int], Corners]
    count: int
    factor: float = 1.0
    threads: int | None = None

    def look(self, origin: Array) -> Look:
        """All triangles, once. Raises what `corners` raises."""
        return joined(in_chunks(lambda start, stop: self.part(start, stop, origin), self.count, self.threads))

    def part(self, start: int, stop: int, origin: Array) -> Look:
        """The triangles of one chunk; chunks as `summation.CHUNK` has them join to the same bits everywhere."""
        from .kernels.records import record_sums

        sums, box, sides = nothing(), np.array([[np.inf] * 3, [-np.inf] * 3]), np.zeros(1, np.uint64)
        record_sums(self._scaled(start, stop), origin, np.float32(self._nought), *sums, box, sides)
        return Look(sums, box, int(sides[0]))

    @cached_property
    def middle(self) -> Array:
        """The middle (3,) of a few triangles."""
        return middle_of(self._few)

    @cached_property
    def box(self) -> Array:
        return self.look(self.middle).box

    def sums(self, origin: Array) -> Sums:
        return self.look(origin).sums

    def doubled(self, origin: Array) -> Sums:
        from .kernels.doubled import doubled_sums

        def part(start: int, stop: int) -> Sums:
            corners, sums = self._scaled(start, stop), nothing()
            points = np.where(np.abs(corners) > self._nought, corners, 0.0).astype(np.float64).reshape(-1, 3)
            triangles = np.arange(len(points), dtype=np.int32).reshape(-1, 3)
            doubled_sums(points, triangles, 0, len(triangles), origin, *sums)
            return sums

        return merged(in_chunks(part, self.count, self.threads))

    def scaled(self, factor: float) -> Soup:
        return replace(self, factor=self.factor * factor)

    def _scaled(self, start: int, stop: int) -> Corners:
        corners = self.corners(start, stop)
        return corners if self.factor == 1.0 else np.asarray(corners * np.float32(self.factor))

    @cached_property
    def _few(self) -> Array:
        """Corners (k, 3) of a few triangles, spread over all."""
        places = range(0, self.count, max(1, self.count // _SAMPLE))
        few = [self._scaled(place, place + 1).reshape(-1, 3) for place in places]
        return np.concatenate([np.empty((0, 3)), *few]).astype(np.float64)

    @cached_property
    def _nought(self) -> float:
        return NOUGHT * float(np.abs(self._few).max(initial=0.0))


def joined(looks: Iterable[Look]) -> Look:
    """One look at all triangles from looks at chunks of them, in their order."""
    looks = list(looks)
    return Look(
        merged(look.sums for look in looks),
        np.stack([np.min([look.box[0] for look in looks], axis=0), np.max([look.box[1] for look in looks], axis=0)]),
        sum(look.sides for look in looks) % 2**64,
    )


def soup_moments(soup: Soup, look: Look) -> PolyhedronMoments:
    """Moments from a look about the soup's middle."""
    return settled(soup, soup.middle, look.sums)

"""Triangles and polygons that name their corners by number, as a source of sums."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NoReturn, Protocol

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem
from .faces import fan_triangles
from .summation import Sums, in_chunks, merged, nothing

_SAMPLE = 64


class Source(Protocol):
    """Faces of any kind, to be summed about any point."""

    @property
    def box(self) -> Array:
        """Lowest and highest coordinates (2, 3) of the corners."""

    def sums(self, origin: Array) -> Sums:
        """In plain arithmetic."""

    def doubled(self, origin: Array) -> Sums:
        """Rows 0 to 9 in doubled arithmetic."""

    def scaled(self, factor: float) -> Source:
        """The same faces with all coordinates multiplied."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Triangles:
    """vertices (n, 3) float64 and triangles (m, 3), int32 or int64: contiguous, and never copied."""

    vertices: Array
    triangles: Any
    threads: int | None = None

    @cached_property
    def box(self) -> Array:
        return bounding_box(self.vertices, self.triangles.reshape(-1))

    def sums(self, origin: Array) -> Sums:
        from .kernels.triangles import triangle_sums

        numbers = unsigned(self.triangles)

        def part(start: int, stop: int, high: Array, low: Array) -> int:
            place = triangle_sums(self.vertices, self.triangles, numbers, start, stop, origin, high, low)
            return place // 3 if place >= 0 else -1

        return _sums(part, len(self.triangles), self.threads, self._require)

    def doubled(self, origin: Array) -> Sums:
        return doubled_sums(self.vertices, self.triangles, origin, self.threads)

    def scaled(self, factor: float) -> Source:
        return replace(self, vertices=self.vertices * factor)

    def _require(self, face: int) -> None:
        require_corners(self.triangles[face], face, len(self.vertices))


@dataclass(frozen=True, kw_only=True, eq=False)
class Polygons:
    """vertices (n, 3) float64, indices (c,) int32 or int64, offsets (f + 1,) as in `faces`; never copied."""

    vertices: Array
    indices: Any
    offsets: Indices
    threads: int | None = None

    @cached_property
    def box(self) -> Array:
        return bounding_box(self.vertices, self.indices)

    def sums(self, origin: Array) -> Sums:
        from .kernels.polygons import polygon_sums

        def part(start: int, stop: int, high: Array, low: Array) -> int:
            return polygon_sums(self.vertices, self.indices, self.offsets, start, stop, origin, high, low)

        return _sums(part, len(self.offsets) - 1, self.threads, self._require)

    def doubled(self, origin: Array) -> Sums:
        triangles = fan_triangles(self.indices, self.offsets)
        return doubled_sums(self.vertices, triangles, origin, self.threads)

    def scaled(self, factor: float) -> Source:
        return replace(self, vertices=self.vertices * factor)

    def _require(self, face: int) -> None:
        first, after = int(self.offsets[face]), int(self.offsets[face + 1])
        if not 0 <= first <= after <= len(self.indices):
            refuse_arrays(f"offsets {first}, {after} of face {face}", f"0 to {len(self.indices)}, rising, are needed")
        require_corners(self.indices[first:after], face, len(self.vertices))


def unsigned(triangles: Any) -> Any:
    """The numbers of triangles (3m,), in which a negative one is a large one."""
    return triangles.reshape(-1).view(np.uint32 if triangles.dtype.itemsize == 4 else np.uint64)


def require_corners(corners: Any, face: int, count: int) -> None:
    """Refuses a face that has fewer than three corners or names a vertex that is not there. Raises GeometryError."""
    if count == 0:
        refuse_arrays(f"face {face}", "there are no vertices")
    beyond = [int(number) for number in corners if not 0 <= number < count]
    if beyond:
        message = f"vertex numbers go from 0 to {count - 1}; lists that count from 1 must be lowered by 1"
        refuse_arrays(f"vertex number {beyond[0]} in face {face}", message)
    if len(corners) < 3:
        refuse_arrays(f"face {face} of {len(corners)} corners", "at least 3 are needed")


def refuse_arrays(subject: str, message: str) -> NoReturn:
    """Raises GeometryError: what is wrong with arrays of vertices and faces."""
    raise GeometryError("These arrays are not a polyhedron", [Problem(subject, message)])


def _sums(
    part: Callable[[int, int, Array, Array], int], count: int, threads: int | None, require: Callable[[int], None]
) -> Sums:
    """The sums over all faces, in chunks; of a bad one `part` gives the number."""

    def chunk(start: int, stop: int) -> tuple[int, Sums]:
        sums = nothing()
        return part(start, stop, *sums), sums

    parts = in_chunks(chunk, count, threads)
    for bad, _ in parts:
        if bad >= 0:
            require(bad)
    return merged(sums for _, sums in parts)


def doubled_sums(vertices: Array, triangles: Any, origin: Array, threads: int | None) -> Sums:
    """Rows 0 to 9 in doubled arithmetic over triangles (m, 3) whose numbers are in range."""
    from .kernels.doubled import doubled_sums as add

    def chunk(start: int, stop: int) -> Sums:
        sums = nothing()
        add(vertices, triangles, start, stop, origin, *sums)
        return sums

    return merged(in_chunks(chunk, len(triangles), threads))


def bounding_box(vertices: Array, indices: Any) -> Array:
    """Lowest and highest coordinates (2, 3) of the vertices that faces use."""
    used = np.zeros(len(vertices), dtype=bool)
    used[indices] = True
    points = vertices if used.all() else vertices[used]
    return np.stack([points.min(axis=0), points.max(axis=0)]) if len(points) else np.zeros((2, 3))


def middle(vertices: Array, indices: Any) -> Array:
    """The middle (3,) of a few corners: somewhere among the faces, found at once. Bad numbers are left out."""
    few = indices[:: max(1, len(indices) // _SAMPLE)]
    points = vertices[few[(few >= 0) & (few < len(vertices))]]
    if not len(points):
        return np.zeros(3)
    return middle_of(points)


def middle_of(points: Array) -> Array:
    """The middle (3,) of the box of points (n, 3), at least one."""
    least, most = points.min(axis=0), points.max(axis=0)
    with np.errstate(invalid="ignore"):  # coordinates that are not finite are refused later
        return np.asarray(least + (most - least) / 2.0)

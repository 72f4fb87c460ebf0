"""Mass properties of arrays, at the least cost a call."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..arrays import Array, ArrayLike, numbers_in
from ..errors import GeometryError, Problem
from .faces import Faces, corner_lists
from .indexed import Polygons, Triangles, middle, refuse_arrays, require_corners, unsigned
from .matrix import inertia_tensor
from .polyhedron import AMPLIFICATION_LIMIT, CLOSED, TINY, settled
from .summation import CHUNK


def mass_properties(
    vertices: ArrayLike, faces: Faces, density: float = 1.0, *, threads: int | None = None
) -> tuple[float, Array, Array]:
    """Mass, centroid (3,) and inertia tensor about the centroid (3, 3): no object, no topology checks.

    vertices  (n, 3)
    faces     (m, k) integers, lists of any lengths or Corners: any planar polygons, counter-clockwise from outside
    density   mass per cubed length unit
    threads   None for as many as there are processors, where there are faces enough

    Contiguous arrays of float64, and int32 or int64, are never copied. Off-diagonals of the inertia are minus the
    products. Numbers out of range, coordinates that are not finite and the closure residual are checked: use
    Polyhedron where flipped faces and holes are to be found and named.
    Raises GeometryError if the density is not positive, or the faces do not close, turn inward, or name vertices
    that are not there.
    """
    mass = _density(density)
    points = _points(vertices)
    if threads is not None and threads not in range(1, 1025):
        refuse_arrays(f"threads = {threads!r}", "1 to 1024, or None, is needed")
    numbers = _native(faces)
    if numbers is not None and numbers.shape[1] == 3:
        found = _few(points, numbers) if len(numbers) <= CHUNK else None
        if found is None:
            source = Triangles(vertices=points, triangles=numbers, threads=threads)
            found = _many(source, numbers.reshape(-1))
    elif numbers is not None:
        count, corners = numbers.shape
        indices, offsets = numbers.reshape(-1), np.arange(count + 1) * corners
        found = _many(Polygons(vertices=points, indices=indices, offsets=offsets, threads=threads), indices)
    else:
        try:
            indices, offsets = corner_lists(faces)
        except (TypeError, ValueError) as error:
            refuse_arrays("faces", f"an integer array (m, k) or lists of vertex numbers are needed ({error})")
        found = _many(Polygons(vertices=points, indices=indices, offsets=offsets, threads=threads), indices)
    volume, centroid, inertia = found
    return mass * volume, centroid, mass * inertia


def _density(density: object) -> float:
    if type(density) is float and 0.0 < density < np.inf:
        return density  # the usual case, at once
    (number,) = numbers_in(density) or [np.nan]
    if not number > 0.0:
        message = "a positive number is needed: mass per cubed length unit"
        raise GeometryError("These faces have no mass", [Problem(f"density = {density!r}", message)])
    return number


def _points(vertices: ArrayLike) -> Array:
    try:
        given = np.asarray(vertices)
        points = np.ascontiguousarray(given, np.float64) if given.dtype.kind in "fiub" else np.empty(0)
    except (TypeError, ValueError):
        given = points = np.empty(0)
    if points.ndim != 2 or points.shape[1] != 3:
        refuse_arrays(f"vertices of shape {given.shape}", "an array (n, 3) of numbers is needed")
    return points


def _native(faces: object) -> Any:
    """Faces as a contiguous array (m, k) of int32 or int64, not copied where they are one; None if they are none."""
    if not isinstance(faces, np.ndarray) or faces.ndim != 2 or faces.dtype.kind != "i":
        return None
    kept = faces.dtype in (np.int32, np.int64) and faces.dtype.isnative
    return np.ascontiguousarray(np.asarray(faces), None if kept else np.int64)


def _few(points: Array, triangles: Any) -> tuple[float, Array, Array] | None:
    """Volume, centroid and inertia; None where the sums must be looked at more closely."""
    from .kernels.answers import answers

    place, values, centroid, inertia = answers(points, triangles, unsigned(triangles))
    if place >= 0:
        require_corners(triangles[place // 3], place // 3, len(points))
    volume, closure, of_volume, of_second, largest = values
    enough = volume > TINY and TINY < largest < np.inf
    if closure <= CLOSED and enough and max(of_volume, of_second) <= AMPLIFICATION_LIMIT:
        return float(volume), centroid, inertia
    return None


def _many(source: Triangles | Polygons, numbers: Any) -> tuple[float, Array, Array]:
    origin = middle(source.vertices, numbers)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
        moments = settled(source, origin, source.sums(origin))
        body = moments.body
        inertia = inertia_tensor(body.central_second) if body.volume > 0.0 else np.zeros((3, 3))
    if not (moments.closure <= CLOSED and body.volume > 0.0):
        _refuse_open(source.vertices, numbers, moments.closure, body.volume)
    if not (np.all(np.isfinite(inertia)) and np.all(np.isfinite(body.centroid)) and np.trace(inertia) > 0.0):
        size = float(np.max(np.abs(source.box)))
        refuse_arrays(f"coordinates up to {size:.3g}", "their fifth powers are no numbers; take another length unit")
    return body.volume, body.centroid, inertia


def _refuse_open(points: Array, numbers: Any, closure: float, volume: float) -> None:
    used = np.unique(numbers)
    bad = used[~np.isfinite(points[used]).all(axis=1)]
    if len(bad):
        refuse_arrays(f"vertex {bad[0]} = {points[bad[0]].tolist()}", "coordinates must be finite")
    raise GeometryError(
        "These faces do not bound a solid",
        [
            Problem(
                f"closure residual {closure:.2g}, volume {volume:.6g}",
                "a residual near 0 and a positive volume are needed; usual causes are missing faces and faces"
                " turned inward; Polyhedron(vertices, faces).validity() names them",
            )
        ],
    )

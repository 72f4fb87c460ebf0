"""Mass properties of arrays, at the least cost a call."""

from __future__ import annotations

from typing import Any, NoReturn

import numpy as np

from ..arrays import Array, ArrayLike
from ..errors import GeometryError, Problem
from .faces import Corners, Faces, corner_lists
from .indexed import Polygons, Triangles, middle, require_corners, unsigned
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
    if not 0.0 < density < np.inf:
        problem = Problem(f"density = {density!r}", "a positive number is needed: mass per cubed length unit")
        raise GeometryError("These faces have no mass", [problem])
    points = np.ascontiguousarray(vertices, np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        _refuse(f"vertices of shape {points.shape}", "an array (n, 3) is needed")
    if isinstance(faces, np.ndarray) and faces.ndim == 2 and faces.dtype.kind == "i":
        if faces.dtype.itemsize < 4 or not faces.flags.c_contiguous:
            faces = np.ascontiguousarray(faces, np.int64)
        if faces.shape[1] == 3:
            if len(faces) <= CHUNK:
                found = _few(points, faces)
                if found is not None:
                    return density * found[0], found[1], density * found[2]
            return _many(Triangles(vertices=points, triangles=faces, threads=threads), faces.reshape(-1), density)
    try:
        indices, offsets = _corners(faces)
    except (TypeError, ValueError) as error:
        _refuse("faces", f"an integer array (m, k) or lists of vertex numbers are needed ({error})")
    return _many(Polygons(vertices=points, indices=indices, offsets=offsets, threads=threads), indices, density)


def _corners(faces: Faces) -> Corners:
    if isinstance(faces, np.ndarray) and faces.ndim == 2 and faces.dtype.kind == "i":
        count, corners = faces.shape
        return Corners(faces.reshape(-1), np.arange(count + 1) * corners)
    return corner_lists(faces)


def _few(points: Array, triangles: Any) -> tuple[float, Array, Array] | None:
    """Volume, centroid and inertia; None where the sums must be looked at more closely."""
    from .kernels.answers import answers

    place, values, centroid, inertia = answers(points, triangles, unsigned(triangles))
    if place >= 0:
        require_corners(triangles[place // 3], place // 3, len(points))
    volume, closure, of_volume, of_second, largest = values
    if closure <= CLOSED and volume > TINY and max(of_volume, of_second) <= AMPLIFICATION_LIMIT and largest < np.inf:
        return float(volume), centroid, inertia
    return None


def _many(source: Triangles | Polygons, numbers: Any, density: float) -> tuple[float, Array, Array]:
    origin = middle(source.vertices, numbers)
    moments = settled(source, origin, source.sums(origin))
    body = moments.body
    if not (moments.closure <= CLOSED and body.volume > 0.0):
        _refuse_open(source.vertices, moments.closure, body.volume)
    return density * body.volume, body.centroid, density * inertia_tensor(body.central_second)


def _refuse_open(points: Array, closure: float, volume: float) -> None:
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad) and not np.isfinite(closure):
        _refuse(f"vertex {bad[0]} = {points[bad[0]].tolist()}", "coordinates must be finite")
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


def _refuse(subject: str, message: str) -> NoReturn:
    raise GeometryError("These arrays are not a polyhedron", [Problem(subject, message)])

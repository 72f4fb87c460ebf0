"""How far a polyhedron is from a solid's exact surface, and that surface from the polyhedron."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Array, Indices
from ..boundary.nearness import Skin
from ..moments.faces import triangle_vectors
from .nearest_triangles import distances_to_triangles
from .polyhedron import Polyhedron

_FINE = 1.0 / 24.0  # of the body's diagonal: sides of triangles beyond which more points of them are looked at
_MOST_CUTS = 8  # a side of a triangle


@dataclass(frozen=True, kw_only=True, eq=False)
class Extreme:
    """Where a deviation is largest.

    distance   signed: outside the solid's surface is positive
    point      (3,) where; of the file's body, or of the solid for what the body lacks
    face       number of the solid's face, patches before caps
    """

    distance: float
    point: Array
    face: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Deviation:
    """Deviations of a body's surface from a solid's.

    outward, inward   the largest and the least signed distance of points of the body from the solid's surface
    lacking           the largest distance of points of the solid's surface from the body's
    rms               root mean square over the body's area
    points            how many of the body's were looked at
    """

    outward: Extreme
    inward: Extreme
    lacking: Extreme
    rms: float
    points: int

    def moved(self, rotation: Array, shift: Array) -> Deviation:
        """With its points moved by r → R r + t."""
        extremes = (
            Extreme(distance=one.distance, point=rotation @ one.point + shift, face=one.face)
            for one in (self.outward, self.inward, self.lacking)
        )
        outward, inward, lacking = extremes
        return Deviation(outward=outward, inward=inward, lacking=lacking, rms=self.rms, points=self.points)

    def to_dict(self) -> dict[str, Any]:
        return {"rms": self.rms, "points": self.points}


def deviation(body: Polyhedron, skin: Skin, sag: float, *, smooth: bool = False) -> Deviation:
    """Deviations of a body from the solid of a skin, in the same frame.

    sag      (length) of the chords by which the borders of the solid's end faces are told from what lies beside them
    smooth   whether the body stands for a smooth one on which only its vertices lie

    Raises GeometryError if a face of the body cannot be cut into triangles.
    """
    triangles = body.simple_triangles()
    points, weights = surface_points(body.vertices, triangles, inside=not smooth)
    distances, faces = skin.nearest_faces(points, sag)
    back = distances_to_triangles(skin.points, body.vertices, triangles)
    out, deep, far = (int(f(d)) for f, d in ((np.argmax, distances), (np.argmin, distances), (np.argmax, back)))
    total = float(weights.sum())
    square = float(weights @ distances**2) / total if total > 0.0 else float(np.mean(distances**2))
    return Deviation(
        outward=Extreme(distance=max(float(distances[out]), 0.0), point=points[out], face=int(faces[out])),
        inward=Extreme(distance=min(float(distances[deep]), 0.0), point=points[deep], face=int(faces[deep])),
        lacking=Extreme(distance=float(back[far]), point=skin.points[far], face=int(skin.owners[far])),
        rms=float(np.sqrt(square)),
        points=len(points),
    )


def surface_points(vertices: Array, triangles: Indices, *, inside: bool) -> tuple[Array, Array]:
    """Points (n, 3) all over triangles, and weights (n,) that integrate over them.

    The vertices; with `inside` also the middles, and where a triangle is long for the body more points of it, as if it
    were cut. Vertices and middle weigh 1/12 and 3/4 of a triangle: exact for squares of what is linear on it.
    """
    areas = np.linalg.norm(triangle_vectors(vertices, triangles), axis=1) / 2.0
    used = np.unique(triangles)
    weights = np.zeros(len(vertices))
    np.add.at(weights, triangles, areas[:, None] * (1.0 / 12.0 if inside else 1.0 / 3.0))
    if not inside:
        return vertices[used], weights[used]
    corners = vertices[triangles]
    diagonal = float(np.linalg.norm(np.ptp(vertices[used], axis=0)))
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    cuts = np.clip(np.ceil(longest / (_FINE * diagonal)), 1, _MOST_CUTS).astype(int) if diagonal else np.ones(0, int)
    points, shares = [vertices[used]], [weights[used]]
    for n in np.unique(cuts):
        lattice = _lattice(int(n))
        points.append((lattice @ corners[cuts == n]).reshape(-1, 3))
        shares.append(np.repeat(areas[cuts == n] * (0.75 / len(lattice)), len(lattice)))
    return np.concatenate(points), np.concatenate(shares)


def _lattice(cuts: int) -> Array:
    """Barycentric coordinates (cuts², 3) of the middles of the triangles into which equal cuts part one."""
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(cuts), np.arange(cuts)))
    up = np.stack([i, j], axis=1)[i + j < cuts] + 1.0 / 3.0
    down = np.stack([i, j], axis=1)[i + j < cuts - 1] + 2.0 / 3.0
    first = np.concatenate([up, down]) / cuts
    return np.concatenate([first, 1.0 - first.sum(axis=1, keepdims=True)], axis=1)

"""Polyhedra with play: every face moved inward, so that parts that would touch are apart when they are printed."""

from __future__ import annotations

import numpy as np

from ..arrays import Array, Indices
from ..errors import GeometryError, Problem
from ..moments.faces import Corners, face_vectors, next_corners
from .polyhedron import Polyhedron

_SAME = 0.02
"""Where normals of faces at a vertex determine an equation worse than this, singular values relative to the largest,
they are of one smooth surface: planes at an angle θ up to 0.04 are met by their middle one, to θ²/8 of the depth."""

_FLAT = 1e-10
"""Area of a face, in squares of the diagonal of its box, below which it has no normal."""

_ONE_PLANE = 1e-7
"""Of unit normals: faces at a vertex whose normals agree so far count as one."""

_SWEEPS, _DECAY = 100, 0.995
"""Of the smoothing along the faces: it reaches over some 14 vertices."""

_STEPS, _MOST_HALVINGS = 7, 20
"""Halvings in the search for the largest clearance: so many once one was found that goes, at most so many in all."""


def with_clearance(body: Polyhedron, clearance: float) -> Polyhedron:
    """The body with every face moved inward by half of a clearance (length), so that two such parts have that gap.

    Faces at a vertex that meet in a common point are moved exactly, flat faces stay flat; on smooth surfaces the depth
    is kept to a few hundredths. Vertices keep their numbers, so that what is closed stays closed.
    Raises GeometryError for a clearance that is none, or with the limit, where faces would turn over or pass through
    each other.
    """
    if not 0.0 <= clearance < np.inf:
        wanted = "a finite length from 0 is needed"
        raise GeometryError("Parts have no such play", [Problem(f"clearance = {clearance!r}", wanted)])
    if clearance == 0.0:
        return body
    units, sound = _unit_normals(body)
    steps = _steps(body, units, sound)
    least, face = _first_turned(body, steps, units, sound)
    if clearance / 2.0 < least:
        moved = _moved(body, steps, clearance / 2.0)
        if not (spoilt := _spoilt(body, moved)):
            return moved
        least, what = _first_spoilt(body, steps, clearance / 2.0), spoilt
    else:
        x, y, z = body.vertices[body.indices[body.offsets[face]]]
        what = f"face {face} near ({x:.6g}, {y:.6g}, {z:.6g}) turns over: the part is no thicker there"
    limit = f"it must be less than {_rounded_down(2.0 * least):.3g}" if least > 0.0 else "it bears none"
    raise GeometryError(
        "This clearance is too large for the part",
        [
            Problem(
                f"clearance = {clearance:g}", f"{what}; {limit}; a coarser tolerance, with longer edges, may bear more"
            )
        ],
    )


def _moved(body: Polyhedron, steps: Array, depth: float) -> Polyhedron:
    return Polyhedron(body.vertices + depth * steps, Corners(body.indices, body.offsets), rounding=body.rounding)


def _steps(body: Polyhedron, units: Array, sound: Array) -> Array:
    """By how much (n, 3) vertices move for each unit of length that faces move inward.

    n·d = −1 for the unit normals n of a vertex's faces, each plane once: exactly where up to three planes meet, by
    least squares where more do that have no common point. What these leave open, sliding along a face or an edge, is
    such that neighbours move alike: points next to a border then go with it, and triangles there do not turn over.
    """
    faces = np.repeat(np.arange(len(units)), np.diff(body.offsets))
    vertices, normals = _each_plane_once(body.indices[sound[faces]], units[faces[sound[faces]]])
    squares, sums = np.zeros((len(body.vertices), 3, 3)), np.zeros((len(body.vertices), 3))
    np.add.at(squares, vertices, normals[:, :, None] * normals[:, None, :])
    np.add.at(sums, vertices, normals)
    values, axes = np.linalg.eigh(squares)
    known = values > _SAME**2 * np.maximum(values[:, -1:], 1e-300)
    inverse = np.divide(1.0, values, out=np.zeros_like(values), where=known)
    needed = -np.einsum("nij,nj,nkj,nk->ni", axes, inverse, axes, sums)
    free = np.einsum("nij,nj,nkj->nik", axes, (~known).astype(float), axes)
    averages = _averages(body)
    found = needed
    for _ in range(_SWEEPS):
        found = needed + np.einsum("nij,nj->ni", free, averages @ found)
    return np.asarray(found)


def _averages(body: Polyhedron) -> Array:
    """A sparse matrix (n, n) that gives every vertex the mean of its neighbours, a little less than that."""
    from scipy.sparse import coo_array

    ends = np.stack([body.indices, next_corners(body.indices, body.offsets)])
    ends = np.unique(np.concatenate([ends, ends[::-1]], axis=1), axis=1)
    count = len(body.vertices)
    degrees = np.bincount(ends[0], minlength=count)
    return coo_array((_DECAY / degrees[ends[0]], (ends[0], ends[1])), shape=(count, count)).tocsr()


def _unit_normals(body: Polyhedron) -> tuple[Array, Array]:
    """Of every face (f, 3), and which faces (f,) are large enough to have one."""
    vectors = face_vectors(body.vertices, body.indices, body.offsets)
    areas = np.linalg.norm(vectors, axis=1)
    points = body.vertices[body.indices]
    low = np.minimum.reduceat(points, body.offsets[:-1], axis=0)
    high = np.maximum.reduceat(points, body.offsets[:-1], axis=0)
    sound = areas > _FLAT * np.sum((high - low) ** 2, axis=1)
    return vectors / np.where(areas > 0.0, areas, 1.0)[:, None], sound


def _each_plane_once(vertices: Indices, normals: Array) -> tuple[Indices, Array]:
    """Pairs of a vertex (k,) and a normal (k, 3) without those whose vertex has nearly the same normal already."""
    cells = np.round(normals / _ONE_PLANE).astype(np.int64)
    order = np.lexsort((*cells.T, vertices))
    v, c = vertices[order], cells[order]
    first = np.ones(len(order), bool)
    first[1:] = (v[1:] != v[:-1]) | (np.abs(c[1:] - c[:-1]).max(axis=1) > 1)
    return v[first], normals[order[first]]


def _first_turned(body: Polyhedron, steps: Array, units: Array, sound: Array) -> tuple[float, int]:
    """The least depth at which a face has no area left that looks as it did, and that face.

    The vertices move straight, so the area is a polynomial of degree 2 in the depth.
    """
    depth = float(np.linalg.norm(np.ptp(body.vertices, axis=0)))
    zero, half, one = (
        np.einsum("ij,ij->i", face_vectors(body.vertices + t * depth * steps, body.indices, body.offsets), units)
        for t in (0.0, 0.5, 1.0)
    )
    square, slope = 2.0 * (zero - 2.0 * half + one), -3.0 * zero + 4.0 * half - one
    # 2 zero / (−slope ± root), the form without cancellation, gives both roots
    root = np.sqrt(np.maximum(slope**2 - 4.0 * square * zero, 0.0))
    real = sound & (slope**2 >= 4.0 * square * zero)
    with np.errstate(divide="ignore", invalid="ignore"):
        roots = np.stack([2.0 * zero / (-slope + root), 2.0 * zero / (-slope - root)])
    roots[~(real & (roots > 0.0))] = np.inf
    least = roots.min(axis=0)
    face = int(np.argmin(least))
    return depth * float(least[face]), face


def _spoilt(body: Polyhedron, moved: Polyhedron) -> str:
    """What is wrong with the moved body that was not with the body, in words; empty where nothing is."""
    crossings = moved.self_intersections()
    if crossings and crossings.count > body.self_intersections().count:
        x, y, z = crossings.points[0]
        return f"faces near ({x:.6g}, {y:.6g}, {z:.6g}) pass through each other"
    new = [problem for kind, problem in moved.validity().found.items() if kind not in body.validity().found]
    return f"walls vanish: {new[0]}" if new else ""


def _first_spoilt(body: Polyhedron, steps: Array, too_deep: float) -> float:
    """A depth at which nothing is wrong yet, near the largest such."""
    low, high, left = 0.0, too_deep, _MOST_HALVINGS
    while left:
        left = min(left - 1, _STEPS) if low > 0.0 else left - 1
        middle = (low + high) / 2.0
        low, high = (low, middle) if _spoilt(body, _moved(body, steps, middle)) else (middle, high)
    return low


def _rounded_down(length: float) -> float:
    """To three digits."""
    digit = 10.0 ** (np.floor(np.log10(length)) - 2.0)
    return float(np.floor(length / digit) * digit)

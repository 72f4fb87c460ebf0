"""Which face of a boundary each triangle of its polyhedron belongs to, and how far the two are apart."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from gearwright.boundary.boundary import Boundary
from gearwright.boundary.faces import Patch
from gearwright.boundary.sampling import sampling
from gearwright.boundary.tessellation import tessellate


@dataclass(frozen=True)
class PatchFacets:
    """Triangles of one patch's first image: corners (m, 3, 3) and their fractions (u, v) on the patch (m, 3, 2)."""

    patch: Patch
    columns: int
    layers: int
    corners: np.ndarray
    fractions: np.ndarray

    def subset(self, random: np.random.Generator, most: int) -> PatchFacets:
        """The same with no more triangles than so many, at random."""
        if len(self.corners) <= most:
            return self
        chosen = random.choice(len(self.corners), most, replace=False)
        return replace(self, corners=self.corners[chosen], fractions=self.fractions[chosen])


@dataclass(frozen=True)
class Facets:
    """A polyhedron's triangles sorted by the faces they approximate; caps: (surface, corners)."""

    vertices: np.ndarray
    triangles: np.ndarray
    patches: list[PatchFacets]
    caps: list[tuple[object, np.ndarray]]


def facets(boundary: Boundary, tolerance: float) -> Facets:
    """Sorts by position: a patch's corners are found on its grid, a cap's by their distance from its surface."""
    cut = sampling(boundary, tolerance)
    vertices, triangles = tessellate(boundary, cut)
    near = 1e-11 * float(np.ptp(vertices, axis=0).max())
    tree = cKDTree(vertices)
    patches = []
    for patch in boundary.patches:
        columns, layers = cut.segments[patch.sides[0].edge], cut.segments[patch.sides[1].edge]
        patches.append(_patch_facets(patch, columns, layers, vertices, triangles, tree, near))
    caps = []
    for cap in boundary.caps:
        flat = (cap.surface.deviation(vertices) < near)[triangles].all(axis=1)
        caps.append((cap.surface, vertices[triangles[flat]]))
    return Facets(vertices, triangles, patches, caps)


def _patch_facets(patch, columns, layers, vertices, triangles, tree, near) -> PatchFacets:
    u, v = (a.ravel() for a in np.meshgrid(np.arange(columns + 1), np.arange(layers + 1), indexing="ij"))
    grid = patch.point(u / columns, v / layers)
    distance, number = tree.query(grid)
    assert distance.max() < near, "a point of a patch's grid is no vertex"
    place = np.full((len(vertices), 2), -1)
    order = np.lexsort((-v, -u))  # where a patch closes on itself a vertex takes its first place
    place[number[order]] = np.stack([u, v], axis=1)[order]
    own = triangles[(place[triangles] >= 0).all(axis=(1, 2))]
    at = place[own]
    for axis, last in enumerate((columns, layers)):
        seam = (at[..., axis].max(axis=1) - at[..., axis].min(axis=1)) > 1
        at[..., axis] = np.where(seam[:, None] & (at[..., axis] == 0), last, at[..., axis])
    on_border = (at[..., 1] == at[:, :1, 1]).all(axis=1) | (at[..., 0] == at[:, :1, 0]).all(axis=1)
    return PatchFacets(patch, columns, layers, vertices[own[~on_border]], at[~on_border] / [columns, layers])


def barycentric(steps: int) -> np.ndarray:
    """Weights (n, 3) of points all over a triangle."""
    return np.array([(a, b, steps - a - b) for a in range(steps + 1) for b in range(steps + 1 - a)]) / steps


def distance_to_patch(found: PatchFacets, steps: int) -> np.ndarray:
    """Distance (m, n) of points all over the triangles from the smooth patch, by Gauss–Newton on (u, v)."""
    weights = barycentric(steps)
    points = np.einsum("nk,mkd->mnd", weights, found.corners)
    at = np.einsum("nk,mkd->mnd", weights, found.fractions)
    for _ in range(8):
        du, dv = found.patch.partials(at[..., 0], at[..., 1])
        off = points - found.patch.point(at[..., 0], at[..., 1])
        uu, uv, vv = ((a * b).sum(-1) for a, b in ((du, du), (du, dv), (dv, dv)))
        u, v = (off * du).sum(-1), (off * dv).sum(-1)
        determinant = uu * vv - uv * uv
        determinant = np.where(determinant > 1e-14 * uu * vv, determinant, np.inf)
        step = np.stack([vv * u - uv * v, uu * v - uv * u], axis=-1) / determinant[..., None]
        at = np.clip(at + step, 0.0, 1.0)
    return np.linalg.norm(points - found.patch.point(at[..., 0], at[..., 1]), axis=-1)


def distance_from_patch(found: PatchFacets, random: np.random.Generator, samples: int) -> np.ndarray:
    """Distance (n,) of points of the smooth patch from the triangles of the cell they belong to."""
    cells = np.floor(found.fractions.mean(axis=1) * [found.columns, found.layers]).astype(int)
    numbers = cells @ [found.layers, 1]
    first = np.full(found.columns * found.layers, -1)
    second = first.copy()
    order = np.argsort(numbers, kind="stable")
    first[numbers[order[::-1]]] = order[::-1]
    second[numbers[order]] = order
    at = random.random((samples, 2))
    cell = np.floor(at * [found.columns, found.layers]).astype(int) @ [found.layers, 1]
    points = found.patch.point(at[:, 0], at[:, 1])
    return np.minimum(*(distance_to_triangles(points, found.corners[one[cell]]) for one in (first, second)))


def distance_to_triangles(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Distance (n,) of points (n, 3), each from its own triangle (n, 3, 3)."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    inside = np.ones(len(points), bool)
    nearest = np.full(len(points), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("nd,nd->n", np.cross(q - p, points - p), normal) >= 0.0
        along = np.einsum("nd,nd->n", points - p, q - p) / np.einsum("nd,nd->n", q - p, q - p)
        foot = p + np.clip(along, 0.0, 1.0)[:, None] * (q - p)
        nearest = np.minimum(nearest, np.linalg.norm(points - foot, axis=1))
    return np.where(inside, np.abs(np.einsum("nd,nd->n", points - a, normal)), nearest)


def flatness(corners: np.ndarray) -> np.ndarray:
    """Smallest altitude over longest side (m,) of triangles (m, 3, 3): 0.87 if equilateral, 0 if flat."""
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=-1)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return area / sides.max(axis=1) ** 2

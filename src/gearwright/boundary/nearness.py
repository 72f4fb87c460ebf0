"""How far points are from the true surface of a body, and on which side of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, Indices
from ..curves.curve import in_panels
from .boundary import Boundary
from .extent import rough_diagonal
from .faces import Cap, Patch
from .flat import segments_for
from .outlines import windings

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

_GRID = 9  # samples a side of a patch, and a panel, at least
_MOST_STEPS = 48  # between samples along a side
_FINE = 1.0 / 24.0  # of the body's diagonal: longer steps are taken shorter
_NEAREST = 24  # samples of which those first in their patches are where a point's foot is searched from
_STEPS = 30  # of Gauss–Newton, at most; it is quadratic where the surface is nearer than its radius of curvature
_ASIDE = 0.02  # of a patch's width: where a search begins
_BORDER = 1e-9  # of it: how near to the border a search goes; at a cusp on it, as involutes have, no step leads away
_STILL = 1e-14  # of a patch's width: a step that moves no point any more
_MOST_STARTS = 6  # patches from which places of least distance are searched
_SHRINKAGES = 13  # halvings of the grids on which they are: the last is 1/65536 of a patch wide
_STAR = np.stack(np.meshgrid(*2 * [np.linspace(-1.0, 1.0, 5)]), axis=-1).reshape(-1, 2)


@dataclass(frozen=True, eq=False)
class Skin:
    """A body's boundary with points all over its patches, in every image.

    points (n, 3) of patch `owners` (n,) in image `images` (n,) at fractions (n, 2)
    cover (patches,)   how far (length) a point of a patch is from the nearest of its samples, at most, about
    """

    boundary: Boundary
    points: Array
    owners: Indices
    images: Indices
    fractions: Array
    cover: Array

    @classmethod
    def of(cls, boundary: Boundary) -> Skin:
        step = _FINE * rough_diagonal(boundary)
        nothing = np.empty(0, np.int64)
        clouds, owners, images, fractions = [np.empty((0, 3))], [nothing], [nothing], [np.empty((0, 2))]
        cover = np.zeros(len(boundary.patches))
        for i, patch in enumerate(boundary.patches):
            grid, cover[i] = _grid(patch, step)
            order = patch.pattern.order
            clouds.append(patch.pattern.images(patch.point(*grid.T)).reshape(-1, 3))
            owners.append(np.full(order * len(grid), i))
            images.append(np.repeat(np.arange(order), len(grid)))
            fractions.append(np.tile(grid, (order, 1)))
        points, numbers = np.concatenate(clouds), (np.concatenate(owners), np.concatenate(images))
        return cls(boundary, points, *numbers, np.concatenate(fractions), cover)

    def nearest_to(self, other: Skin, eligible: Indices, sag: float) -> tuple[Array, Array]:
        """Places (k, 3) on this body's patches that come locally nearest to another body, and signed distances (k,).

        Searched from the nearest points (indices) of up to so many patches, on grids that shrink around the best.
        """
        starts = self._starts(other, eligible, sag)
        at, width = self.fractions[starts], np.full(len(starts), 1.0 / (_GRID - 1))
        places, found = self.points[starts], np.full(len(starts), np.inf)
        for _ in range(_SHRINKAGES):
            tried = np.clip(at[:, None, :] + width[:, None, None] * _STAR, 0.0, 1.0)
            points = np.stack([self._placed(start, uv) for start, uv in zip(starts, tried, strict=True)])
            distances = other.signed_distance(points.reshape(-1, 3), sag).reshape(points.shape[:2])
            best = np.argmin(distances, axis=1)
            rows = np.arange(len(starts))
            at, places, found = tried[rows, best], points[rows, best], distances[rows, best]
            width = width / 2.0
        return places, found

    def _starts(self, other: Skin, eligible: Indices, sag: float) -> Indices:
        """The nearest points, by number, to another body of those few patches that have the nearest."""
        distances = other.signed_distance(self.points[eligible], sag)
        order = eligible[np.argsort(distances)]
        faces = self.owners[order] * (1 + self.images.max()) + self.images[order]
        _, first = np.unique(faces, return_index=True)
        return order[np.sort(first)][:_MOST_STARTS]

    def _placed(self, start: int, fractions: Array) -> Array:
        """Points (n, 3) at fractions (n, 2) of the patch and image that a point belongs to."""
        patch = self.boundary.patches[self.owners[start]]
        return patch.pattern.image(int(self.images[start])).points(patch.point(*fractions.T))

    @cached_property
    def _tree(self) -> cKDTree:
        from scipy.spatial import cKDTree

        return cKDTree(self.points)

    def _candidates(self, points: Array) -> tuple[Indices, Indices]:
        """Points and samples, by number, from which the points' feet are searched: one in each patch that is near."""
        count = min(_NEAREST, len(self.points))
        if not count:
            return np.empty(0, np.int64), np.empty(0, np.int64)
        off, nearest = (found.reshape(len(points), count) for found in self._tree.query(points, k=count))
        faces = self.owners[nearest] * (1 + self.images.max()) + self.images[nearest]
        order = np.argsort(faces, axis=1, kind="stable")
        sorted_faces = np.take_along_axis(faces, order, axis=1)
        first = np.diff(sorted_faces, axis=1, prepend=-1) > 0
        # what is farther by more than a patch's cover is not nearest
        first &= np.take_along_axis(off - self.cover[self.owners[nearest]], order, axis=1) <= off[:, :1]
        rows, places = np.nonzero(first)
        listed = [(rows, nearest[rows, order[rows, places]]), *self._beyond(points, off[:, 0], off[:, -1])]
        found_rows, found = zip(*listed, strict=True)
        return np.concatenate(found_rows), np.concatenate(found)

    def _beyond(self, points: Array, least: Array, most: Array) -> Iterator[tuple[Indices, Indices]]:
        """Candidates of patches sampled so widely that they may be nearest though none of their samples is among those.

        least, most   (n,) distances of the first and the last sample looked at
        """
        if len(self.points) <= _NEAREST:
            return
        for owner, cover in enumerate(self.cover):
            rows = np.flatnonzero(most - cover < least)
            if not len(rows):
                continue
            off, sample = self._tree_of(owner).query(points[rows])
            near = (off >= most[rows]) & (off - cover <= least[rows])
            yield rows[near], np.flatnonzero(self.owners == owner)[sample[near]]

    def _tree_of(self, owner: int) -> cKDTree:
        from scipy.spatial import cKDTree

        return cKDTree(self.points[self.owners == owner])

    @staticmethod
    def _in_sector(patch: Patch, points: Array, images: Indices) -> Array:
        """Points (n, 3) turned from their images (n,) of a patch to its first."""
        local = points.copy()
        for k in np.unique(images):
            if k:
                local[images == k] = patch.pattern.image(int(k)).points_back(points[images == k])
        return local

    def signed_distance(self, points: Array, sag: float) -> Array:
        """Distance (n,) of points (n, 3) from the surface: negative inside, for points near it.

        Next to an edge, where the foot is no foot of a perpendicular, a point counts as outside.
        sag   of the chords of caps' borders, to tell what lies over a cap
        """
        return self.nearest_faces(points, sag)[0]

    def nearest_faces(self, points: Array, sag: float) -> tuple[Array, Indices]:
        """Signed distances (n,) as above, and which of the patches, and of the caps after them, are nearest (n,)."""
        found, faces = np.full(len(points), np.inf), np.full(len(points), -1)
        rows, starts = self._candidates(points)
        owners = self.owners[starts]
        for owner in np.unique(owners):
            patch, chosen = self.boundary.patches[owner], np.flatnonzero(owners == owner)
            local = self._in_sector(patch, points[rows[chosen]], self.images[starts[chosen]])
            distance = _from_patch(patch, local, self.fractions[starts[chosen]])
            # several images of the patch may be near one point: the nearest counts
            order = np.argsort(-np.abs(distance), kind="stable")
            nearest = np.full(len(points), np.inf)
            nearest[rows[chosen][order]] = distance[order]
            _take_nearer(found, faces, nearest, owner)
        for number, cap in enumerate(self.boundary.caps, start=len(self.boundary.patches)):
            _take_nearer(found, faces, _from_cap(cap, points, sag), number)
        return found, faces

    def sampled_distance(self, points: Array) -> Array:
        """Distance (n,) of points (n, 3) from the nearest of the skin's points: quick, and too large."""
        return np.asarray(self._tree.query(points)[0])


def _grid(patch: Patch, step: float) -> tuple[Array, float]:
    """Fractions (n, 2) of the samples of a patch, no farther apart than a step unless too many; their cover."""
    counts = np.array([_GRID - 1, _GRID - 1])
    while True:
        along = np.arange(counts[0] + 1) / counts[0]
        up = in_panels(patch.panels, np.arange(counts[1]) / counts[1], last=True)
        grid = np.stack(np.meshgrid(along, up), axis=-1)
        points = patch.point(grid[..., 0], grid[..., 1])
        sides = [np.max(np.linalg.norm(np.diff(points, axis=k), axis=-1)) for k in (1, 0)]
        wanted = np.minimum(np.ceil(counts * np.array(sides) / step), _MOST_STEPS).astype(int)
        if np.all(wanted <= counts):
            return grid.reshape(-1, 2), float(np.hypot(*sides)) / 2.0
        counts = np.maximum(wanted, counts)


def _take_nearer(found: Array, faces: Indices, distance: Array, face: int) -> None:
    """Puts distances (n,) from a face where they are less than those found, and the face's number beside them."""
    nearer = np.abs(distance) < np.abs(found)
    found[nearer], faces[nearer] = distance[nearer], face


def _from_patch(patch: Patch, points: Array, start: Array) -> Array:
    """Signed distance (n,) of points (n, 3) from a patch, their feet searched from fractions (n, 2)."""
    at = np.clip(start, _ASIDE, 1.0 - _ASIDE)
    moving = np.arange(len(points))
    for _ in range(_STEPS):
        before = at[moving]
        at[moving] = _stepped(patch, points[moving], before)
        moving = moving[np.max(np.abs(at[moving] - before), axis=1) >= _STILL]
        if not len(moving):
            break
    at = np.where(at <= _BORDER, 0.0, np.where(at >= 1.0 - _BORDER, 1.0, at))
    off = points - patch.point(*at.T)
    distance = np.linalg.norm(off, axis=1)
    normal = patch.area_vector(*at.T)
    length = np.linalg.norm(normal, axis=1)
    along = np.sum(off * normal, axis=1)
    square = np.abs(along) > 0.999 * length * distance
    return np.where(square & (along < 0.0), -distance, distance)


def _stepped(patch: Patch, points: Array, at: Array) -> Array:
    """Fractions (n, 2) one step of Gauss–Newton nearer to the feet of points (n, 3), within the patch."""
    du, dv = patch.partials(*at.T)
    off = points - patch.point(*at.T)
    uu, uv, vv = (np.sum(a * b, axis=1) for a, b in ((du, du), (du, dv), (dv, dv)))
    u, v = np.sum(off * du, axis=1), np.sum(off * dv, axis=1)
    determinant = uu * vv - uv * uv
    determinant = np.where(determinant > 1e-14 * uu * vv, determinant, np.inf)
    found = at + np.stack([vv * u - uv * v, uu * v - uv * u], axis=1) / determinant[:, None]
    # where one fraction would leave the patch it stops at the border, and the other goes as far as is best there
    for stopped, other, own, right in ((0, 1, vv, v), (1, 0, uu, u)):
        inside = np.clip(found[:, stopped], _BORDER, 1.0 - _BORDER)
        beyond = inside != found[:, stopped]
        best = at[:, other] + (right - uv * (inside - at[:, stopped])) / np.where(own > 0.0, own, np.inf)
        found[:, other] = np.where(beyond, best, found[:, other])
        found[:, stopped] = inside
    return np.clip(found, _BORDER, 1.0 - _BORDER)


def _from_cap(cap: Cap, points: Array, sag: float) -> Array:
    """Signed distance (n,) of points (n, 3) from a cap; infinite where they do not lie over it."""
    polygons = [cap.surface.chart(loop.around(segments_for(sag))) for loop in cap.loops]
    result = np.full(len(points), np.inf)
    with np.errstate(divide="ignore", invalid="ignore"):
        charts = cap.surface.chart(points)  # not finite where the surface has no foot, as on a cone's axis
    chosen = np.flatnonzero(np.all(np.isfinite(charts), axis=1))
    turns = windings(charts[chosen], polygons)
    chosen, turns = chosen[turns != 0], turns[turns != 0]
    off = points[chosen] - cap.surface.point(charts[chosen])
    along = turns * np.sum(off * _normals(cap, charts[chosen]), axis=1)
    result[chosen] = np.linalg.norm(off, axis=1) * np.where(along >= 0.0, 1.0, -1.0)
    return result


def _normals(cap: Cap, charts: Array) -> Array:
    """Vectors (n, 3) along the surface's own normal at points (n, 2) of the chart."""
    h = 1e-4 * (1.0 + np.max(np.abs(charts), axis=1, initial=0.0))[:, None]
    a, b = (cap.surface.point(charts + h * step) - cap.surface.point(charts - h * step) for step in np.eye(2))
    return np.cross(a, b)

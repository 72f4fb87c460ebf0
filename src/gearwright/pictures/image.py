"""Bodies to a shaded image: z-buffer, light, lines and the ground's shadow put together, on all processors."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from .camera import Camera, towards_eye
from .colours import gamma, linear, toned
from .facets import Facets, facets
from .ground import ground_points, kept_light
from .lighting import Lamps, illumination, metal, settled, studio
from .renderer import CREASE_LINE, SILHOUETTE, collect, ink, rasterise

_LINE_COLOUR = np.array([0.055, 0.065, 0.08])
_CREASE_INK = 0.5
_SILHOUETTE_INK = 0.8
_FINE_PIXELS = 2_600_000
"""Pictures of more pixels take 2 × 2 sub-pixels instead of 3 × 3, to stay within some hundred megabytes."""


@dataclass(frozen=True, kw_only=True)
class Image:
    """colours (h, w, 3) sRGB 0…1;  owners (h, w) the body seen at the middle of each pixel, −1 the background."""

    colours: Array
    owners: NDArray[np.int16]


@dataclass(frozen=True, kw_only=True)
class _Visible:
    """What the camera sees in fineness × fineness sub-pixels a pixel.

    seen    (n, 3)  vertices in seen coordinates
    model           facets on the screen, in sub-pixels; normals along the seen axes
    depth, owner    nearness and triangle of each sub-pixel
    """

    camera: Camera
    fineness: int
    seen: Array
    model: Facets
    depth: NDArray[np.float32]
    owner: NDArray[np.int32]


@dataclass(frozen=True, kw_only=True)
class _Samples:
    """Surfaces in pixels, in reading order: seen points and normals (s, 3), shares (s,), row, column, body (s, 3)."""

    points: Array
    normals: Array
    shares: Array
    places: Indices


def image(
    bodies: Sequence[tuple[Array, Indices]], colours: Array, camera: Camera, size: tuple[int, int], background: Array
) -> Image:
    """The bodies, (vertices, triangles) each, as the camera sees them.

    colours (b, 3) of the bodies and background (3,) are sRGB; size is (width, height) in pixels. The ground under the
    bodies is drawn only where their shadow falls.
    """
    with ThreadPoolExecutor(_workers()) as pool:
        visible = _visible(pool, facets(bodies), camera, size)
        samples = _samples(pool, visible)
        ground = ground_points(camera, visible.seen, size)
        light, ground_light = _light(pool, visible, samples, ground)
        surface = _surface_colours(pool, samples, light, linear(colours), camera)
        lines = _lines(pool, visible)
    canvas = linear(background) * kept_light(ground_light, size)[..., None]
    canvas = _composed(canvas, surface, samples)
    canvas = canvas * (1.0 - lines[..., None]) + linear(_LINE_COLOUR) * lines[..., None]
    middle = slice(visible.fineness // 2, None, visible.fineness)
    members = np.append(visible.model.members, -1)  # the background's owner is −1
    return Image(colours=gamma(canvas), owners=members[visible.owner[middle, middle]].astype(np.int16))


def _visible(pool: ThreadPoolExecutor, model: Facets, camera: Camera, size: tuple[int, int]) -> _Visible:
    width, height = size
    fineness = 3 if width * height <= _FINE_PIXELS else 2
    seen = camera.seen(model.vertices)
    fine = replace(camera, pixels=camera.pixels * fineness, origin=camera.origin * fineness)
    model = replace(model, vertices=fine.screen(seen), normals=model.normals @ camera.rotation.T)
    depth = np.full((height * fineness, width * fineness), -np.inf, np.float32)
    owner = np.full(depth.shape, -1, np.int32)

    def band(rows: tuple[int, int]) -> None:
        rasterise(model.vertices, model.triangles, depth, owner, *rows)

    list(pool.map(band, _bands(height * fineness)))
    return _Visible(camera=fine, fineness=fineness, seen=seen, model=model, depth=depth, owner=owner)


def _samples(pool: ThreadPoolExecutor, visible: _Visible) -> _Samples:
    model, depth, owner, fineness = visible.model, visible.depth, visible.owner, visible.fineness

    def band(rows: tuple[int, int]) -> tuple[Array, Indices]:
        return collect(
            model.vertices, model.triangles, model.normals, model.members, depth, owner, fineness, *rows
        )  # fmt: skip

    made = list(pool.map(band, _bands(len(owner) // fineness)))
    values, places = (np.concatenate(parts) for parts in zip(*made, strict=True))
    return _Samples(
        points=visible.camera.unscreen(values[:, :3]),
        normals=np.ascontiguousarray(values[:, 3:6]),
        shares=values[:, 6],
        places=places,
    )


def _lines(pool: ThreadPoolExecutor, visible: _Visible) -> Array:
    """How much of each pixel lines cover, (h, w), 0…1."""
    model, depth, owner, fineness = visible.model, visible.depth, visible.owner, visible.fineness
    strength = np.zeros(256)
    strength[CREASE_LINE], strength[SILHOUETTE] = _CREASE_INK, _SILHOUETTE_INK

    def band(rows: tuple[int, int]) -> Array:
        first, stop = rows[0] * fineness, rows[1] * fineness
        marks = ink(model.vertices, model.triangles, model.normals, model.members, depth, owner, first, stop)
        return strength[marks].reshape(rows[1] - rows[0], fineness, -1, fineness).mean(axis=(1, 3))

    return np.concatenate(list(pool.map(band, _bands(len(owner) // fineness))))


def _light(pool: ThreadPoolExecutor, visible: _Visible, samples: _Samples, ground: Array) -> tuple[Array, Array]:
    """Illumination of the samples (s, 4) and of the ground (h', w', 4), the lamps shared among the processors."""
    up, pixel = visible.camera.up, visible.fineness / visible.camera.pixels
    points = np.concatenate([samples.points, ground.reshape(-1, 3)])
    normals = np.concatenate([samples.normals, np.broadcast_to(up, (ground.size // 3, 3))])
    places = np.concatenate([samples.places[:, :2], np.indices(ground.shape[:2]).reshape(2, -1).T])
    lamps = studio(up)

    def part(one: slice) -> Array:
        share = Lamps(directions=lamps.directions[one], strengths=lamps.strengths[one], kinds=lamps.kinds[one])
        return illumination(points, normals, places, visible.seen, visible.model.triangles, share)

    parts = pool.map(part, [slice(first, None, _workers()) for first in range(_workers())])
    light = np.sum(list(parts), axis=0)
    height, width = (side // visible.fineness for side in visible.owner.shape)
    starts = np.searchsorted(samples.places[:, 0] * width + samples.places[:, 1], np.arange(width * height + 1))
    count = len(samples.points)
    smooth = settled(light[:count], samples.points, samples.normals, samples.places, starts, width, pixel)
    return smooth, light[count:].reshape(*ground.shape[:-1], 4)


def _surface_colours(
    pool: ThreadPoolExecutor, samples: _Samples, light: Array, intensities: Array, camera: Camera
) -> Array:
    """Colours (s, 3) of the samples, linear, of bodies of these intensities (b, 3)."""
    towards = towards_eye(samples.points, camera)

    def part(bounds: tuple[int, int]) -> Array:
        one = slice(*bounds)
        base = intensities[samples.places[one, 2]]
        return toned(metal(samples.normals[one], towards[one], light[one], base, camera.up))

    return np.concatenate(list(pool.map(part, _bands(len(light)))))


def _composed(canvas: Array, surface: Array, samples: _Samples) -> Array:
    """The canvas (h, w, 3) covered by the samples' colours (s, 3), each by its share of the pixel."""
    height, width = canvas.shape[:2]
    pixel = samples.places[:, 0] * width + samples.places[:, 1]
    layers = [np.bincount(pixel, samples.shares * surface[:, channel], width * height) for channel in range(3)]
    covered = np.bincount(pixel, samples.shares, width * height)
    return canvas * (1.0 - covered).reshape(height, width, 1) + np.stack(layers, axis=-1).reshape(canvas.shape)


def _workers() -> int:
    return min(os.cpu_count() or 1, 8)


def _bands(height: int) -> list[tuple[int, int]]:
    """First and stop of so many rows in bands, several for each processor; one empty band of none."""
    edges = np.linspace(0, height, 4 * _workers() + 1).astype(int)
    return [(int(first), int(stop)) for first, stop in pairwise(edges) if first < stop] or [(0, 0)]

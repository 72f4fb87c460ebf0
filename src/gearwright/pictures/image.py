"""Bodies to a shaded image: z-buffer, light, lines and the ground's shadow put together, in bands on all processors."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from ..arrays import Array, Indices
from .camera import Camera
from .facets import Facets, facets
from .lighting import Lamps, illumination, metal, settled, studio
from .renderer import CREASE_LINE, SILHOUETTE, collect, ink, rasterise

T = TypeVar("T")

_LINE_COLOUR = np.array([0.055, 0.065, 0.08])
_CREASE_INK = 0.5
_SILHOUETTE_INK = 0.8
_GROUND_GAP = 0.012
_GROUND_STEP = 6
_SHADOW = 0.62
_FAINTEST = 0.02
_FINE_PIXELS = 2_600_000
"""Pictures of more pixels take 2 × 2 sub-pixels instead of 3 × 3, to stay within some hundred megabytes."""


@dataclass(frozen=True, kw_only=True)
class Image:
    """colours (h, w, 3) sRGB 0…1;  owners (h, w) the body seen in most of each pixel, −1 the background."""

    colours: Array
    owners: NDArray[np.int16]


def image(
    bodies: Sequence[tuple[Array, Indices]], colours: Array, camera: Camera, size: tuple[int, int], background: Array
) -> Image:
    """The bodies, (vertices, triangles) each, as the camera sees them.

    colours (b, 3) of the bodies and background (3,) are sRGB; size is (width, height) in pixels. The ground under the
    bodies is drawn only where their shadow falls.
    """
    width, height = size
    fineness = 3 if width * height <= _FINE_PIXELS else 2
    model = facets(bodies)
    seen = camera.seen(model.vertices)
    fine = replace(camera, pixels=camera.pixels * fineness, origin=camera.origin * fineness)
    model = replace(model, vertices=fine.screen(seen), normals=model.normals @ camera.rotation.T)
    depth = np.full((height * fineness, width * fineness), -np.inf, np.float32)
    owner = np.full(depth.shape, -1, np.int32)
    bands = _bands(height)
    with ThreadPoolExecutor(_workers()) as pool:
        _in_bands(pool, bands, lambda first, stop: rasterise(
            model.vertices, model.triangles, depth, owner, first * fineness, stop * fineness))  # fmt: skip
        lamps = studio(camera.up)
        values, places = _samples(pool, bands, model, depth, owner, fineness)
        points, normals = fine.unscreen(values[:, :3]), np.ascontiguousarray(values[:, 3:6])
        ground = _ground_points(camera, seen, size)
        lit = _lit(
            pool, np.concatenate([points, ground.reshape(-1, 3)]),
            np.concatenate([normals, np.broadcast_to(camera.up, (ground.size // 3, 3))]),
            np.concatenate([places[:, :2], np.indices(ground.shape[:2]).reshape(2, -1).T]),
            seen, model.triangles, lamps,
        )  # fmt: skip
        pixel = places[:, 0] * width + places[:, 1]
        starts = np.searchsorted(pixel, np.arange(width * height + 1))
        light = settled(lit[: len(points)], points, normals, places, starts, width, 1.0 / camera.pixels)
        ground_light = lit[len(points) :].reshape(*ground.shape[:-1], 4)
        base, towards = linear(colours)[places[:, 2]], _towards_eye(points, camera)
        shares = [slice(first, stop) for first, stop in _bands(len(points))]
        shaded = pool.map(lambda one: metal(normals[one], towards[one], light[one], base[one], camera.up), shares)
        colour = np.concatenate(list(shaded))
        canvas = linear(background) * _kept(ground_light, size)[..., None]
        lines = _lines(pool, bands, model, depth, owner, fineness)
    canvas = canvas * (1.0 - np.bincount(pixel, values[:, 6], width * height)).reshape(height, width, 1)
    for channel in range(3):
        weights = values[:, 6] * _toned(colour[:, channel])
        canvas[..., channel] += np.bincount(pixel, weights, width * height).reshape(height, width)
    canvas = canvas * (1.0 - lines[..., None]) + linear(_LINE_COLOUR) * lines[..., None]
    middle = owner[fineness // 2 :: fineness, fineness // 2 :: fineness]
    owners = np.where(middle >= 0, model.members[middle] if len(model.members) else -1, -1).astype(np.int16)
    return Image(colours=gamma(canvas), owners=owners)


def linear(colours: Array) -> Array:
    """Light intensities of sRGB values 0…1 (IEC 61966-2-1)."""
    return np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)


def gamma(intensities: Array) -> Array:
    """sRGB values 0…1 of light intensities: the inverse of linear."""
    clipped = np.clip(intensities, 0.0, 1.0)
    return np.where(clipped <= 0.0031308, clipped * 12.92, 1.055 * clipped ** (1 / 2.4) - 0.055)


def _toned(intensities: Array) -> Array:
    """Intensities with highlights above 0.7 rolled off smoothly, so that nothing burns out to flat white."""
    over = np.maximum(intensities - 0.7, 0.0)
    return np.asarray(np.minimum(intensities, 0.7) + 0.3 * (1.0 - np.exp(-over / 0.3)))


def _workers() -> int:
    return min(os.cpu_count() or 1, 8)


def _bands(height: int) -> list[tuple[int, int]]:
    edges = np.linspace(0, height, 4 * _workers() + 1).astype(int)
    return [(int(first), int(stop)) for first, stop in pairwise(edges) if first < stop]


def _in_bands(pool: ThreadPoolExecutor, bands: list[tuple[int, int]], work: Callable[[int, int], T]) -> list[T]:
    return list(pool.map(lambda band: work(*band), bands))


def _samples(
    pool: ThreadPoolExecutor, bands: list[tuple[int, int]], model: Facets,
    depth: NDArray[np.float32], owner: NDArray[np.int32], fineness: int,
) -> tuple[Array, Indices]:  # fmt: skip
    made = _in_bands(pool, bands, lambda first, stop: collect(
        model.vertices, model.triangles, model.normals, model.members, depth, owner, fineness, first, stop
    ))  # fmt: skip
    return np.concatenate([values for values, _ in made]), np.concatenate([places for _, places in made])


def _lines(
    pool: ThreadPoolExecutor, bands: list[tuple[int, int]], model: Facets,
    depth: NDArray[np.float32], owner: NDArray[np.int32], fineness: int,
) -> Array:  # fmt: skip
    """How much of each pixel lines cover, (h, w), 0…1."""
    strength = np.zeros(256)
    strength[CREASE_LINE], strength[SILHOUETTE] = _CREASE_INK, _SILHOUETTE_INK
    width = owner.shape[1] // fineness

    def band(first: int, stop: int) -> Array:
        rows = first * fineness, stop * fineness
        marks = ink(model.vertices, model.triangles, model.normals, model.members, depth, owner, *rows)
        return strength[marks].reshape(stop - first, fineness, width, fineness).mean(axis=(1, 3))

    return np.concatenate(_in_bands(pool, bands, band))


def _lit(
    pool: ThreadPoolExecutor, points: Array, normals: Array, places: Indices,
    seen: Array, triangles: Indices, lamps: Lamps,
) -> Array:  # fmt: skip
    """Illumination (s, 4), the lamps shared among the processors."""
    parts = [
        Lamps(directions=lamps.directions[k::n], strengths=lamps.strengths[k::n], kinds=lamps.kinds[k::n])
        for n in [_workers()]
        for k in range(n)
    ]
    return np.asarray(sum(pool.map(lambda part: illumination(points, normals, places, seen, triangles, part), parts)))


def _towards_eye(points: Array, camera: Camera) -> Array:
    """Unit vectors (s, 3) from seen points to the eye."""
    towards = np.array([0.0, 0.0, 1.0]) - camera.perspective * points
    return np.asarray(towards / np.linalg.norm(towards, axis=-1, keepdims=True))


def _ground_points(camera: Camera, seen: Array, size: tuple[int, int]) -> Array:
    """Points of the ground just under the bodies, seen coordinates, every few pixels, (h', w', 3).

    None, (0, 0, 3), where the eye is not clearly above the ground.
    """
    width, height = size
    level = float((seen @ camera.up).min()) - _GROUND_GAP
    columns, rows = (np.arange(0, n + 2 * _GROUND_STEP, _GROUND_STEP) for n in (width, height))
    screen = np.zeros((len(rows), len(columns), 3))
    screen[..., 0], screen[..., 1] = columns + 0.5, rows[:, None] + 0.5
    start = camera.unscreen(screen)
    towards = _towards_eye(start, camera)
    rise = towards @ camera.up
    if rise.min() < 0.02:
        return np.empty((0, 0, 3))
    return np.asarray(start + towards * ((level - start @ camera.up) / rise)[..., None])


def _kept(light: Array, size: tuple[int, int]) -> Array:
    """Share of its light that the ground keeps, (h, w), from illumination every few pixels (h', w', 4), smoothed."""
    if not light.size:
        return np.ones(size[::-1])
    kept = 1.0 - _SHADOW * (1.0 - (light[..., 0] + light[..., 1]) / (light[..., 2] + light[..., 3]))
    sharp, soft = (gaussian_filter(kept, blur, mode="nearest") for blur in (1.5, 6.0))
    # faint shadows are thrown from far off: there the single lamps would show as clouds
    near = np.clip((1.0 - soft) / 0.3, 0.0, 1.0)
    dark = 1.0 - sharp * near - soft * (1.0 - near)
    return 1.0 - _enlarged(np.maximum(dark - _FAINTEST, 0.0), size)


def _enlarged(coarse: Array, size: tuple[int, int]) -> Array:
    """Values between samples every few pixels, bilinear, (h, w)."""
    width, height = size
    row, down = np.divmod(np.arange(height), _GROUND_STEP)
    column, right = np.divmod(np.arange(width), _GROUND_STEP)
    down, right = (down / _GROUND_STEP)[:, None], right / _GROUND_STEP
    tall = coarse[row] * (1.0 - down) + coarse[row + 1] * down
    return np.asarray(tall[:, column] * (1.0 - right) + tall[:, column + 1] * right)

"""Studio light: a bright dome with one large softbox, each direction with its own shadow map, and what metal mirrors.

Everything here is in seen coordinates (x right, y up, z towards the eye, in bounding radii).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Indices
from ..compiled import compiled
from .renderer import rasterise

_MAP = 512
_REACH = 1.04
_BLUR = 1.2
"""Texels of a shadow map across; bounding radii from its middle to its border; texels from one look to the next."""

_DOME = 44
_SOFTBOX = 28
_SOFTBOX_ANGLE = np.radians(17.0)
_KEY = np.array([-0.55, 0.62, 0.56])

KEY_TINT = np.array([1.0, 0.975, 0.94])
DOME_TINT = np.array([0.93, 0.965, 1.0])
"""Warm softbox, cool dome: faces of different direction differ in hue, not only in brightness."""


@dataclass(frozen=True, kw_only=True)
class Lamps:
    """Light from far away: directions (d, 3) towards it, strengths (d,), kinds (d,) 0 softbox, 1 dome."""

    directions: Array
    strengths: Array
    kinds: Indices


def studio(up: Array) -> Lamps:
    """The lamps of the studio whose ground has the unit normal up; the softbox is always over the left shoulder."""
    index = np.arange(_DOME) + 0.5
    height = 1.0 - 2.0 * index / _DOME
    turn = np.pi * (1.0 + np.sqrt(5.0)) * index
    ring = np.sqrt(1.0 - height**2)
    around = _frame(up)
    dome = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=-1) @ around
    # above, a bright ceiling; below, what a white table throws back
    dome_strengths = np.where(height > 0.0, 0.55 + 0.45 * height, 0.34) * (4.0 / _DOME)
    index = np.arange(_SOFTBOX) + 0.5
    spread = _SOFTBOX_ANGLE * np.sqrt(index / _SOFTBOX)
    turn = np.pi * (1.0 + np.sqrt(5.0)) * index
    key = np.stack([np.sin(spread) * np.cos(turn), np.sin(spread) * np.sin(turn), np.cos(spread)], axis=-1)
    key = key @ _frame(_KEY / np.linalg.norm(_KEY))
    return Lamps(
        directions=np.concatenate([key, dome]),
        strengths=np.concatenate([np.full(_SOFTBOX, 1.0 / _SOFTBOX), dome_strengths]),
        kinds=np.repeat([0, 1], [_SOFTBOX, _DOME]),
    )


def illumination(
    points: Array, normals: Array, places: Indices, vertices: Array, triangles: Indices, lamps: Lamps
) -> Array:
    """Light that falls on points with these normals, (s, 4): softbox and dome as shadowed, then as unshadowed.

    points (s, 3), normals (s, 3) unit, places (s, 2…) row and column in the picture; vertices (n, 3) and triangles
    (t, 3) throw the shadows. Each of 5 × 5 neighbouring places looks a few texels aside in its own direction, so that
    their mean, see settled, has soft shadows.
    """
    light = np.zeros((len(points), 4))
    corners = vertices[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    depth = np.empty((_MAP, _MAP), np.float32)
    owner = np.empty((_MAP, _MAP), np.int32)
    scale = _MAP / (2.0 * _REACH)
    for direction, strength, kind in zip(lamps.directions, lamps.strengths, lamps.kinds, strict=True):
        projection = _frame(direction).T * scale
        depth.fill(-np.inf)
        # the far side of a closed body throws the same shadow as its lit side, which then cannot shade itself
        away = triangles[faces @ direction < 0.0]
        rasterise(vertices @ projection + _MIDDLE, away, depth, owner, 0, _MAP)
        _illuminate(points, normals, places, projection, direction, strength, kind, depth, light)
    return light


_MIDDLE = np.array([_MAP / 2.0, _MAP / 2.0, 0.0])


def _frame(direction: Array) -> Array:
    """Rows: two unit vectors across a unit direction, then the direction."""
    across = np.cross(np.eye(3)[int(np.argmin(np.abs(direction)))], direction)
    across = across / np.linalg.norm(across)
    return np.stack([across, np.cross(direction, across), direction])


@compiled
def _illuminate(
    points: Array, normals: Array, places: Indices, projection: Array, direction: Array, strength: float, kind: int,
    depth: NDArray[np.float32], light: Array,
) -> None:  # fmt: skip
    """Add one lamp's light to light (s, 4), compared with its shadow map at four texels and blended between them."""
    size = depth.shape[0]
    # off the surface by a texel, so that a flat face does not shade itself
    lift = 1.0 / np.sqrt(projection[0, 2] ** 2 + projection[1, 2] ** 2 + projection[2, 2] ** 2)
    for s in range(len(points)):
        cosine = normals[s, 0] * direction[0] + normals[s, 1] * direction[1] + normals[s, 2] * direction[2]
        if cosine <= 0.0:
            continue
        light[s, kind + 2] += strength * cosine
        px = points[s, 0] + lift * normals[s, 0]
        py = points[s, 1] + lift * normals[s, 1]
        pz = points[s, 2] + lift * normals[s, 2]
        # all 25 looks in any 5 × 5 places, and varied ones along any row, column or diagonal
        aside = 0.5 * size - 0.5 + _BLUR * ((places[s, 0] + 2 * places[s, 1]) % 5 - 2)
        below = 0.5 * size - 0.5 + _BLUR * ((places[s, 0] + 3 * places[s, 1]) % 5 - 2)
        x = px * projection[0, 0] + py * projection[1, 0] + pz * projection[2, 0] + aside
        y = px * projection[0, 1] + py * projection[1, 1] + pz * projection[2, 1] + below
        z = px * projection[0, 2] + py * projection[1, 2] + pz * projection[2, 2] + 0.5
        column, row = int(np.floor(x)), int(np.floor(y))
        if column < 0 or row < 0 or column + 1 >= size or row + 1 >= size:
            light[s, kind] += strength * cosine
            continue
        right, down = x - column, y - row
        open_share = 0.0
        if depth[row, column] <= z:
            open_share += (1.0 - right) * (1.0 - down)
        if depth[row, column + 1] <= z:
            open_share += right * (1.0 - down)
        if depth[row + 1, column] <= z:
            open_share += (1.0 - right) * down
        if depth[row + 1, column + 1] <= z:
            open_share += right * down
        light[s, kind] += strength * cosine * open_share


@compiled
def settled(
    light: Array, points: Array, normals: Array, places: Indices, starts: Indices, width: int, pixel: float
) -> Array:
    """Light (s, 4) averaged over the samples of the same surface in the 5 × 5 pixels around each.

    places (s, 2…) rows and columns, in reading order; starts (h w + 1,) the first sample of each pixel.
    The same surface: within a tenth of the window's width of the sample's tangent plane, and turned less than 20°.
    """
    height = (len(starts) - 1) // width
    mean = np.empty_like(light)
    for s in range(len(light)):
        row, column = places[s, 0], places[s, 1]
        nx, ny, nz = normals[s, 0], normals[s, 1], normals[s, 2]
        sums = (0.0, 0.0, 0.0, 0.0)
        count = 0
        for row2 in range(max(row - 2, 0), min(row + 3, height)):
            first = starts[row2 * width + max(column - 2, 0)]
            stop = starts[row2 * width + min(column + 3, width)]
            for i in range(first, stop):
                if nx * normals[i, 0] + ny * normals[i, 1] + nz * normals[i, 2] < 0.94:
                    continue
                x, y, z = points[i, 0] - points[s, 0], points[i, 1] - points[s, 1], points[i, 2] - points[s, 2]
                if abs(nx * x + ny * y + nz * z) < 0.75 * pixel:
                    sums = (sums[0] + light[i, 0], sums[1] + light[i, 1], sums[2] + light[i, 2], sums[3] + light[i, 3])
                    count += 1
        for k in range(4):
            mean[s, k] = sums[k] / count
    return mean


def metal(normals: Array, towards_eye: Array, light: Array, base: Array, up: Array) -> Array:
    """Colour (s, 3), linear, of satin metal of base colours (s, 3) under illumination (s, 4).

    Half the light is scattered; the rest mirrors the studio, blurred as ground steel does, and dimmed in recesses
    by the share of light that reaches them.
    """
    facing = np.sum(normals * towards_eye, axis=-1)
    mirrored = 2.0 * np.abs(facing)[:, None] * normals - towards_eye
    received = np.maximum(light[:, 2] + light[:, 3], 1e-9)
    openness = ((light[:, 0] + light[:, 1]) / received)[:, None]
    scattered = light[:, :1] * (1.05 * KEY_TINT) + light[:, 1:2] * (0.62 * DOME_TINT)
    edge = (1.0 - np.clip(np.abs(facing), 0.0, 1.0))[:, None] ** 5
    reflectance = base + (1.0 - base) * 0.6 * edge
    return np.asarray(base * scattered * 0.72 + reflectance * _mirror(mirrored, up) * 0.5 * openness**1.5)


def _mirror(directions: Array, up: Array) -> Array:
    """Brightness (s, 3) of the studio in directions (s, 3): a ceiling, a table, the softbox, two strips of light."""
    height = (directions @ up)[:, None]
    sky = (0.28 + 0.34 * (0.5 + 0.5 * height) ** 2) * DOME_TINT
    for place, sharpness, strength, tint in _STRIPS:
        along = directions @ (np.array(place) / np.linalg.norm(place))
        sky = sky + strength * np.exp(sharpness * (along - 1.0))[:, None] * tint
    return np.asarray(sky)


_STRIPS = (
    ((-0.55, 0.62, 0.56), 14.0, 1.5, KEY_TINT),
    ((0.90, 0.25, 0.35), 14.0, 0.45, DOME_TINT),
    ((-0.25, -0.35, 0.90), 7.0, 0.18, KEY_TINT),
)

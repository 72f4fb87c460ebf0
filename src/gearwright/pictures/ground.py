"""The ground under the bodies: white, seen only where their shadow falls on it."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from ..arrays import Array
from .camera import Camera, towards_eye

_GAP = 0.012
_STEP = 6
_SHADOW = 0.62
_FAINTEST = 0.02
"""Gap under the bodies, in their radii; pixels from sample to sample; darkness without light; darkness not drawn."""


def ground_points(camera: Camera, seen: Array, size: tuple[int, int]) -> Array:
    """Points of the ground just under the bodies, seen coordinates, every few pixels, (h', w', 3).

    None, (0, 0, 3), where the eye is not clearly above the ground.
    """
    width, height = size
    level = float((seen @ camera.up).min()) - _GAP
    columns, rows = (np.arange(0, n + 2 * _STEP, _STEP) for n in (width, height))
    screen = np.zeros((len(rows), len(columns), 3))
    screen[..., 0], screen[..., 1] = columns + 0.5, rows[:, None] + 0.5
    start = camera.unscreen(screen)
    towards = towards_eye(start, camera)
    rise = towards @ camera.up
    if rise.min() < 0.02:
        return np.empty((0, 0, 3))
    return np.asarray(start + towards * ((level - start @ camera.up) / rise)[..., None])


def kept_light(light: Array, size: tuple[int, int]) -> Array:
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
    row, down = np.divmod(np.arange(height), _STEP)
    column, right = np.divmod(np.arange(width), _STEP)
    down, right = (down / _STEP)[:, None], right / _STEP
    tall = coarse[row] * (1.0 - down) + coarse[row + 1] * down
    return np.asarray(tall[:, column] * (1.0 - right) + tall[:, column + 1] * right)

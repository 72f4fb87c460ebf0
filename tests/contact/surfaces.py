"""Touching found by brute force: dense grids of points on the solids' own surfaces, moved by 4×4 matrices."""

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from ..laws.contact import involute_patches

_TABLE = 4001


class Surface:
    """One flank of the first tooth of a gear's solid: its points, and its azimuth by cone distance and polar angle."""

    def __init__(self, gear, side):
        one, other = involute_patches(gear)
        middle = [np.arctan2(*patch.point(np.array(0.5), np.array(0.5))[[1, 0]]) for patch in (one, other)]
        self.patch = (one, other)[int(np.argmax(middle) if side == "drive" else np.argmin(middle))]
        along = np.linspace(0.0, 1.0, _TABLE)
        _, self.polar, profile = spherical(self.patch.point(along, np.full(_TABLE, 0.5)))
        self.distance, _, trace = spherical(self.patch.point(np.full(_TABLE, 0.5), along))
        rising = np.argsort(self.polar)
        self._profile = CubicSpline(self.polar[rising], profile[rising])
        self._trace = CubicSpline(self.distance, trace - trace[_TABLE // 2])

    def azimuth(self, distance, polar):
        return self._profile(polar) + self._trace(distance)

    def holds(self, distance, polar):
        inside = (polar >= self.polar.min()) & (polar <= self.polar.max())
        return inside & (distance >= self.distance.min()) & (distance <= self.distance.max())


def spherical(points):
    """Distance from the origin, polar angle and azimuth."""
    x, y, z = np.moveaxis(points, -1, 0)
    distance = np.sqrt(x * x + y * y + z * z)
    return distance, np.arccos(z / distance), np.arctan2(y, x)


def greatest_lead(pair, turn, side, shaft_angle_error, mounting_errors, offset_error, grid=(161, 601)):
    """Of the gear, in the sense in which it is driven: what the tightest of all grid points allows, radians."""
    pinion, gear = Surface(pair.pinion, side), Surface(pair.gear, side)
    v, u = np.meshgrid(np.linspace(0.0, 1.0, grid[0]), np.linspace(0.0, 1.0, grid[1]), indexing="ij")
    own = pinion.patch.point(u.ravel(), v.ravel())
    placed_pinion, placed_gear = pair.placements(np.degrees(turn))
    tilt = Rotation.from_euler("y", shaft_angle_error, degrees=True).as_matrix()
    gear_axes = tilt @ placed_gear[:3, :3]
    apex = gear_axes[:, 2] * mounting_errors[1] + [0.0, offset_error, 0.0]
    pitch = 2.0 * np.pi / pair.gear.teeth
    sense = 1.0 if side == "drive" else -1.0
    best = -np.inf
    for k in range(pair.pinion.teeth):
        about = Rotation.from_euler("z", 2.0 * np.pi * k / pair.pinion.teeth).as_matrix()
        points = own @ (placed_pinion[:3, :3] @ about).T + [0.0, 0.0, mounting_errors[0]]
        distance, polar, azimuth = spherical((points - apex) @ gear_axes)
        on = gear.holds(distance, polar)
        if on.any():
            gap = azimuth[on] - gear.azimuth(distance[on], polar[on])
            best = max(best, float(np.max(-sense * ((gap + pitch / 2.0) % pitch - pitch / 2.0))))
    return best

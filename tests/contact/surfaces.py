"""Touching found by brute force: dense grids of points on the solids' own surfaces, moved by 4×4 matrices."""

import numpy as np
from scipy.interpolate import RectBivariateSpline
from scipy.spatial.transform import Rotation

_GRID = (801, 61)
_NEAR = 1e-9


class Surface:
    """One flank of the first tooth of a gear's solid: its points, and its azimuth by cone distance and polar angle."""

    def __init__(self, gear, side):
        flanks = flank_patches(gear)
        middle = [float(np.arctan2(*patch.point(np.array(0.5), np.array(0.5))[[1, 0]])) for patch in flanks]
        self.patch = flanks[int(np.argmax(middle) if side == "drive" else np.argmin(middle))]
        self.gamma, self.ends = gear.pitch_cone_angle, (gear.inner_distance, gear.cone_distance)
        u, v = (np.linspace(0.0, 1.0, n) for n in _GRID)
        points = self.patch.point(*(a.ravel() for a in np.meshgrid(u, v, indexing="ij")))
        _, polar, azimuth = (values.reshape(_GRID) for values in spherical(points))
        self._heights = polar.min(), polar.max()
        self._polar, self._azimuth = (RectBivariateSpline(u, v, values) for values in (polar, azimuth))

    def _share(self, distance, polar):
        """Of the face that is inside, on conical ends."""
        inner, outer = self.ends
        return (distance * np.cos(polar - self.gamma) - inner) / (outer - inner)

    def azimuth(self, distance, polar):
        v = self._share(distance, polar)
        foot, tip = (self._polar.ev(np.full_like(v, u), v) for u in (0.0, 1.0))
        u = np.clip((polar - foot) / (tip - foot), 0.0, 1.0)
        for _ in range(6):
            u = np.clip(u - (self._polar.ev(u, v) - polar) / self._polar.ev(u, v, dx=1), 0.0, 1.0)
        return self._azimuth.ev(u, v)

    def holds(self, distance, polar):
        v = self._share(distance, polar)
        if not np.any((polar >= self._heights[0]) & (polar <= self._heights[1])):
            return np.zeros(v.shape, bool)
        foot, tip = np.sort([self._polar.ev(np.full_like(v, u), v) for u in (0.0, 1.0)], axis=0)
        return (polar >= foot) & (polar <= tip) & (v >= 0.0) & (v <= 1.0)


def flank_patches(gear):
    """The two flanks of the first tooth, from form circle to tip, without relief."""
    tooth = gear.bevel_teeth.mean
    ends = np.array([tooth.form_angle, tooth.face_angle])
    middle = gear.bevel_teeth.level("mean")
    share = (middle - gear.inner_distance) / gear.face_width
    found = []
    for patch in gear.boundary.patches:
        _, polar, _ = spherical(patch.point(np.array([0.0, 1.0]), np.array([share, share])))
        if np.abs(np.sort(polar) - ends).max() < _NEAR:
            found.append(patch)
    return found


def spherical(points):
    """Distance from the origin, polar angle and azimuth."""
    x, y, z = np.moveaxis(points, -1, 0)
    distance = np.sqrt(x * x + y * y + z * z)
    return distance, np.arccos(z / distance), np.arctan2(y, x)


def greatest_lead(pair, turn, side, shaft_angle_error, mounting_errors, offset_error, grid=(81, 601)):
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

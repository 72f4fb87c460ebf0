"""The tool: a crown gear's tooth with rounded corners, rolled past a gear; of the package it has only the involute."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from gearwright.curves.spherical_involute import azimuth, roll_at_polar_angle


@dataclass(frozen=True)
class GeneratingCrown:
    """The crown gear's tooth that fills a space of a gear, in its own frame: axis +z, tip towards +z, middle on +x.

    Latitudes count from its pitch plane. Its flank is half_width away from the middle there. A corner is a small circle
    about a point ρ below the tip's parallel, moved along it until its least distance from the flank is ρ.
    """

    form: str
    pressure_angle: float
    half_width: float
    depth: float
    radius: float

    def flank_longitude(self, latitude):
        """How far from the middle the flank is at latitudes (...)."""
        a = self.pressure_angle
        if self.form == "octoid":  # a great circle: its plane leans by a
            return self.half_width - np.arcsin(np.clip(np.tan(latitude) * np.tan(a), -1.0, 1.0))
        base = np.pi / 2.0 - a
        polar = np.clip(np.pi / 2.0 - np.asarray(latitude, float), base, np.pi - base)
        on_pitch = azimuth(roll_at_polar_angle(np.pi / 2.0, base), base)
        return self.half_width + azimuth(roll_at_polar_angle(polar, base), base) - on_pitch

    def flank_point(self, latitude):
        return on_sphere(latitude, self.flank_longitude(latitude))

    @property
    def lowest(self) -> float:
        return self.depth - self.radius

    def _nearest(self, longitude: float):
        centre = on_sphere(self.lowest, longitude)
        most = self.pressure_angle if self.form == "involute" else np.pi / 2.0 - self.pressure_angle
        return minimize_scalar(
            lambda latitude: float(np.linalg.norm(self.flank_point(latitude) - centre)),
            bounds=(-0.5 * most, most),
            method="bounded",
            options={"xatol": 1e-13},
        )

    @cached_property
    def corner(self) -> np.ndarray:
        """Middle of the corner's circle."""

        def excess(longitude):
            return 2.0 * np.arcsin(self._nearest(longitude).fun / 2.0) - self.radius

        edge = float(self.flank_longitude(self.lowest))
        return on_sphere(self.lowest, brentq(excess, edge - 4.0 * self.radius, edge, xtol=1e-15))

    @cached_property
    def foot(self) -> float:
        """Latitude at which flank and corner touch."""
        return float(self._nearest(float(np.arctan2(self.corner[1], self.corner[0]))).x)

    def clearance(self, points):
        """How far points (..., 3) of the sphere are outside the tooth; negative inside."""
        latitude, longitude = np.arcsin(points[..., 2]), np.abs(np.arctan2(points[..., 1], points[..., 0]))
        points = on_sphere(latitude, longitude)
        centre = np.arctan2(self.corner[1], self.corner[0])
        to_flank = (longitude - self.flank_longitude(latitude)) * np.cos(latitude)
        north = on_sphere(self.lowest + np.pi / 2.0, centre)
        east = np.cross(north, self.corner)
        bearing = np.arctan2(points @ north, points @ east)
        foot = self.flank_point(self.foot)
        first = np.arctan2(foot @ north, foot @ east)
        beside = (bearing > first) & (bearing < np.pi / 2.0)
        away = 2.0 * np.arcsin(np.clip(np.linalg.norm(points - self.corner, axis=-1) / 2.0, 0.0, 1.0)) - self.radius
        return np.where(beside, away, np.maximum(to_flank, latitude - self.depth))

    def least_clearance(self, point, pitch_angle: float) -> float:
        """The least clearance of a point (3,) of a gear, its space centred on azimuth 0, as it rolls past."""

        def seen(turns):
            return self.clearance(in_crown(point, turns, pitch_angle))

        most = min(1.5, 3.0 * np.sqrt(2.0 * np.sin(pitch_angle) * self.depth + self.depth**2))
        turns = np.linspace(-most, most, 3001)
        rough = seen(turns)
        inner = rough[1:-1]
        near = 1 + np.flatnonzero((inner <= rough[:-2]) & (inner <= rough[2:]))
        best = near[np.argsort(rough[near])][:3]
        found = []
        for k in best:
            middle, width = turns[k], turns[1] - turns[0]
            for _ in range(7):
                closer = middle + width * np.linspace(-1.0, 1.0, 41)
                values = seen(closer)
                middle, width = closer[np.argmin(values)], width / 12.0
            found.append(values.min())
        return float(min(found))


def on_sphere(latitude, longitude):
    latitude, longitude = np.broadcast_arrays(latitude, longitude)
    c = np.cos(latitude)
    return np.stack([c * np.cos(longitude), c * np.sin(longitude), np.sin(latitude)], axis=-1)


def in_crown(point, turns, pitch_angle: float):
    """A gear's point (3,) in the crown gear's frame (n, 3), that having turned by angles (n,).

    In space the crown gear's axis is +z, the pitch line +x; both pitch surfaces move alike there.
    """
    axis = np.array([np.cos(pitch_angle), 0.0, np.sin(pitch_angle)])
    outward = np.array([np.sin(pitch_angle), 0.0, -np.cos(pitch_angle)])
    frame = np.stack([outward, np.cross(axis, outward), axis], axis=-1)
    pitch_point = np.array([1.0, 0.0, 0.0])
    rate = np.linalg.norm(np.cross([0.0, 0.0, 1.0], pitch_point)) / np.linalg.norm(np.cross(axis, pitch_point))
    angle = rate * turns
    across, along, up = point
    c, s = np.cos(angle), np.sin(angle)
    turned = np.stack([c * across - s * along, s * across + c * along, np.full_like(c, up)], axis=-1)
    x, y, z = (turned @ frame.T).T
    c, s = np.cos(turns), np.sin(turns)
    return np.stack([c * x + s * y, c * y - s * x, z], axis=-1)

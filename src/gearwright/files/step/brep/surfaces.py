"""The surfaces of faces as Open CASCADE and STEP name them, and their parameters at points.

Conventions of ISO 10303-42: every elementary surface has a right-handed frame of axes x, y, z at an origin.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from ....arrays import Array
from ....curves.curve import turn
from ..kernel import kernel
from .bases import Basis
from .splines import counts, numbers, point, spline_curve


class Geometry(Protocol):
    """A surface r(U, V)."""

    def made(self) -> Any:
        """It in Open CASCADE."""

    def point(self, uv: Array) -> Array:
        """r (..., 3) at parameters (..., 2)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Frame:
    """Axes (3, 3), x y z as columns, right-handed, and an origin (3,)."""

    axes: Array
    origin: Array

    def local(self, points: Array) -> Array:
        return np.asarray((points - self.origin) @ self.axes)

    def world(self, points: Array) -> Array:
        return np.asarray(points @ self.axes.T + self.origin)

    def turned_over(self) -> Frame:
        """With x and z reversed."""
        return Frame(axes=self.axes * [-1.0, 1.0, -1.0], origin=self.origin)

    def shifted(self, along: float) -> Frame:
        """With the origin moved along z."""
        return Frame(axes=self.axes, origin=self.origin + along * self.axes[:, 2])

    def turned(self, angle: float) -> Frame:
        """With x turned towards y, about z."""
        return Frame(axes=self.axes @ turn(angle, 3), origin=self.origin)

    def made(self) -> Any:
        from OCP.gp import gp_Ax3, gp_Dir, gp_Pnt

        return gp_Ax3(gp_Pnt(*self.origin.tolist()), *(gp_Dir(*self.axes[:, i].tolist()) for i in (2, 0)))


@dataclass(frozen=True, kw_only=True, eq=False)
class Flat:
    """The plane origin + U x + V y."""

    frame: Frame

    def made(self) -> Any:
        from OCP.Geom import Geom_Plane

        return Geom_Plane(self.frame.made())

    def point(self, uv: Array) -> Array:
        return self.frame.world(np.concatenate([uv, np.zeros_like(uv[..., :1])], axis=-1))


@dataclass(frozen=True, kw_only=True, eq=False)
class Round(ABC):
    """A surface of revolution that has a height V at every point of a meridian plane; U is the azimuth about z.

    pole   V where it comes to the axis; infinite where it never does
    """

    frame: Frame

    @abstractmethod
    def made(self) -> Any:
        """It in Open CASCADE."""

    @abstractmethod
    def meridian(self, v: Array) -> tuple[Array, Array]:
        """ρ and z (...) at heights (...)."""

    @abstractmethod
    def height(self, rho: Array, z: Array) -> Array:
        """V (...) at ρ and z (...)."""

    @property
    @abstractmethod
    def pole(self) -> float: ...

    def point(self, uv: Array) -> Array:
        """r (..., 3) at parameters (..., 2)."""
        rho, z = self.meridian(uv[..., 1])
        return _about_axis(self.frame, rho, z, uv[..., 0])

    def chart(self, points: Array) -> Array:
        """(U, V) (..., 2) of points (..., 3), with U in (−π, π]."""
        local = self.frame.local(points)
        rho = np.hypot(local[..., 0], local[..., 1])
        return np.stack([np.arctan2(local[..., 1], local[..., 0]), self.height(rho, local[..., 2])], axis=-1)


@dataclass(frozen=True, kw_only=True, eq=False)
class Cylinder(Round):
    """ρ = radius, z = V."""

    radius: float

    def made(self) -> Any:
        from OCP.Geom import Geom_CylindricalSurface

        return Geom_CylindricalSurface(self.frame.made(), self.radius)

    def meridian(self, v: Array) -> tuple[Array, Array]:
        return np.full_like(v, self.radius), v

    def height(self, rho: Array, z: Array) -> Array:
        del rho
        return z

    @property
    def pole(self) -> float:
        """It never comes to the axis."""
        return np.inf


@dataclass(frozen=True, kw_only=True, eq=False)
class Cone(Round):
    """ρ = radius + V sin a, z = V cos a with the half-angle a, 0 < a < π/2."""

    radius: float
    half_angle: float

    def made(self) -> Any:
        from OCP.Geom import Geom_ConicalSurface

        return Geom_ConicalSurface(self.frame.made(), self.half_angle, self.radius)

    def meridian(self, v: Array) -> tuple[Array, Array]:
        return self.radius + v * np.sin(self.half_angle), v * np.cos(self.half_angle)

    def height(self, rho: Array, z: Array) -> Array:
        return (rho - self.radius) * np.sin(self.half_angle) + z * np.cos(self.half_angle)

    @property
    def pole(self) -> float:
        """V of the apex."""
        return -self.radius / float(np.sin(self.half_angle))


@dataclass(frozen=True, kw_only=True, eq=False)
class Sphere(Round):
    """ρ = radius cos V, z = radius sin V."""

    radius: float

    def made(self) -> Any:
        from OCP.Geom import Geom_SphericalSurface

        return Geom_SphericalSurface(self.frame.made(), self.radius)

    def meridian(self, v: Array) -> tuple[Array, Array]:
        return self.radius * np.cos(v), self.radius * np.sin(v)

    def height(self, rho: Array, z: Array) -> Array:
        return np.arctan2(z, rho)

    @property
    def pole(self) -> float:
        """V of the pole +z."""
        return float(np.pi / 2.0)


@dataclass(frozen=True, kw_only=True, eq=False)
class Torus:
    """ρ = major + minor cos V, z = minor sin V; U is the azimuth about z."""

    frame: Frame
    major: float
    minor: float

    def made(self) -> Any:
        from OCP.Geom import Geom_ToroidalSurface

        return Geom_ToroidalSurface(self.frame.made(), self.major, self.minor)

    def point(self, uv: Array) -> Array:
        v = uv[..., 1]
        return _about_axis(self.frame, self.major + self.minor * np.cos(v), self.minor * np.sin(v), uv[..., 0])


def _about_axis(frame: Frame, rho: Array, z: Array, azimuth: Array) -> Array:
    return frame.world(np.stack([rho * np.cos(azimuth), rho * np.sin(azimuth), z], axis=-1))


@dataclass(frozen=True, kw_only=True, eq=False)
class Extruded:
    """A spline curve of poles (n, 3), parameter U, moved along a unit vector by the length V."""

    basis: Basis
    poles: Array
    direction: Array

    def made(self) -> Any:
        from OCP.Geom import Geom_SurfaceOfLinearExtrusion
        from OCP.gp import gp_Dir

        return Geom_SurfaceOfLinearExtrusion(spline_curve(self.basis, self.poles), gp_Dir(*self.direction.tolist()))

    def point(self, uv: Array) -> Array:
        return self.basis.values(self.poles, uv[..., 0]) + uv[..., 1:] * self.direction


@dataclass(frozen=True, kw_only=True, eq=False)
class Turned:
    """A spline curve of poles (n, 3) in the half-plane of +x, parameter V, turned about the frame's z by U."""

    basis: Basis
    poles: Array
    frame: Frame

    def made(self) -> Any:
        from OCP.Geom import Geom_SurfaceOfRevolution

        return Geom_SurfaceOfRevolution(spline_curve(self.basis, self.poles), self.frame.made().Axis())

    def point(self, uv: Array) -> Array:
        local = self.frame.local(self.basis.values(self.poles, uv[..., 1]))
        return _about_axis(self.frame, local[..., 0], local[..., 2], uv[..., 0])


@dataclass(frozen=True, kw_only=True, eq=False)
class Spline:
    """A tensor-product spline of poles (n, m, 3); U and V from 0 to 1."""

    bases: tuple[Basis, Basis]
    poles: Array

    def made(self) -> Any:
        from OCP.Geom import Geom_BSplineSurface

        (u, v), (n, m) = self.bases, self.poles.shape[:2]
        grid = kernel().point_grid(1, n, 1, m)
        for i, row in enumerate(self.poles.tolist()):
            for j, (x, y, z) in enumerate(row):
                grid.SetValue(i + 1, j + 1, point(x, y, z))
        breaks = [numbers(basis.breaks) for basis in (u, v)]
        repeats = [counts(basis.multiplicities) for basis in (u, v)]
        return Geom_BSplineSurface(grid, *breaks, *repeats, u.degree, v.degree)

    def point(self, uv: Array) -> Array:
        u, v = self.bases
        across = u.values(self.poles, uv[..., 0].ravel())
        rows = [v.values(row, np.array([at]))[0] for row, at in zip(across, uv[..., 1].ravel(), strict=True)]
        return np.reshape(rows, (*uv.shape[:-1], 3))

"""The elementary surfaces among patches, by their points: whatever made them, they are written as what they are."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ....arrays import Array
from ....boundary.faces import Patch
from ....motions.placed import Placed
from ....motions.revolution import Revolution
from .elementary import FRACTIONS, SAME, Circular, Straight, circular, straight
from .surfaces import Cone, Cylinder, Flat, Frame, Geometry, Round, Sphere, Torus

_U, _V = (a.ravel() for a in np.meshgrid(FRACTIONS[::2], FRACTIONS[::2], indexing="ij"))
_SIDE = len(FRACTIONS[::2])
_LEAST_SLOPE = 1e-9
"""Least angle of a cone against its axis and against a plane across it, radians."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Natural:
    """A surface whose parameters are U, V = origin + u along_u + v along_v at a patch's fractions u, v."""

    surface: Geometry
    origin: Array
    along_u: Array
    along_v: Array

    @property
    def outward(self) -> bool:
        """Whether ∂U × ∂V goes with ∂u × ∂v, which points out of the body."""
        return bool(self.along_u[0] * self.along_v[1] > self.along_u[1] * self.along_v[0])

    def parameters(self, u: Array, v: Array) -> Array:
        """(U, V) (..., 2) at fractions (...)."""
        return self.origin + u[..., None] * self.along_u + v[..., None] * self.along_v


@dataclass(frozen=True, kw_only=True, eq=False)
class Extrusion:
    """A patch whose curve moves without turning, by a vector (3,)."""

    way: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Turning:
    """A patch whose curve turns about the frame's z backward by an angle, to end in the half-plane of +x."""

    frame: Frame
    angle: float


Surface = Flat | Natural | Round
"""Flat and Round: what a patch lies on, though its fractions are no parameters of it."""

Found = Surface | Extrusion | Turning


def recognised(patch: Patch) -> Found | None:
    """What the patch lies on; None where it is nothing elementary."""
    points = patch.point(_U, _V)
    near = SAME * max(float(np.abs(points).max()), float(np.ptp(points, axis=0).max()))
    flat = _plane(patch, points, near)
    if flat is not None:
        return flat
    motion, frame = patch.motion, Frame(axes=np.eye(3), origin=np.zeros(3))
    if isinstance(motion, Placed):
        frame = Frame(axes=motion.placement.matrix, origin=motion.placement.shift)
        motion = motion.motion
    if isinstance(motion, Revolution):
        return _revolved(patch, frame, near)
    grid = points.reshape(_SIDE, _SIDE, 3)
    way = grid[0, -1] - grid[0, 0]
    if np.max(np.abs(grid - grid[:, :1] - FRACTIONS[::2, None] * way)) <= near:
        return _translated(patch, way, near)
    return _coaxial(frame.local(points), frame, near)


def _plane(patch: Patch, points: Array, near: float) -> Flat | None:
    normals = patch.area_vector(_U, _V)
    normal = normals.sum(axis=0)
    size = float(np.linalg.norm(normal))
    if size == 0.0:
        return None
    normal /= size
    if np.max(np.abs((points - points[0]) @ normal)) > near:
        return None
    return Flat(frame=Frame(axes=axes_about(normal), origin=points[0]))


def axes_about(normal: Array) -> Array:
    """Axes (3, 3) whose z is a unit vector."""
    aside = np.eye(3)[int(np.argmin(np.abs(normal)))]
    x = np.cross(aside, normal)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(normal, x), normal], axis=1)


def _revolved(patch: Patch, frame: Frame, near: float) -> Found:
    """A revolution turns by −v: its azimuth falls from −start on."""
    start, span = patch.ends.start, patch.ends.span
    first = -start
    meridian = patch.curve.point(patch.curve.parameter(FRACTIONS))
    plane = np.stack([meridian[:, 0], np.zeros(len(FRACTIONS)), meridian[:, 1]], axis=-1)
    turning = np.array([-span, 0.0])
    line, arc = straight(plane, near), circular(plane, near)
    if line is not None:
        surface = _lathed(frame, line, near)
        heights = [surface.height(*_meridian(surface, frame, end)) for end in (line.first, line.last)]
        low, high = (float(height) for height in heights)
        return _natural(surface, frame, first, (low, high), turning)
    if arc is not None:
        round_ = _ring(frame, arc, near)
        if round_ is not None:
            sense = -1.0 if arc.axis[1] > 0.0 else 1.0  # about −y the angle from ρ to z grows
            begin = float(np.arctan2(arc.x[2], arc.x[0]))
            return _natural(round_, frame, first, (begin, begin + sense * arc.sweep), turning)
    return Turning(frame=frame.turned(first - span), angle=span)


def _natural(
    surface: Cylinder | Cone | Sphere | Torus, frame: Frame, first: float, heights: tuple[float, float], turning: Array
) -> Natural:
    """With the surface's frame turned so that U begins at 0. Where a cone's is turned over, U is π − azimuth."""
    over = surface.frame.axes[:, 2] @ frame.axes[:, 2] < 0.0
    start, step = (np.pi - first, -turning[0]) if over else (first, turning[0])
    low = min(start, start + step)
    return Natural(
        surface=replace(surface, frame=surface.frame.turned(low)),
        origin=np.array([start - low, heights[0]]),
        along_u=np.array([0.0, heights[1] - heights[0]]),
        along_v=np.array([step, 0.0]),
    )


def _meridian(surface: Cylinder | Cone, frame: Frame, point: Array) -> tuple[Array, Array]:
    """ρ and z in the surface's frame of a point (ρ, 0, z) in the motion's."""
    local = surface.frame.local(frame.world(point))
    return np.hypot(local[0], local[1]), local[2]


def _lathed(frame: Frame, line: Straight, near: float) -> Cylinder | Cone:
    """The cylinder or cone of a line in the half-plane (ρ, z); a plane has been found before."""
    (rho, _, z), (other, _, height) = line.first, line.last
    if abs(other - rho) <= near:
        return Cylinder(frame=frame, radius=float(max(rho, other)))
    return cone_through(frame, (float(rho), float(z)), (float(other), float(height)))


def cone_through(frame: Frame, one: tuple[float, float], other: tuple[float, float]) -> Cone:
    """The cone about z through two points (ρ, z), its frame at the wider one, turned over where it narrows upward."""
    (narrow, low), (wide, high) = sorted([one, other])
    angle = float(np.arctan2(wide - narrow, abs(high - low)))
    placed = frame.shifted(high)
    return Cone(frame=placed if high > low else placed.turned_over(), radius=wide, half_angle=angle)


def _ring(frame: Frame, arc: Circular, near: float) -> Sphere | Torus | None:
    rho, z = float(arc.centre[0]), float(arc.centre[2])
    if abs(rho) <= near:
        return Sphere(frame=frame.shifted(z), radius=arc.radius)
    # beyond that the torus passes through itself
    return Torus(frame=frame.shifted(z), major=rho, minor=arc.radius) if rho > arc.radius + near else None


def _translated(patch: Patch, way: Array, near: float) -> Found:
    curve = circular(patch.point(FRACTIONS, np.zeros(len(FRACTIONS))), near)
    length = float(np.linalg.norm(way))
    if curve is None or np.linalg.norm(np.cross(curve.axis, way)) > SAME * length:
        return Extrusion(way=way)
    up = float(np.sign(curve.axis @ way))
    axes = np.stack([curve.x, np.cross(curve.axis, curve.x), curve.axis], axis=1)
    return Natural(
        surface=Cylinder(frame=Frame(axes=axes, origin=curve.centre), radius=curve.radius),
        origin=np.zeros(2),
        along_u=np.array([curve.sweep, 0.0]),
        along_v=np.array([0.0, up * length]),
    )


def _coaxial(local: Array, frame: Frame, near: float) -> Round | None:
    """The cylinder or cone about the motion's axis that has all points (n, 3), given in its frame."""
    rho, z = np.hypot(local[:, 0], local[:, 1]), local[:, 2]
    if np.ptp(rho) <= near and rho.min() > near:
        return Cylinder(frame=frame, radius=float(rho.mean()))
    if np.ptp(rho) <= near or np.ptp(z) <= near:
        return None
    low, high = int(np.argmin(rho)), int(np.argmax(rho))
    slope = (z[high] - z[low]) / (rho[high] - rho[low])
    steep = abs(slope) * np.ptp(rho) <= near or abs(slope) > 1.0 / _LEAST_SLOPE
    if steep or np.max(np.abs(z - z[low] - slope * (rho - rho[low]))) > near * np.hypot(1.0, slope):
        return None
    return cone_through(frame, (float(rho[low]), float(z[low])), (float(rho[high]), float(z[high])))

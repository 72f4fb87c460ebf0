"""Faces before they are made: surfaces, and the parts of edges around them with their curves on the surface.

One template stands for all images of a patch: what turns the surface turns the edges, and their curves in the surface's
parameters stay what they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np

from ....arrays import Array
from ....boundary.faces import Cap, Patch
from ....boundary.triangulation import signed_area
from ....surfaces.cone import Cone as ConeCap
from ....surfaces.placed import PlacedSurface
from ....surfaces.plane import Plane
from ....surfaces.sphere import Sphere as SphereCap
from .approximation import Approximation
from .edges import Edges
from .faces import line_on_surface
from .loops import around, side, sides
from .recognition import Natural
from .rounds import Layout, Ref, SurfaceCurve, Track, layout, move_between, on_surface, sphere_for
from .surfaces import Cone, Cylinder, Extruded, Flat, Frame, Geometry, Round, Sphere, Spline, Turned

_LOOP_SAMPLES = 32
_CURVES = 0.1
"""Of the tolerance: how far curves in the parameters of surfaces may be from the edges they stand for."""

_CHECKS = np.linspace(0.0, 1.0, 33)
_MARGIN = 2.0  # curves may be farther apart between the checks


class Part(NamedTuple):
    """A part of an edge in a loop.

    curve      in the surface's parameters, by the parameter of the edge; None on planes, which need none
    deviation  how far (length) it is from the edge, in space
    """

    ref: Ref
    curve: Any | None = None
    deviation: float = 0.0


class _Charted(NamedTuple):
    """A part of an edge with its curve on a surface, and how far (length) that may be from it."""

    track: Track
    curve: SurfaceCurve
    deviation: float


class Template(Protocol):
    """A face of which all images of a patch are placed copies."""

    @property
    def surface(self) -> Geometry:
        """What it lies on."""

    @property
    def outward(self) -> bool:
        """Whether the surface's own normal, ∂U × ∂V, points out of the body."""

    @property
    def refs(self) -> Sequence[Ref]:
        """What may be parts of edges, because the face must meet itself at their ends."""

    def loops(self, edges: Edges) -> list[list[Part]]:
        """Counter-clockwise seen from outside."""


@dataclass(frozen=True, kw_only=True, eq=False)
class OnPlane:
    """A face on a plane."""

    surface: Flat
    around: Sequence[Sequence[Ref]]
    outward: bool
    refs: Sequence[Ref] = ()

    def loops(self, edges: Edges) -> list[list[Part]]:
        del edges
        return [[Part(ref) for ref in loop] for loop in self.around]


@dataclass(frozen=True, kw_only=True, eq=False)
class OnRound:
    """A face on a cylinder, a cone or a sphere with edges that run anyhow."""

    layout: Layout
    outward: bool
    tolerance: float

    @property
    def surface(self) -> Round:
        return self.layout.surface

    def loops(self, edges: Edges) -> list[list[Part]]:
        known: dict[Ref, _Charted] = {}
        return [[self._part(track, edges, known) for track in loop.tracks] for loop in self.layout.loops]

    @property
    def refs(self) -> list[Ref]:
        return [track.ref for loop in self.layout.loops for track in loop.tracks]

    def _part(self, track: Track, edges: Edges, known: dict[Ref, _Charted]) -> Part:
        """About the surface's own axis, images of an edge only move along U."""
        ref = track.ref
        first = ref._replace(image=0)
        move = move_between(known[first].track, track) if first in known else None
        if move is None:
            move, curve = 0.0, on_surface(self.surface, track, _CURVES * self.tolerance)
            known[first] = _Charted(track, curve, _MARGIN * (curve.error + self._distance(track, edges)))
        course, found = edges.course(ref.edge), known[first]
        return Part(ref, found.curve.moved(move).made(course.at(ref.first), course.at(ref.last)), found.deviation)

    def _distance(self, track: Track, edges: Edges) -> float:
        """How far the edge as it is written is from the surface."""
        ref = track.ref
        fractions = ref.first + _CHECKS * (ref.last - ref.first)
        foot = self.surface.point(track.parameters(self.surface, fractions))
        return float(np.max(np.linalg.norm(foot - edges.points(ref.edge, ref.image, fractions), axis=-1)))


@dataclass(frozen=True, kw_only=True, eq=False)
class OnParameters:
    """A face on a surface whose parameters are the patch's fractions but for their scale."""

    patch: Patch
    natural: Natural
    refs: Sequence[Ref] = ()

    @property
    def surface(self) -> Geometry:
        return self.natural.surface

    @property
    def outward(self) -> bool:
        return self.natural.outward

    def loops(self, edges: Edges) -> list[list[Part]]:
        return [[self._part(number, edges) for number in range(4)]]

    def _part(self, number: int, edges: Edges) -> Part:
        use = self.patch.sides[number]
        start, end = self._parameters(number, np.array([0.0, 1.0]))
        if use.edge.degenerate:
            return Part(side(use), line_on_surface(0.0, 1.0, start, end))
        course = edges.course(use.edge)
        curve = line_on_surface(course.first, course.at(1.0), start, end)
        return Part(side(use), curve, self._deviation(number, edges))

    def _deviation(self, number: int, edges: Edges) -> float:
        """Nought where the edge is a spline in the bases of its faces, or both are elementary."""
        use = self.patch.sides[number]
        if isinstance(self.surface, Spline | Extruded | Turned) != edges.is_elementary(use.edge):
            return 0.0
        written = edges.points(use.edge, use.turn, _CHECKS)
        foot = self.surface.point(self._parameters(number, _CHECKS))
        return _MARGIN * float(np.max(np.linalg.norm(foot - written, axis=-1)))

    def _parameters(self, number: int, fractions: Array) -> Array:
        """(U, V) (n, 2) at fractions of a side's edge."""
        s = 1.0 - fractions if self.patch.sides[number].reverse else fractions
        nought, one = np.zeros_like(s), np.ones_like(s)
        u, v = ((s, nought), (one, s), (1.0 - s, one), (nought, 1.0 - s))[number]
        return self.natural.parameters(u, v)


def of_patch(patch: Patch, approximation: Approximation) -> Template:
    """Of a patch and all its images."""
    surface = approximation.faces[patch]
    if isinstance(surface, Natural):
        return OnParameters(patch=patch, natural=surface)
    if isinstance(surface, Flat):
        return OnPlane(surface=surface, around=sides(patch), outward=True)
    middle = np.array(0.5)
    point, normal = patch.point(middle, middle), patch.area_vector(middle, middle)
    outward = bool(normal @ _away(surface, point) > 0.0)
    return OnRound(layout=layout(surface, sides(patch)), outward=outward, tolerance=approximation.tolerance)


def of_cap(cap: Cap, tolerance: float) -> Template:
    """Of a cap, curves on it within a tolerance (length)."""
    chart = cap.surface.chart
    area = sum(signed_area(chart(loop.around(lambda _: _LOOP_SAMPLES))) for loop in cap.loops)
    loops = [around(loop) for loop in cap.loops]
    surface = _of_cap(cap)
    if isinstance(surface, Flat):
        return OnPlane(surface=surface, around=loops, outward=area > 0.0)
    if isinstance(surface, Sphere):
        surface = sphere_for(surface, loops)
    return OnRound(layout=layout(surface, loops), outward=area > 0.0, tolerance=tolerance)


def _away(surface: Round, point: Array) -> Array:
    """Away from the axis at a point: how ∂U × ∂V points, or nearly."""
    local = surface.frame.local(point)
    return np.asarray(surface.frame.axes @ (local * [1.0, 1.0, 0.0]))


def _of_cap(cap: Cap) -> Flat | Round:
    """The surface, with the normal of ours or, on a plane, with it as z."""
    surface, frame = cap.surface, Frame(axes=np.eye(3), origin=np.zeros(3))
    if isinstance(surface, PlacedSurface):
        frame = Frame(axes=surface.placement.matrix, origin=surface.placement.shift)
        surface = surface.surface
    match surface:
        case Plane(origin=origin, x_axis=x, y_axis=y):
            axes = np.stack([x, y, np.cross(x, y)], axis=1)
            return Flat(frame=Frame(axes=frame.axes @ axes, origin=frame.world(np.array(origin))))
        case SphereCap(radius=radius):
            return Sphere(frame=frame, radius=radius)
        case ConeCap(angle=angle, distance=distance):
            return _cone(frame, angle, distance)
        case _:
            raise NotImplementedError(f"end faces on a {type(surface).__name__}")


def _cone(frame: Frame, angle: float, distance: float) -> Cone | Cylinder:
    """ρ sin γ + z cos γ = R: widening downward, towards −z, with the half-angle π/2 − γ."""
    radius, height = distance * np.sin(angle), distance * np.cos(angle)
    if np.pi / 2.0 - angle <= _CYLINDER:
        return Cylinder(frame=frame, radius=float(radius))
    over = frame.shifted(float(height)).turned_over()
    return Cone(frame=over, radius=float(radius), half_angle=float(np.pi / 2.0 - angle))


_CYLINDER = 1e-10
"""Half-angle of a cone, radians, below which it is a cylinder."""

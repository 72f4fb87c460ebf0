"""The plane faces of a boundary, whichever way they were made: caps on planes, and patches that happen to be flat."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..arrays import Array
from ..surfaces.plane import Plane
from .boundary import Boundary
from .edge import Edge
from .faces import Cap, CapLoop, Patch
from .triangulation import signed_area

_SAMPLES = 16  # a curve, for its curvature and the rough outline of a face
_STRAIGHT = 1e-9  # of a patch's extent: how far off its plane a patch may be and still count as flat
_PARALLEL = 1e-8  # sine of the angle between its normals
_GRID = np.meshgrid(np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 9))


@dataclass(frozen=True, kw_only=True, eq=False)
class FlatFace:
    """A plane face: the cap or patch it is, its loops as those of a cap, its plane and outward normal (3,).

    loops     empty for a face of a patch with a pattern, whose images lie on planes of their own
    outline   (n, 3) points of it that show roughly where it is
    """

    face: Cap | Patch
    loops: tuple[CapLoop, ...]
    surface: Plane
    normal: Array
    outline: Array

    @property
    def name(self) -> str:
        return self.face.name


def flat_faces(boundary: Boundary) -> list[FlatFace]:
    """All plane faces, every image of a patch for itself."""
    caps = [_of_cap(cap, cap.surface) for cap in boundary.caps if isinstance(cap.surface, Plane)]
    return caps + [face for patch in boundary.patches for face in _of_patch(patch)]


def segments_for(sag: float) -> Callable[[Edge], int]:
    """How many steps of an edge's parameter keep its chords within a sag (length), estimated on a few samples."""

    def count(edge: Edge) -> int:
        points = edge.curve.point(edge.curve.parameter(np.linspace(0.0, 1.0, _SAMPLES + 1)))
        bend = float(np.max(np.linalg.norm(points[2:] - 2.0 * points[1:-1] + points[:-2], axis=1))) * _SAMPLES**2
        return max(int(np.ceil(np.sqrt(bend / (8.0 * sag)))), 6 if edge.closed else 1)

    return count


def _of_cap(cap: Cap, plane: Plane) -> FlatFace:
    outlines = [loop.around(lambda _: _SAMPLES) for loop in cap.loops]
    along = np.cross(plane.x_axis, plane.y_axis)
    area = sum(signed_area(plane.chart(outline)) for outline in outlines)
    return FlatFace(
        face=cap,
        loops=cap.loops,
        surface=plane,
        normal=along if area > 0.0 else -along,
        outline=np.concatenate(outlines),
    )


def _of_patch(patch: Patch) -> list[FlatFace]:
    u, v = (grid.ravel() for grid in _GRID)
    points, areas = patch.point(u, v), patch.area_vector(u, v)
    total = areas.sum(axis=0)
    normal = total / np.linalg.norm(total) if np.any(total) else np.array([0.0, 0.0, 1.0])
    extent = float(np.max(np.ptp(points, axis=0)))
    astray = np.linalg.norm(np.cross(areas, normal), axis=1)
    bent = np.any(astray > _PARALLEL * np.max(np.linalg.norm(areas, axis=1)))
    if bent or np.max(np.abs((points - points[0]) @ normal)) > _STRAIGHT * extent:
        return []
    if patch.pattern.order == 1 and not _loops(patch):
        return []
    along = points[int(np.argmax(np.linalg.norm(points - points[0], axis=1)))] - points[0]
    along -= normal * (along @ normal)
    along /= np.linalg.norm(along)
    return [
        FlatFace(
            face=patch,
            loops=_loops(patch) if patch.pattern.order == 1 else (),
            surface=_plane(turned.points(points[0]), turned.vectors(along), turned.vectors(normal)),
            normal=turned.vectors(normal),
            outline=turned.points(points),
        )
        for turned in (patch.pattern.image(k) for k in range(patch.pattern.order))
    ]


def _loops(patch: Patch) -> tuple[CapLoop, ...]:
    """The loops of a patch as those of a cap; none where it closes on itself across the motion."""
    first, right, second, left = patch.sides
    if right.edge is left.edge:
        return ()
    if first.edge is second.edge:
        return tuple(CapLoop(uses=(use,)) for use in (right, left) if not use.edge.degenerate)
    return (CapLoop(uses=tuple(use for use in patch.sides if not use.edge.degenerate)),)


def _plane(origin: Array, x_axis: Array, normal: Array) -> Plane:
    y_axis = np.cross(normal, x_axis)
    (ox, oy, oz), (xx, xy, xz), (yx, yy, yz) = (map(float, a) for a in (origin, x_axis, y_axis))
    return Plane(origin=(ox, oy, oz), x_axis=(xx, xy, xz), y_axis=(yx, yy, yz))

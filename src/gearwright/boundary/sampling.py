"""How finely each edge is cut, decided once for all faces that share it.

Opposite sides of a patch have the same number of segments, so that patches are grids; edges tied so
form a group. On a patch with n·r_uu = A, n·r_uv = B, n·r_vv = C (fractions u, v; n the unit normal),
linear interpolation over the triangles of a grid of n_u × n_v cells is off by at most

    (A/n_u² + C/n_v²)/8 + B/(4 n_u n_v),

the last term being the twist of the quads.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..arrays import Array
from ..curves.curve import in_panels
from ..errors import GeometryError, Problem
from .boundary import Boundary
from .edge import Edge
from .faces import Patch, alike, points_and_partials
from .groups import Groups

MOST_TRIANGLES = 20_000_000
_MOST_AROUND_CAPS = 400_000  # points around plane ends, whose triangles are some 14 times as many: gigabytes, minutes
"""Triangles of the patches beyond which a tolerance is taken for a slip."""
_LEAST_TOLERANCE = 1e-300
_FEWEST_CLOSED = 6  # segments of a closed edge, so that it still encloses something
_AT_ONCE = 50_000  # samples of patches evaluated together
_MARGIN = 1.1  # the bounds above are taken at sample points
_NEAR_END = 1.0 / 256.0  # curves that bend most at an end, as a trochoid does, are caught there; a cusp is not met
_DIFFERENCE = 1e-4  # step of the difference of analytic partials: its error is about 1e-8


@cache
def _sample_points(panels: tuple[float, ...]) -> tuple[tuple[Array, Array], slice, slice, slice]:
    """Fractions (u, v) inside a patch and on its borders along u and along v, and the slices of each."""
    along = np.concatenate([[_NEAR_END], (np.arange(16) + 0.5) / 16.0, [1.0 - _NEAR_END]])
    up = in_panels(panels, np.linspace(0.0625, 0.9375, 8))
    inside = np.stack(np.meshgrid(along, up), axis=-1).reshape(-1, 2)
    border_u = np.stack(np.meshgrid(along, [0.0, 1.0]), axis=-1).reshape(-1, 2)
    border_v = np.stack(np.meshgrid([0.0, 1.0], up), axis=-1).reshape(-1, 2)
    u, v = np.concatenate([inside, border_u, border_v]).T
    first, second = len(inside), len(inside) + len(border_u)
    return (u, v), slice(0, first), slice(first, second), slice(second, None)


@dataclass(frozen=True, kw_only=True)
class Sampling:
    """Segments of every edge, and the chord tolerance that the inner points of caps keep."""

    segments: Mapping[Edge, int]
    tolerance: float


def sampling(boundary: Boundary, tolerance: float) -> Sampling:
    """The coarsest sampling, about, whose chord error stays below the tolerance (length) everywhere.

    Raises GeometryError if the tolerance is not positive or would need more than MOST_TRIANGLES triangles.
    """
    if not _LEAST_TOLERANCE < tolerance < np.inf:
        raise GeometryError(
            "No polyhedron has this tolerance",
            [Problem(f"tolerance = {tolerance:g}", "a finite length greater than 0 is needed")],
        )
    tolerance = min(tolerance, _thinnest(boundary) / 4.0)  # beyond that opposite ends could cross
    groups = Groups(boundary)
    segments: dict[Edge, int] = {}
    for along in dict.fromkeys(groups.of(patch.sides[1].edge) for patch in boundary.patches):
        patches = [patch for patch in boundary.patches if groups.of(patch.sides[1].edge) is along]
        bounds = _Bounds.of(patches)
        layers = _best_layers(bounds, tolerance)
        segments[along] = max(segments.get(along, 1), layers)
        for patch, bound in zip(patches, bounds, strict=True):
            across = groups.of(patch.sides[0].edge)
            columns = float(bound.columns(layers, tolerance))
            cells = 2.0 * patch.pattern.order * columns * layers
            if cells > MOST_TRIANGLES:
                around = len(boundary.caps) * patch.pattern.order * columns
                if layers == 1 and around / _MOST_AROUND_CAPS > cells / MOST_TRIANGLES:
                    raise _too_long_around(tolerance, around)
                raise too_fine(tolerance, cells / MOST_TRIANGLES, layers)
            segments[across] = max(segments.get(across, 1), int(columns))
    of_patches = {use.edge for patch in boundary.patches for use in patch.sides}
    for edge in boundary.edges:
        least = _FEWEST_CLOSED if edge.closed else 1
        alone = 1 if edge in of_patches else _segments_between_caps(edge, tolerance)
        segments[groups.of(edge)] = max(segments.get(groups.of(edge), 1), least, alone)
    found = {edge: segments[groups.of(edge)] for edge in boundary.edges}
    triangles = sum(
        2.0 * patch.pattern.order * found[patch.sides[0].edge] * found[patch.sides[1].edge]
        for patch in boundary.patches
    )
    if triangles > MOST_TRIANGLES:
        raise too_fine(tolerance, triangles / MOST_TRIANGLES, max(found[p.sides[1].edge] for p in boundary.patches))
    around = sum(
        float(use.edge.pattern.order * found[use.edge])
        for cap in boundary.caps
        for loop in cap.loops
        for use in loop.uses
    )
    if around > _MOST_AROUND_CAPS:
        raise _too_long_around(tolerance, around)
    return Sampling(segments=found, tolerance=tolerance)


def _segments_between_caps(edge: Edge, tolerance: float) -> int:
    """Segments of an edge of no patch: one where it is straight, as on the axis of a revolution, more of a circle."""
    t = np.linspace(_NEAR_END, 1.0 - _NEAR_END, 16)
    a, b = edge.curve.interval
    rate, before, after = (
        edge.curve.derivative(edge.curve.parameter(t + step)) * (b - a) for step in (0.0, -_DIFFERENCE, _DIFFERENCE)
    )
    bend = _across(((after - before) / (2.0 * _DIFFERENCE))[None], rate[None])
    found = float(np.ceil(np.sqrt(_MARGIN * bend.max() / (8.0 * tolerance)) - 1e-9))
    if found > _MOST_AROUND_CAPS:
        raise _too_long_around(tolerance, found)
    return max(1, int(found))


def fixed_sampling(boundary: Boundary, across: int, layers: int, tolerance: float) -> Sampling:
    """So many segments along every section edge and so many layers along all others, for convergence studies.

    A closed edge counts as six, so that few segments still enclose something. An edge of no patch is one between two
    caps: a circle, or straight.
    """
    groups, section = Groups(boundary), section_edges(boundary)
    swept = {use.edge for patch in boundary.patches for use in patch.sides}
    whole = {groups.of(edge) for edge in swept if edge.closed}
    segments = {edge: _FEWEST_CLOSED * across if edge.closed else 1 for edge in boundary.edges}
    for edge in swept:
        turns = _FEWEST_CLOSED if groups.of(edge) in whole else 1
        segments[edge] = turns * (across if edge in section else layers)
    return Sampling(segments=segments, tolerance=tolerance)


def section_edges(boundary: Boundary) -> frozenset[Edge]:
    """The edges around the caps and those cut like them; where there are no caps, those along section curves.

    Raises GeometryError where a patch has nothing else, so that no layers lie between the caps.
    """
    groups = Groups(boundary)
    around = {groups.of(use.edge) for cap in boundary.caps for loop in cap.loops for use in loop.uses}
    around = around or {groups.of(patch.sides[0].edge) for patch in boundary.patches}
    found = frozenset(edge for edge in boundary.edges if groups.of(edge) in around)
    problems = [
        Problem(f"face {patch.name}", "its sides in both directions belong to end faces")
        for patch in boundary.patches
        if patch.sides[0].edge in found and patch.sides[1].edge in found
    ]
    if problems:
        raise GeometryError("Section and layers of this solid cannot be told apart", problems)
    return found


@dataclass(frozen=True)
class _Bounds:
    """Greatest second partials of a patch: normal ones inside, all across the tangent on its border edges."""

    uu: float
    uv: float
    vv: float
    border_u: float
    border_v: float

    @classmethod
    def of(cls, patches: Sequence[Patch]) -> list[_Bounds]:
        """Those of each of the patches."""
        return [bounds for run in alike(patches) for bounds in cls._of_alike(run)]

    @classmethod
    def _of_alike(cls, patches: Sequence[Patch]) -> list[_Bounds]:
        (u, v), inside, on_u, on_v = _sample_points(patches[0].panels)
        many = max(1, _AT_ONCE // len(u))
        if len(patches) > many:
            return cls._of_alike(patches[:many]) + cls._of_alike(patches[many:])
        _, du, dv = points_and_partials(patches, u, v)
        normal = _unit(np.cross(du, dv))
        uu, uv, vv = _second_partials(patches, u, v)
        across_u, across_v = _across(uu, du), _across(vv, dv)
        greatest = [
            *(np.abs(np.sum(normal * second, axis=-1))[:, inside] for second in (uu, uv, vv)),
            across_u[:, on_u],
            across_v[:, on_v],
        ]
        return [cls(*row) for row in (_MARGIN * np.stack([g.max(axis=1) for g in greatest], axis=1)).tolist()]

    def columns(self, layers: Array | int, tolerance: float) -> Array:
        """Fewest segments n_u (...) across for n_v layers (...); infinite where these layers cannot do."""
        layers = np.asarray(layers, float)
        room = 8.0 * tolerance - self.vv / layers**2
        enough = (room > 0.0) & (self.border_v / layers**2 <= 8.0 * tolerance)
        room = np.where(enough, room, np.inf)
        twist = self.uv / layers
        inside = (twist + np.sqrt(twist**2 + self.uu * room)) / room  # 1/n_u, the root of A x² + 2 twist x = room
        border = np.sqrt(self.border_u / (8.0 * tolerance))
        return np.where(enough, np.maximum(1.0, np.ceil(np.maximum(inside, border) - 1e-9)), np.inf)


def _best_layers(bounds: list[_Bounds], tolerance: float) -> int:
    """The number of layers that needs the fewest cells in all patches that share it."""
    least = np.sqrt(max(max(b.vv, b.border_v) for b in bounds) / (8.0 * tolerance))
    candidates = np.unique(np.ceil(max(least, 1.0) * np.geomspace(1.0, 8.0, 40) + 1e-9 * least))
    cells = candidates * np.sum([b.columns(candidates, tolerance) for b in bounds], axis=0)
    return int(candidates[np.argmin(cells)])


def _second_partials(patches: Sequence[Patch], u: Array, v: Array) -> tuple[Array, Array, Array]:
    h = _DIFFERENCE
    u, v = np.clip(u, h, 1.0 - h), np.clip(v, h, 1.0 - h)  # a motion may not go beyond its ends
    _, u_after, v_after_u = points_and_partials(patches, u + h, v)
    _, u_before, v_before_u = points_and_partials(patches, u - h, v)
    _, _, v_after = points_and_partials(patches, u, v + h)
    _, _, v_before = points_and_partials(patches, u, v - h)
    return (
        (u_after - u_before) / (2.0 * h),
        (v_after_u - v_before_u) / (2.0 * h),
        (v_after - v_before) / (2.0 * h),
    )


def _across(second: Array, tangent: Array) -> Array:
    """Length (...) of the part of second partials (..., 3) across the tangents (..., 3)."""
    along = _unit(tangent)
    return np.linalg.norm(second - along * np.sum(second * along, axis=-1, keepdims=True), axis=-1)


def _unit(vectors: Array) -> Array:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)


def _thinnest(boundary: Boundary) -> float:
    """Length of the shortest way of a section point through the motion, about."""
    lengths = []
    for patch in boundary.patches:
        edge = patch.sides[1].edge
        if not edge.degenerate:
            points = edge.curve.point(edge.curve.parameter(edge.curve.fractions(8)))
            lengths.append(float(np.sum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
    return min(lengths, default=np.inf)


def _too_long_around(tolerance: float, points: float) -> GeometryError:
    """The refusal of a tolerance that would need so many points around end faces."""
    return too_fine(tolerance, points / _MOST_AROUND_CAPS, 1, f"{_MOST_AROUND_CAPS} points around end faces")


def too_fine(tolerance: float, excess: float, layers: int, many: str = f"{MOST_TRIANGLES} triangles") -> GeometryError:
    """The refusal of a tolerance that would need `excess` times too many triangles, or of what else are too many.

    Segments grow with the root of the inverse tolerance: in one direction where one layer does, else in two.
    """
    enough = 1.05 * tolerance * excess ** (2 if layers == 1 else 1)
    return GeometryError(
        "The tolerance asks for too fine a polyhedron",
        [
            Problem(
                f"tolerance = {tolerance:.3g}",
                f"more than {many}; try {enough:.2g}, and is it in the part's length unit?",
            )
        ],
    )

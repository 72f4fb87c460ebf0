"""Splines for what is not elementary in a boundary, all within one tolerance.

Edges that are opposite sides of patches share one basis, so that a patch is a tensor product, and patches that meet
along an edge have the same spline there: their poles come from the same points by the same rule.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ....arrays import Array
from ....boundary.boundary import Boundary
from ....boundary.edge import Edge
from ....boundary.faces import Patch
from ....boundary.groups import Groups
from ....errors import GeometryError, Problem
from .bases import Basis, coarsest
from .elementary import FRACTIONS, SAME, Circular, Straight, circular, straight
from .recognition import Extrusion, Found, Natural, Surface, Turning, recognised
from .surfaces import Extruded, Spline, Turned

_STATIONS = np.array([0.0, 0.21, 0.5, 0.79, 1.0])
"""Fractions across a patch at which its lines are sampled; no symmetry of a tooth hides what lies between."""

_SHARE = 0.25
"""Of the tolerance, that lines of a patch may use up; the product of two interpolations has the sum of their errors."""

_MOST_SPANS = 4000
"""Spans of a curve beyond which a tolerance is taken for a slip: gigabytes of poles."""

_NARROWEST = 1e-9
"""Of a curve: spans become so short only at a jump that nobody named."""

_STEP, _JUMP = 1e-4, 1e-4
"""Of a curve's fractions, and of its speed: how derivatives at kinks are told."""

_FINEST = 8.0
"""Least tolerance, in SAME × size: below that the points themselves are not known."""

Sample = Callable[[Array], Array]
"""Points (k, n, 3) on k lines at fractions (n,)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Approximation:
    """A boundary in elementary surfaces, segments, circles and splines.

    faces       what each patch lies on
    edges       segments and circles; the others are splines in their bases
    tolerance   within which splines are of what they stand for
    """

    faces: Mapping[Patch, Surface]
    edges: Mapping[Edge, Straight | Circular]
    bases: Mapping[Edge, Basis]
    tolerance: float

    def poles(self, edge: Edge) -> Array:
        """Of the first image of an edge that is a spline."""
        return self.bases[edge].poles(edge.curve.point(edge.curve.parameter(self.bases[edge].nodes)))

    def points(self, edge: Edge, fractions: Array) -> Array:
        """Points (n, 3) of its first image as it is written."""
        if edge in self.edges:
            return edge.curve.point(edge.curve.parameter(fractions))
        return self.bases[edge].values(self.poles(edge), fractions)


def approximation(boundary: Boundary, tolerance: float) -> Approximation:
    """Of a boundary within a tolerance (length). Raises GeometryError, with what can be met, where it cannot be."""
    size = max(float(np.abs(edge.curve.start).max()) for edge in boundary.edges)
    least = _FINEST * SAME * size
    if tolerance < least:
        wanted = f"sixteen digits leave at least {least:.2g} for a body of this size"
        raise GeometryError("No smooth faces have this tolerance", [Problem(f"tolerance = {tolerance:.3g}", wanted)])
    found = {patch: recognised(patch) for patch in boundary.patches}
    edges = {edge: line for edge in boundary.edges if (line := _elementary(edge)) is not None}
    groups = Groups(boundary)
    samples = _samples(boundary, found, edges, groups)
    bases = {
        group: _fine_enough(group, _first(boundary, groups, group, own), own, tolerance)
        for group, own in samples.items()
    }
    for patch in (patch for patch, surface in found.items() if surface is None):
        _refine(patch, groups, bases, tolerance)
    own = {edge: bases[groups.of(edge)] for edge in boundary.edges if groups.of(edge) in bases}
    return Approximation(
        faces={patch: _surface(patch, surface, own) for patch, surface in found.items()},
        edges=edges,
        bases=own,
        tolerance=tolerance,
    )


def _refine(patch: Patch, groups: Groups, bases: dict[Edge, Basis], tolerance: float) -> None:
    """Makes the bases fine enough for the product of both."""
    across, up = (groups.of(patch.sides[k].edge) for k in (0, 1))
    while (errors := _product_errors(patch, bases[across], bases[up])).max() > tolerance:
        for group, axis in ((across, 1), (up, 0)):
            bases[group] = bases[group].finer(errors.max(axis=axis) > tolerance)
            _require_possible(bases[group], patch.name, tolerance)


def _surface(patch: Patch, found: Found | None, bases: Mapping[Edge, Basis]) -> Surface:
    across, up = (patch.sides[k].edge for k in (0, 1))
    match found:
        case None:
            spline = Spline(bases=(bases[across], bases[up]), poles=_poles(patch, bases[across], bases[up]))
            return Natural(surface=spline, origin=_ORIGIN, along_u=_U, along_v=_V)
        case Extrusion(way=way):
            length = float(np.linalg.norm(way))
            poles = _poles_at(patch, bases[across], 0.0)
            extruded = Extruded(basis=bases[across], poles=poles, direction=way / length)
            return Natural(surface=extruded, origin=_ORIGIN, along_u=_U, along_v=length * _V)
        case Turning(frame=frame, angle=angle):
            turned = Turned(basis=bases[across], poles=_poles_at(patch, bases[across], 1.0), frame=frame)
            return Natural(surface=turned, origin=angle * _U, along_u=_V, along_v=-angle * _U)
        case _:
            return found


_ORIGIN, _U, _V = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])


def _poles_at(patch: Patch, basis: Basis, v: float) -> Array:
    """Of the patch's curve at one fraction of the motion."""
    return basis.poles(patch.point(basis.nodes, np.full_like(basis.nodes, v)))


def _elementary(edge: Edge) -> Straight | Circular | None:
    if edge.degenerate:
        return None
    points = edge.curve.point(edge.curve.parameter(FRACTIONS))
    near = SAME * float(np.abs(points).max())
    return straight(points, near) or circular(points, near)


def _samples(
    boundary: Boundary,
    found: Mapping[Patch, Found | None],
    edges: Mapping[Edge, Straight | Circular],
    groups: Groups,
) -> dict[Edge, list[Sample]]:
    """What each group's basis must hold."""
    samples: dict[Edge, list[Sample]] = {}
    for edge in boundary.edges:
        if edge not in edges and not edge.degenerate:
            samples.setdefault(groups.of(edge), []).append(_along_edge(edge))
    for patch, surface in found.items():
        across, up = (groups.of(patch.sides[k].edge) for k in (0, 1))
        if surface is None:
            samples.setdefault(across, []).append(_along(patch))
            samples.setdefault(up, []).append(_along_motion(patch))
        elif isinstance(surface, Extrusion | Turning):
            samples.setdefault(across, []).append(_along(patch))
    return samples


def _along_edge(edge: Edge) -> Sample:
    return lambda fractions: edge.curve.point(edge.curve.parameter(fractions))[None]


def _along(patch: Patch) -> Sample:
    return lambda fractions: patch.point(*np.broadcast_arrays(fractions, _STATIONS[:, None]))


def _along_motion(patch: Patch) -> Sample:
    return lambda fractions: patch.point(*np.broadcast_arrays(_STATIONS[:, None], fractions))


def _first(boundary: Boundary, groups: Groups, group: Edge, samples: Sequence[Sample]) -> Basis:
    """The coarsest basis of a group: with the fractions at which anything in it is not analytic."""
    found: set[float] = set()
    both_ways = False
    for patch in boundary.patches:
        for k, panels in ((0, patch.curve.panels), (1, patch.panels)):
            if groups.of(patch.sides[k].edge) is group:
                found |= set(panels)
                both_ways |= patch.sides[k].reverse or not patch.sides[k + 2].reverse
    for edge in boundary.edges:
        if groups.of(edge) is group:
            found |= set(edge.curve.panels)
    mirrored = {1.0 - fraction for fraction in found} if both_ways else set()
    merged = np.array(sorted(found | mirrored))
    panels = tuple(merged[np.diff(merged, prepend=0.0) > SAME].tolist()) if merged.size else ()
    return coarsest(panels, _kinks(panels, samples), mirrored=both_ways)


def _kinks(panels: tuple[float, ...], samples: Sequence[Sample]) -> tuple[float, ...]:
    """The panels' ends at which a derivative jumps, as that of a Frenet frame does where a path's third one jumps."""
    if not panels:
        return ()
    at = np.array(panels)
    jumps = np.zeros(len(at))
    for sample in samples:
        points = sample((at[:, None] + _STEP * np.arange(-2.0, 3.0)).ravel()).reshape(-1, len(at), 5, 3)
        # one-sided differences of second order
        before = np.einsum("klmi,m->kli", points[:, :, :3], [1.0, -4.0, 3.0])
        after = np.einsum("klmi,m->kli", points[:, :, 2:], [-3.0, 4.0, -1.0])
        size = np.linalg.norm(before, axis=-1).max()
        jumps = np.maximum(jumps, np.linalg.norm(after - before, axis=-1).max(axis=0) / size)
    return tuple(at[jumps > _JUMP].tolist())


def _fine_enough(group: Edge, basis: Basis, samples: Sequence[Sample], tolerance: float) -> Basis:
    wanted = _SHARE * tolerance
    while (errors := np.max([_errors(basis, sample) for sample in samples], axis=0)).max() > wanted:
        basis = basis.finer(errors > wanted)
        _require_possible(basis, group.name, tolerance)
    return basis


def _errors(basis: Basis, sample: Sample) -> Array:
    """How far (k,) interpolants are off at the checks, the worst of the lines."""
    found = basis.values(basis.poles(sample(basis.nodes), axis=1), basis.checks, axis=1)
    return np.linalg.norm(found - sample(basis.checks), axis=-1).max(axis=0)


def _require_possible(basis: Basis, name: str, tolerance: float) -> None:
    if basis.spans > _MOST_SPANS or basis.narrowest < _NARROWEST:
        problem = f"{name} would need {basis.spans} polynomials and more, one after another; take a greater tolerance"
        raise GeometryError("No smooth faces have this tolerance", [Problem(f"tolerance = {tolerance:.3g}", problem)])


def _poles(patch: Patch, across: Basis, up: Basis) -> Array:
    """Poles (n, m, 3) of the tensor product that has the patch's points at the nodes."""
    return up.poles(across.poles(_grid(patch, across.nodes, up.nodes)), axis=1)


def _product_errors(patch: Patch, across: Basis, up: Basis) -> Array:
    """How far (k, l) it is off, between the nodes."""
    found = up.values(across.values(_poles(patch, across, up), across.checks), up.checks, axis=1)
    return np.linalg.norm(found - _grid(patch, across.checks, up.checks), axis=-1)


def _grid(patch: Patch, u: Array, v: Array) -> Array:
    return patch.point(*np.meshgrid(u, v, indexing="ij"))
